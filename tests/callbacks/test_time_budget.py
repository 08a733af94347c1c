"""TimeBudget: stops at the first look after its time, counted from the start of each run."""

import pytest

from divbandit.callbacks import Every, TimeBudget, time_budget
from tests.callbacks.scripts import explorer, scripted


@pytest.fixture
def clock(monkeypatch):
    """Return a list whose only number is what the clock shows, in seconds."""
    now = [100.0]
    monkeypatch.setattr(time_budget, "monotonic", lambda: now[0])
    return now


def a_minute_each(clock, n):
    """Return a black box that takes a minute for each of n evaluations."""

    def effects():
        for _ in range(n):
            clock[0] += 60
            yield 1

    return scripted(effects())


def test_no_evaluation_begins_after_its_time(clock):
    hour = Every(1, TimeBudget("1h"))
    assert len(explorer().run(a_minute_each(clock, 99), 99, callbacks=[hour])) == 60
    over = Every(1, TimeBudget("59.5 min"))
    assert len(explorer().run(a_minute_each(clock, 99), 99, callbacks=[over])) == 60


def test_each_run_has_all_of_the_time(clock):
    budget, one = Every(1, TimeBudget("10min")), explorer()
    for made in (10, 20):
        assert len(one.run(a_minute_each(clock, 99), 99, callbacks=[budget])) == made


def test_two_runs_at_once_have_each_their_own_time(clock):
    budget, one = TimeBudget(60), explorer()
    first = budget.start(one, None)
    clock[0] += 59
    second = budget.start(one, None)
    assert first(one, None) is False
    clock[0] += 1
    assert first(one, None) is True
    assert second(one, None) is False


def test_it_looks_at_the_clock_by_itself():
    assert len(explorer().run(scripted(iter(int, 1)), 10**6, callbacks=[TimeBudget("30ms")])) > 1


@pytest.mark.parametrize("limit", ["forever", "-1h", 0, -1.0, float("nan"), float("inf")])
def test_what_is_no_duration_is_refused(limit):
    with pytest.raises(ValueError, match="limit must be a"):
        TimeBudget(limit)


def test_equal_durations_make_equal_budgets():
    assert TimeBudget("2h") == TimeBudget("120min") == TimeBudget(7200)
