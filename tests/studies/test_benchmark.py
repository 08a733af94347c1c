"""The benchmark leaves its files, goes on where it was stopped, and repeats its numbers."""

import csv

import numpy as np
import pytest

import divbandit as db
from divbandit.cli import main
from divbandit.studies.benchmark import benchmark
from divbandit.studies.benchmark.contenders import CONTENDERS, explored
from divbandit.studies.benchmark.peers import PEERS, explored_by
from divbandit.studies.benchmark.problems import PROBLEMS

SMALL = {"budget": 100, "repetitions": 2, "jobs": 1}


def rows_of(folder):
    with (folder / "benchmark.csv").open(encoding="utf-8") as file:
        return list(csv.DictReader(file))


def without_times(rows):
    return [{key: row[key] for key in row if key != "seconds"} for row in rows]


@pytest.fixture(scope="module")
def made(tmp_path_factory):
    folder = tmp_path_factory.mktemp("benchmark")
    return folder, benchmark(["arm 20"], out=folder, **SMALL)


def test_it_leaves_its_files(made):
    folder, text = made
    assert {path.name for path in folder.iterdir()} == {
        "benchmark.csv",
        "benchmark_arm_20.png",
        "benchmark_arm_20.svg",
    }
    rows = rows_of(folder)
    assert len(rows) == 2 * len(CONTENDERS) * 6
    assert {int(row["evaluations"]) for row in rows} == {2, 5, 10, 20, 50, 100}
    assert all(0 < float(row["coverage"]) <= 100 * np.pi * 0.02**2 for row in rows)
    assert all(0 < float(row["cells"]) <= 0.01 for row in rows)
    assert [line.split("  ")[1] for line in text.splitlines()[1:]] == list(CONTENDERS)


def test_what_is_there_is_not_made_again(made, tmp_path):
    folder, _ = made
    whole = (folder / "benchmark.csv").read_text(encoding="utf-8")
    lines = whole.splitlines(keepends=True)
    # Killed in the middle of a line: the exploration that it belongs to is made again.
    (tmp_path / "benchmark.csv").write_text("".join(lines[:40]) + lines[40][:20], encoding="utf-8")
    benchmark(["arm 20"], out=tmp_path, **SMALL)
    again = rows_of(tmp_path)
    assert without_times(again) == without_times(rows_of(folder))
    assert [row["seconds"] for row in again[:36]] == [
        row["seconds"] for row in rows_of(folder)[:36]
    ]
    benchmark(["arm 20"], out=tmp_path, **{**SMALL, "repetitions": 3})
    assert len(rows_of(tmp_path)) == 3 * len(CONTENDERS) * 6


def test_two_processes_reach_the_same(made, tmp_path):
    benchmark(["arm 20"], out=tmp_path, **{**SMALL, "jobs": 2})
    key = str
    found = sorted(without_times(rows_of(tmp_path)), key=key)
    assert found == sorted(without_times(rows_of(made[0])), key=key)


@pytest.mark.parametrize("problem", PROBLEMS, ids=lambda problem: problem.name)
def test_the_default_explores_every_problem(problem):
    rng = np.random.SeedSequence(0)
    effects, seconds = explored(CONTENDERS[0], problem, problem.make(), [5, 20], rng)
    assert effects.shape == (20, 2)
    assert 0 < seconds[0] < seconds[1]
    assert np.isfinite(effects).all()


@pytest.mark.parametrize("name", PEERS)
def test_peers_make_as_many_evaluations_and_depend_on_the_seed(name):
    def effects(seed):
        rng, arm = np.random.SeedSequence(seed), db.PlanarArm(4)
        return explored_by(name, arm, [300, 700], rng, tau=0.05, sigma=0.1)[0]

    first = effects(0)
    assert first.shape == (700, 2)
    assert first.tolist() == effects(0).tolist()
    assert first.tolist() != effects(1).tolist()


def test_peers_need_a_sensory_space():
    arm = db.PlanarArm(3)
    box = db.FunctionEnvironment(arm, arm.motor_space)
    with pytest.raises(ValueError, match="environment must have a sensory space"):
        explored_by("CMA-ME", box, [50], np.random.SeedSequence(0), tau=0.1, sigma=0.1)


def test_bad_arguments_are_named_and_nothing_is_written(tmp_path, capsys):
    out = tmp_path / "new"
    for arguments, named in (({"names": ["arm"]}, r"names\[0\]"), ({"budget": 3}, "budget")):
        with pytest.raises(ValueError, match=named):
            benchmark(out=out, **arguments)
    assert not out.exists()
    assert main(["benchmark", "arm", "--out", str(out)]) == 1
    assert "names[0] must be one of" in capsys.readouterr().err
    out.mkdir()
    (out / "benchmark.csv").write_text("a,b\n", encoding="utf-8")
    with pytest.raises(ValueError, match="out must hold a table of this benchmark"):
        benchmark(["arm 20"], out=out)


def test_the_command_line(tmp_path, capsys):
    words = ["--budget", "60", "--repetitions", "1", "--jobs", "1", "--out", str(tmp_path)]
    assert main(["benchmark", "arm 20", *words]) == 0
    assert "arm 20, 60 evaluations" in capsys.readouterr().out
