"""Progress: what it shows, how often, and that nothing of it is left running."""

import gc
import re
import sys
import threading
from types import SimpleNamespace

import pytest

import divbandit as db
from divbandit.bandits import Gain
from divbandit.callbacks import Every, Progress, diversity, progress
from tests.callbacks.scripts import Total, explorer, scripted


def last(capsys):
    """Return the last state of the bar."""
    out, err = capsys.readouterr()
    assert out == ""
    return err.rpartition("\r")[2].rstrip()


def test_it_shows_evaluations_failures_and_time(capsys):
    explorer().run(scripted([1, None, 2]), 3, on_error="record", callbacks=[Progress()])
    assert re.fullmatch(r"100%\|█+\| 3/3 \[00:00<00:00, .* trials/s, 1 failed\]", last(capsys))


def test_it_shows_the_time_left_while_there_is_some(capsys):
    def stop(explorer, trial):
        del explorer
        return trial.number == 2

    explorer().run(scripted([1] * 9), 9, callbacks=[Every(1, Progress()), stop])
    states = capsys.readouterr().err.split("\r")
    assert any(re.search(r"22%\|█.*\| 2/9 \[00:00<00:00", state) for state in states)
    assert re.search(r"33%\|█.*\| 3/9 \[", states[-1])


def test_it_shows_what_the_bandit_is_rewarded_by(capsys):
    arm, adapt = db.PlanarArm(3), db.Adapt([db.MotorBabbling()], tau=0.1)
    made = db.explore(arm, adapt, 50, rng=0, callbacks=[Progress()])
    assert f", 0 failed, coverage {made.coverage(0.1)[-1]:.4g}]" in last(capsys)
    by_total = db.Adapt([db.MotorBabbling()], reward=Gain(Total()))
    explorer(by_total).run(scripted([1, 2.5]), 2, callbacks=[Progress()])
    assert ", 0 failed, diversity 3.5]" in last(capsys)


@pytest.mark.parametrize(
    ("progress", "shown"),
    [(Progress(tau=0.5), "coverage 2.5"), (Progress(measure=Total()), "diversity 4")],
)
def test_it_shows_another_measure(capsys, progress, shown):
    explorer().run(scripted([1, 2.5, 0.5]), 3, callbacks=[progress])
    assert last(capsys).endswith(f", 0 failed, {shown}]")


def test_a_run_of_unknown_length(capsys):
    one = explorer()
    bar = Progress(tau=0.5).start(one, None)
    for effect in (1, 3):
        trial = one.ask()
        one.tell(trial, [effect])
        bar(one, trial)
    bar.close()
    assert re.fullmatch(r"2 trials \[00:00, .* trials/s, 0 failed, coverage 2\]", last(capsys))


def test_two_runs_have_each_a_bar_from_zero(capsys):
    one, progress = explorer(), Progress(measure=Total())
    one.run(scripted([1, None]), 2, on_error="record", callbacks=[progress])
    assert re.search(r" 2/2 .*, 1 failed, diversity 1\]", last(capsys))
    one.run(scripted([1, 1, None, 1]), 4, on_error="record", callbacks=[progress])
    assert re.search(r" 4/4 .*, 1 failed, diversity 4\]", last(capsys))


def test_a_run_that_ends_at_once(capsys):
    with pytest.raises(ValueError, match="it fell"):
        explorer().run(scripted([None]), 5, callbacks=[Progress(tau=1)])
    assert re.search(r"\| 0/5 \[.*, 0 failed, coverage 0\]", last(capsys))


def test_it_is_drawn_ten_times_a_second_at_most(capsys):
    assert Progress().every == "0.1s"
    explorer().run(scripted([1] * 100), 100, callbacks=[Progress()])
    assert capsys.readouterr().err.count("\r") < 100


def test_each_call_draws_once(capsys):
    show, box = Every(1, Progress()), scripted([1, None] * 10)
    explorer().run(box, 20, on_error="record", callbacks=[show])
    # Once when it begins, once for each call, once when it ends; a carriage return for each.
    assert capsys.readouterr().err.count("\r") == 22


def test_where_effects_come_faster_than_they_are_measured_it_says_of_how_many(monkeypatch, capsys):
    now = [0.0]
    monkeypatch.setattr(diversity, "monotonic", lambda: now[0])
    monkeypatch.setattr(progress, "_LAST_MEASURING", 0.01)

    class Slow(Total):
        def extend(self, effects):
            now[0] += 0.001 * len(effects)
            return super().extend(effects)

    one = explorer()
    for _ in range(100):
        one.tell(one.ask(), [1])
    bar = Progress(measure=Slow()).start(one, 100)
    assert now == [0]
    bar(one, None)
    assert now == [pytest.approx(0.015)]  # 1, 2, 4 and 8 effects
    bar.close()
    assert "diversity 30 of the first 30" in last(capsys)


def test_no_thread_is_left_and_none_is_started():
    before = threading.enumerate()
    bar = Progress().start(explorer(), 10)
    assert threading.enumerate() == before
    bar.close()


def test_a_measure_that_raises_leaves_no_bar_open():
    from tqdm import tqdm  # noqa: PLC0415

    class Broken(Total):
        def extend(self, effects):
            raise ArithmeticError(len(effects))

    with pytest.raises(ArithmeticError):
        explorer().run(scripted([1]), 1, callbacks=[Progress(measure=Broken())])
    assert not any(isinstance(each, tqdm) and not each.disable for each in gc.get_objects())


def test_without_tqdm_it_names_the_extra(monkeypatch):
    monkeypatch.delitem(sys.modules, "tqdm", raising=False)
    monkeypatch.setattr(sys, "meta_path", [SimpleNamespace(find_spec=lambda *_: None)])
    with pytest.raises(ModuleNotFoundError) as caught:
        Progress()
    assert str(caught.value) == "Progress needs tqdm: pip install 'divbandit[cli]'"


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        ({"tau": -1}, "tau"),
        ({"measure": "coverage"}, "measure must be a Measure"),
        ({"tau": 0.5, "measure": Total()}, "tau must not be given together with a measure"),
    ],
)
def test_bad_arguments_are_refused(arguments, message):
    with pytest.raises((TypeError, ValueError), match=message):
        Progress(**arguments)
