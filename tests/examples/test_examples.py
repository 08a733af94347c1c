"""Every example runs, in another process with warnings as errors, and shows what it says."""

import os
import re
import runpy
import subprocess
import sys
from contextlib import nullcontext
from pathlib import Path
from types import ModuleType

import matplotlib.pyplot as plt
import pytest

import divbandit as db

EXAMPLES = Path(__file__).parents[2] / "examples"
COVERS = re.compile(r"^(.*?) +covers (\d\.\d\d)", re.MULTILINE)


@pytest.fixture
def run(tmp_path):
    """Return a function that runs an example by name and returns what it prints.

    Words in it may be replaced by others, so that it takes less time. Nothing is to be on standard
    error but what `shows` matches.
    """

    def run(name, *arguments, shows="", **replaced):
        text = (EXAMPLES / f"{name}.py").read_text(encoding="utf-8")
        for old, new in replaced.items():
            assert text.count(old) == 1
            text = text.replace(old, new)
        (tmp_path / f"{name}.py").write_text(text, encoding="utf-8")
        done = subprocess.run(  # noqa: S603
            [sys.executable, "-W", "error", tmp_path / f"{name}.py", *arguments],
            capture_output=True,
            text=True,
            check=False,
            cwd=tmp_path,
            env={**os.environ, "TMPDIR": str(tmp_path)},
        )
        assert (done.returncode, re.sub(shows, "", done.stderr)) == (0, "")
        return done.stdout

    return run


def covered(text):
    """Return what each line says to be covered."""
    return {name: float(area) for name, area in COVERS.findall(text)}


def numbers(text):
    return [int(number) for number in re.findall(r"\d+", text)]


def test_my_own(run):
    text = run("my_own")
    areas = covered(text)
    assert list(areas) == ["motor babbling", "goals", "farther", "ADAPT"]
    assert areas["ADAPT"] > 0.9 * max(areas.values())
    chosen = numbers(text.splitlines()[-1])
    assert sum(chosen) == 1000
    assert min(chosen) > 100


def test_my_own_is_short():
    assert len((EXAMPLES / "my_own.py").read_text().splitlines()) <= 40


def test_pyribs_emitters(run):
    text = run("pyribs_emitters")
    lines, evolution, small, adapt = covered(text).values()
    assert small < lines
    assert small < evolution
    assert adapt > 0.8 * max(lines, evolution)
    shares = numbers(" ".join(re.findall(r"\d+%", text)))
    assert 98 <= sum(shares) <= 102
    assert shares[2] == min(shares)


def test_ribs_scheduler(run):
    text = run("ribs_scheduler")
    assert list(covered(text)) == ["UCB1, of pyribs", "ADAPT"]
    theirs, ours = covered(text).values()
    assert ours > 0.9 * theirs > 0.1
    small, *large = numbers(text.splitlines()[-1])
    assert small + sum(large) == 300
    assert small < min(large)


def test_ribs_scheduler_is_short():
    assert len((EXAMPLES / "ribs_scheduler.py").read_text().splitlines()) <= 40


def test_optuna_samplers(run):
    text = run("optuna_samplers")
    assert list(covered(text)) == ["random", "CMA-ES", "TPE", "TPE, to the right", "ADAPT"]
    right = [float(x) for x in re.findall(r"x = (-?\d\.\d\d)", text)]
    assert max(right) == right[3] > 0.7
    assert covered(text)["ADAPT"] > covered(text)["TPE, to the right"]


def test_mabwiser_policy(run):
    text = run("mabwiser_policy")
    assert list(covered(text)) == ["epsilon-greedy", "UCB1", "Thompson", "ADAPT"]
    motor_babbling_alone = 0.55  # square metres; the most of twenty seeds, rounded up
    assert min(covered(text).values()) > motor_babbling_alone
    for line in text.splitlines():
        shares = numbers(" ".join(re.findall(r"\d+%", line)))
        assert len(shares) == 4
        assert 98 <= sum(shares) <= 102
        assert shares[2] == max(shares)


def test_ask_tell_robot(run):
    loaded, covers, fell = run("ask_tell_robot").splitlines()
    effects, under_way = numbers(loaded)
    assert 40 <= effects <= 59
    assert under_way == 1
    falls = numbers(fell)[0]
    assert numbers(covers)[0] + falls == numbers(fell)[1] == 300
    assert falls > 0


def test_program(run):
    first, last = run("program").splitlines()
    effects, area = re.match(r"(\d+) effects cover (\d+\.\d\d)$", first).groups()
    failed = re.match(
        r"(\d+) failed, the last with RuntimeError: .* status 1: the motor is too hot$", last
    )
    assert int(effects) + int(failed[1]) == 200
    assert 0 < int(failed[1]) < 40
    assert 4.0 < float(area) < 36.0  # the whole box of goals has 36


def test_gray_scott(run, tmp_path):
    bar = r"\s*\d+(%\|| trials).*\n"
    first = run("gray_scott", "20", "16", "50", shows=bar)
    assert re.match(r"20 evaluations, .*distinct effects\nstrategy +use", first)
    picture = tmp_path / "gray_scott.png"
    assert len(plt.imread(picture)) > 500
    picture.unlink()
    second = run("gray_scott", "25", "16", "50", shows=bar)
    assert second.startswith("25 evaluations")  # it has gone on
    assert run("gray_scott", "25", "16", "50", shows=bar) == second  # there is nothing to do
    assert picture.exists()


def test_gray_scott_is_short():
    assert len((EXAMPLES / "gray_scott.py").read_text().splitlines()) <= 40


def test_dask_cluster(run):
    first, *tries = run("dask_cluster").splitlines()
    effects, area = re.match(r"(\d+) effects cover (\d\.\d\d) m2", first).groups()
    assert int(effects) == 200
    assert 0.5 < float(area) < 3.14
    assert len(tries) == 2
    assert sum(numbers(line)[1] for line in tries) == 200


def test_mujoco_pusher(run):
    lines = run("mujoco_pusher", **{"n=300": "n=100"}).splitlines()
    assert len(lines) == 3
    for line in lines:
        area, pushed, tries, far = numbers(line.partition("covers")[2].replace("cm2", ""))
        assert area > 3
        assert 0 < pushed < tries == 100
        assert far > 1


def test_mujoco_reacher(run):
    *lines, _ = run("mujoco_reacher").splitlines()
    covers = [numbers(line.partition("covers")[2].replace("cm2", ""))[0] for line in lines]
    assert len(covers) == 4
    assert min(covers) > 100
    assert covers[3] > 0.8 * max(covers)


@pytest.fixture
def logs(monkeypatch, capsys):
    """Return a function that runs an example with a stand-in for its library, and what it logs.

    Every seventh evaluation fails. What is logged are triples (name, value, evaluations).
    """

    def logs(name, stand_in):
        library, logged = stand_in([])
        monkeypatch.setitem(sys.modules, library.__name__, library)
        monkeypatch.setattr(db, "explore", with_failures(db.explore))
        runpy.run_path(str(EXAMPLES / f"{name}.py"))
        assert re.fullmatch(
            r"0\.\d\d\d square metres after 429 evaluations\n", capsys.readouterr().out
        )
        return logged

    return logs


def with_failures(explore):
    """Return what explores like this, with failures."""

    def explore_flaky(environment, strategy, n, **options):
        tried = iter(range(n))

        def falls(command):
            if next(tried) % 7 == 6:
                raise ValueError("it fell")
            return environment(command)

        spaces = environment.motor_space, environment.sensory_space
        flaky = db.FunctionEnvironment(falls, *spaces)
        return explore(flaky, strategy, n, on_error="record", **options)

    return explore_flaky


def tensorboard(logged):
    """Return tensorboardX, as far as the example uses it, and the list that it logs to."""

    class SummaryWriter:
        def __init__(self, folder):
            assert folder == "runs/adapt"

        def __enter__(self):
            return self

        def __exit__(self, *_):
            pass

        def add_scalar(self, name, value, step):
            logged.append((name, value, step))

    library = ModuleType("tensorboardX")
    library.SummaryWriter = SummaryWriter
    return library, logged


def mlflow(logged):
    """Return MLflow, as far as the example uses it, and the list that it logs to."""
    library = ModuleType("mlflow")
    library.start_run = lambda **_: nullcontext()
    library.log_param = lambda name, value: logged.append((name, value, 0))
    library.log_metrics = lambda metrics, step: logged.extend(
        (name, value, step) for name, value in metrics.items()
    )
    return library, logged


def check_log(logged):
    """Check what an example logs every ten evaluations."""
    of = {name: [] for name, *_ in logged}
    for name, value, step in logged:
        assert step == 10 * len(of[name]) + 10
        of[name].append(value)
    assert list(of) == ["diversity", "failures", "share/motor babbling", "share/goal babbling"]
    assert {len(values) for values in of.values()} == {50}
    assert of["diversity"] == sorted(of["diversity"])
    assert 0.05 < of["diversity"][-1] < 1
    assert of["failures"] == [step // 7 for step in range(10, 501, 10)]
    assert [sum(shares) for shares in zip(*list(of.values())[2:], strict=True)] == [1.0] * 50
    assert min(map(min, list(of.values())[2:])) > 0


def test_tensorboard_log(logs):
    check_log(logs("tensorboard_log", tensorboard))


def test_mlflow_log(logs):
    (name, value, _), *metrics = logs("mlflow_log", mlflow)
    assert (name, value.partition("(")[0]) == ("strategy", "Adapt")
    check_log(metrics)


def test_no_example_is_forgotten():
    names = {path.stem for path in EXAMPLES.glob("*.py")}
    assert names == {name.removeprefix("test_") for name in globals()} & names
