"""Adapt's windows, head start and diversities, against numbers worked out on paper.

Effects are either far apart, so that each gains a whole ball, or repeated, so that they gain 0.
"""

import math

import pytest

from tests.bandits.script import Drive, both_engines

BALL = math.pi * 0.5 * 0.5


def drive(engine, **parameters):
    return Drive(engine, **{"tau": 0.5, "window": 3, "alpha": 0.5} | parameters)


def in_balls(*estimates):
    return pytest.approx([BALL * share for share in estimates], rel=1e-15)


@both_engines
def test_begins_with_a_ball_for_each(engine):
    assert drive(engine, count=3).estimates == (BALL, BALL, BALL)


@both_engines
def test_begins_with_nothing_without_a_head_start(engine):
    assert drive(engine, head_start=0).estimates == (0.0, 0.0)


@both_engines
def test_the_mean_counts_the_head_start_until_the_window_is_full(engine):
    run = drive(engine)
    assert run.step(0, new=True) == in_balls(1, 1)  # (1 + 1) / 2
    assert run.step(0, new=False) == in_balls(2 / 3, 1)  # (1 + 1 + 0) / 3
    assert run.step(0, new=False) == in_balls(1 / 3, 1)  # the head start left: 1 + 0 + 0
    assert run.step(0, new=False) == in_balls(0, 1)
    assert run.step(1, new=False) == in_balls(0, 1 / 2)
    assert run.step(1, new=False) == in_balls(0, 1 / 3)
    assert run.step(1, new=True) == in_balls(0, 1 / 3)  # 0 + 0 + 1
    assert run.step(0, new=True) == in_balls(1 / 3, 1 / 3)


@both_engines
def test_the_mean_is_over_the_gains_there_are_without_a_head_start(engine):
    run = drive(engine, head_start=0)
    assert run.step(0, new=True) == in_balls(1, 0)
    assert run.step(0, new=False) == in_balls(1 / 2, 0)
    assert run.step(0, new=False) == in_balls(1 / 3, 0)
    assert run.step(0, new=False) == in_balls(0, 0)
    assert run.step(1, new=True) == in_balls(0, 1)


@both_engines
def test_two_head_starts_leave_one_by_one(engine):
    run = drive(engine, head_start=2)
    assert run.estimates == (BALL, BALL)
    run.step(0, new=True)  # the first effect of all gains; 1 1 1
    assert run.step(0, new=False) == in_balls(2 / 3, 1)
    assert run.step(0, new=False) == in_balls(1 / 3, 1)
    assert run.step(0, new=False) == in_balls(0, 1)


@both_engines
def test_a_window_of_one_remembers_the_last_gain(engine):
    run = drive(engine, window=1)
    assert run.step(0, new=True) == in_balls(1, 1)
    assert run.step(0, new=False) == in_balls(0, 1)
    assert run.step(1, new=False) == in_balls(0, 0)
    assert run.step(1, new=True) == in_balls(0, 1)


@both_engines
def test_what_one_strategy_found_gains_nothing_for_another(engine):
    run = drive(engine, window=1)
    run.step(0, new=True)
    assert run.step(1, new=False) == in_balls(1, 0)


@both_engines
def test_gains_between_nothing_and_a_ball(engine):
    """Two discs one radius apart: the second gains its area less their lens."""
    run = drive(engine, window=1)
    for index, x in enumerate((0.0, 0.5)):
        run.explorer.tell(run.ask(0.0, 0.25 + 0.5 * index), [x, 0.0])
    lens = 0.25 * (2 * math.pi / 3 - math.sqrt(3) / 2)
    assert run.estimates == pytest.approx((BALL, BALL - lens), rel=1e-15)


@both_engines
def test_the_window_leaves_all_others_alone(engine):
    run = drive(engine, count=3)
    for _ in range(5):
        run.step(2, new=False)
    assert run.estimates == in_balls(1, 1, 0)
    run.step(0, new=True)
    assert run.estimates == in_balls(1, 1, 0)


@both_engines
def test_effects_of_others_count_before_its_own(engine):
    """What stands in the history already has been covered, whoever put it there."""
    run = drive(engine, window=1)
    run.explorer.add_past([[0.5]] * 2, [[0.0, 0.0], [10.0, 0.0]])
    assert run.step(0, new=False) == in_balls(0, 1)
    assert run.step(0, new=True) == in_balls(0, 1)
    run.explorer.add_past([[0.5]], [[50.0, 0.0]])
    run.fresh = 4
    assert run.step(0, new=True) == in_balls(0, 1)
    assert run.step(1, new=True) == in_balls(0, 1)
