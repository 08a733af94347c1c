"""``divbandit reproduce`` leaves the files that it promises, and says what is wrong."""

import pytest

from divbandit.cli import main


def test_it_makes_every_file(tmp_path, capsys):
    assert main(["reproduce", "--repetitions", "1", "--out", str(tmp_path / "new" / "folder")]) == 0
    names = {path.name for path in (tmp_path / "new" / "folder").iterdir()}
    figures = {f"figure{k}.{kind}" for k in (1, 2, 3, 4) for kind in ("png", "svg")}
    assert names == figures | {"figure4.csv", "figure4_comparison.csv"}
    printed = capsys.readouterr()
    assert "beyond 2 standard errors" in printed.out
    assert "figure 4" in printed.err  # the progress bar


def test_the_same_seed_gives_the_same_bytes_with_any_number_of_jobs(tmp_path, capsys):
    for jobs in ("1", "2"):
        options = ["--jobs", jobs, "--seed", "3", "--out", str(tmp_path / jobs)]
        assert main(["reproduce", "1", "2", *options]) == 0
    files = sorted((tmp_path / "1").iterdir())
    assert len(files) == 4
    for file in files:
        assert file.read_bytes() == (tmp_path / "2" / file.name).read_bytes(), file.name
    capsys.readouterr()


@pytest.mark.parametrize(
    ("words", "named"),
    [
        (["reproduce", "5"], "FIGURE"),
        (["reproduce", "0"], "FIGURE"),
        (["reproduce", "one"], "FIGURE"),
        (["reproduce", "--repetitions", "0"], "--repetitions"),
        (["reproduce", "--repetitions", "2.5"], "--repetitions"),
        (["reproduce", "--seed", "-1"], "--seed"),
        (["reproduce", "--jobs", "0"], "--jobs"),
        (["reproduce", "--unknown"], "--unknown"),
        (["study"], "name"),
        (["study", "paint"], "paint"),
        (["study", "rules", "--repetitions", "0"], "--repetitions"),
        (["study", "rules", "--steps", "4"], "--steps"),
        (["study", "rules", "--steps", "many"], "--steps"),
        (["study", "rules", "--seed", "-1"], "--seed"),
        (["study", "rules", "--jobs", "0"], "--jobs"),
        (["study", "rules", "strategies"], "strategies"),
        (["paint"], "paint"),
        ([], "command"),
    ],
)
def test_wrong_words_are_named(words, named, capsys):
    assert main(words) == 2
    assert named in capsys.readouterr().err


def test_help_ends_well(capsys):
    assert main(["--help"]) == 0
    assert "reproduce" in capsys.readouterr().out


def test_a_folder_that_cannot_be_made_is_an_error(tmp_path, capsys):
    blocked = tmp_path / "file"
    blocked.write_text("in the way", encoding="utf-8")
    assert main(["reproduce", "1", "--out", str(blocked)]) == 1
    assert str(blocked) in capsys.readouterr().err
    assert blocked.read_text(encoding="utf-8") == "in the way"
