"""What is called, with what, and when it stops a run."""

import pytest

import divbandit as db
from divbandit.callbacks import Callback, Every, Progress, RunningCallback, TimeBudget
from divbandit.callbacks.protocol import check_callback, start_callback
from tests.callbacks.scripts import explorer, scripted


class Log:
    """Notes all that is done with it, and with what it starts."""

    def __init__(self):
        self.notes = []

    def start(self, explorer, n):
        self.notes.append(("start", len(explorer.history), n))
        return Running(self.notes)


class Running:
    def __init__(self, notes):
        self.notes = notes

    def __call__(self, explorer, trial):
        history = explorer.history
        self.notes.append((trial.number, len(history), len(history.failures)))

    def close(self):
        self.notes.append("close")


def test_a_callback_is_started_called_after_each_evaluation_and_closed():
    log = Log()
    explorer().run(scripted([1, None, 2]), 3, on_error="record", callbacks=[log])
    assert log.notes == [("start", 0, 3), (0, 1, 0), (1, 1, 1), (2, 2, 1), "close"]


def test_it_is_closed_whatever_ends_the_run():
    log = Log()
    with pytest.raises(ValueError, match="it fell"):
        explorer().run(scripted([1, None]), 3, callbacks=[log])
    assert log.notes[-1] == "close"


def test_the_same_one_watches_two_runs():
    log, one = Log(), explorer()
    one.run(scripted([1, 2]), 2, callbacks=[log])
    one.run(scripted([3]), 1, callbacks=[log])
    second = log.notes[4:]
    assert second == [("start", 2, 1), (2, 3, 0), "close"]


@pytest.mark.parametrize("answer", [None, False, 1, "stop", 0.5])
def test_only_true_stops(answer):
    made = explorer().run(scripted([1] * 4), 4, callbacks=[lambda *_: answer])
    assert len(made) == 4


def test_true_stops_once_all_were_called():
    log = Log()
    made = explorer().run(scripted([1] * 4), 4, callbacks=[lambda *_: True, log])
    assert len(made) == 1
    assert len(log.notes) == 3


def test_every_k_evaluations():
    log = Log()
    every = Every(3, log)
    explorer().run(scripted([1, None] * 4), 8, on_error="record", callbacks=[every])
    assert log.notes == [("start", 0, 8), (2, 2, 1), (5, 3, 3), "close"]
    assert every.every == 3


def test_every_so_many_seconds():
    log = Log()
    explorer().run(scripted([1] * 50), 50, callbacks=[Every("1h", log)])
    assert log.notes == [("start", 0, 50), "close"]
    explorer().run(scripted([1] * 50), 50, callbacks=[Every("0.00001ms", log)])
    assert 4 < len(log.notes) <= 54


def test_every_takes_the_place_of_how_often_a_callback_asks_to_be_called():
    over = Every(1, TimeBudget("0.00001ms"))
    assert len(explorer().run(scripted([1] * 50), 50, callbacks=[over])) == 1
    nested = Every(2, Every(5, TimeBudget("0.00001ms")))
    assert len(explorer().run(scripted([1] * 50), 50, callbacks=[nested])) == 2


def test_functions_and_callbacks_are_told_apart():
    assert isinstance(print, RunningCallback)
    assert not isinstance(print, Callback)
    assert isinstance(Progress(), Callback)
    assert not isinstance(Progress(), RunningCallback)
    assert start_callback(print, explorer(), 3) is print


@pytest.mark.parametrize(
    ("bad", "got"),
    [(5, "int"), (None, "NoneType"), (Progress, "the class Progress"), ("2h", "str")],
)
def test_what_is_no_callback_is_refused(bad, got):
    with pytest.raises(TypeError) as caught:
        check_callback("callbacks[0]", bad)
    assert str(caught.value) == (
        "callbacks[0] must be a function of an explorer and a trial, or have start, "
        f'such as TimeBudget("2h"), got {got}'
    )


@pytest.mark.parametrize(
    ("k", "kind", "message"),
    [
        (0, ValueError, "k must be at least 1, got 0"),
        (2.0, TypeError, "k must be a whole number, got float"),
        (True, TypeError, "k must be a whole number, got bool"),
        (None, TypeError, "k must be a whole number, got NoneType"),
        ("often", ValueError, "k must be a duration such as .*, got 'often'"),
    ],
)
def test_every_refuses_what_says_no_time(k, kind, message):
    with pytest.raises(kind, match=message):
        Every(k, print)


def test_every_refuses_what_is_no_callback():
    with pytest.raises(TypeError, match="callback must be a function of an explorer and a trial"):
        Every(10, db.callbacks.TimeBudget)
