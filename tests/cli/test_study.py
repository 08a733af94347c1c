"""``divbandit study`` leaves the files that it promises, and says what is wrong."""

import csv

import pytest

from divbandit.cli import main
from divbandit.paper import setting
from divbandit.studies import composition, environments, rules, strategies
from divbandit.studies.study import STUDIES
from divbandit.studies.worlds import worlds

SMALL = ["--repetitions", "2", "--steps", "30"]


@pytest.fixture(scope="module")
def made(tmp_path_factory):
    """Make every study in small, with one process."""
    folder = tmp_path_factory.mktemp("studies") / "new"
    for name in STUDIES:
        assert main(["study", name, *SMALL, "--jobs", "1", "--out", str(folder)]) == 0
    return folder


def test_every_study_leaves_its_files(made):
    names = {path.name for path in made.iterdir()}
    one = set(STUDIES) - {"environments"}
    drawn = one | {f"environments_{world.name.replace(' ', '_').lower()}" for world in worlds()}
    figures = {f"{stem}.{kind}" for stem in drawn for kind in ("png", "svg")}
    assert names == figures | {f"{name}.csv" for name in STUDIES}


@pytest.mark.parametrize(
    ("name", "count"),
    [
        ("rules", 2 * len(rules.cases(200))),
        ("strategies", 2 * len(strategies.cases(200))),
        ("composition", 2 * len(composition.cases(200))),
        ("environments", 2 * len(environments.cases(200))),
    ],
)
def test_the_table_of_numbers_has_every_exploration(made, name, count):
    with (made / f"{name}.csv").open(encoding="utf-8") as file:
        rows = list(csv.DictReader(file))
    assert len(rows) == count
    taus = {"linear projection, 20": 0.512}
    for row in rows:
        tau = taus.get(row.get("place"), setting.TAU)
        assert 0 < float(row["coverage"]) < 30 * 3.15 * tau**2


@pytest.mark.parametrize("name", STUDIES)
def test_two_processes_leave_the_same_bytes(made, name, tmp_path, capsys):
    assert main(["study", name, *SMALL, "--jobs", "2", "--out", str(tmp_path)]) == 0
    for file in tmp_path.iterdir():
        assert file.read_bytes() == (made / file.name).read_bytes(), file.name
    printed = capsys.readouterr()
    assert "ADAPT" in printed.out
    assert name in printed.err  # the progress bar


def test_the_seed_changes_the_numbers(made, tmp_path, capsys):
    words = ["study", "composition", *SMALL, "--jobs", "1", "--seed", "1", "--out", str(tmp_path)]
    assert main(words) == 0
    name = "composition.csv"
    assert (tmp_path / name).read_bytes() != (made / name).read_bytes()
    capsys.readouterr()
