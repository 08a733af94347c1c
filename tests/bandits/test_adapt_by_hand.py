"""Adapt's windows, head start and diversities, against numbers worked out on paper.

Effects are either far apart, so that each gains a whole ball, or repeated, so that they gain 0.
"""

import math

import pytest

import divbandit as db
from tests.bandits.script import Always, Drive, towards

BALL = math.pi * 0.5 * 0.5


def drive(**parameters):
    return Drive(**{"tau": 0.5, "window": 3, "alpha": 0.5} | parameters)


def in_balls(*diversities):
    return pytest.approx([BALL * share for share in diversities], rel=1e-15)


def test_begins_with_a_ball_for_each():
    assert db.Adapt([Always()] * 3, tau=0.5).diversities == (BALL, BALL, BALL)


def test_begins_with_nothing_without_a_head_start():
    assert db.Adapt([Always()] * 2, tau=0.5, head_start=0).diversities == (0.0, 0.0)


def test_the_mean_counts_the_head_start_until_the_window_is_full():
    run = drive()
    assert run.step(0, new=True) == in_balls(1, 1)  # (1 + 1) / 2
    assert run.step(0, new=False) == in_balls(2 / 3, 1)  # (1 + 1 + 0) / 3
    assert run.step(0, new=False) == in_balls(1 / 3, 1)  # the head start left: 1 + 0 + 0
    assert run.step(0, new=False) == in_balls(0, 1)
    assert run.step(1, new=False) == in_balls(0, 1 / 2)
    assert run.step(1, new=False) == in_balls(0, 1 / 3)
    assert run.step(1, new=True) == in_balls(0, 1 / 3)  # 0 + 0 + 1
    assert run.step(0, new=True) == in_balls(1 / 3, 1 / 3)


def test_the_mean_is_over_the_gains_there_are_without_a_head_start():
    run = drive(head_start=0)
    assert run.step(0, new=True) == in_balls(1, 0)
    assert run.step(0, new=False) == in_balls(1 / 2, 0)
    assert run.step(0, new=False) == in_balls(1 / 3, 0)
    assert run.step(0, new=False) == in_balls(0, 0)
    assert run.step(1, new=True) == in_balls(0, 1)


def test_two_head_starts_leave_one_by_one():
    run = drive(head_start=2)
    assert run.adapt.diversities == (BALL, BALL)
    run.step(0, new=True)  # the first effect of all gains; 1 1 1
    assert run.step(0, new=False) == in_balls(2 / 3, 1)
    assert run.step(0, new=False) == in_balls(1 / 3, 1)
    assert run.step(0, new=False) == in_balls(0, 1)


def test_a_window_of_one_remembers_the_last_gain():
    run = drive(window=1)
    assert run.step(0, new=True) == in_balls(1, 1)
    assert run.step(0, new=False) == in_balls(0, 1)
    assert run.step(1, new=False) == in_balls(0, 0)
    assert run.step(1, new=True) == in_balls(0, 1)


def test_what_one_strategy_found_gains_nothing_for_another():
    run = drive(window=1)
    run.step(0, new=True)
    assert run.step(1, new=False) == in_balls(1, 0)


def test_gains_between_nothing_and_a_ball():
    """Two discs one radius apart: the second gains its area less their lens."""
    run = drive(window=1)
    trial = run.adapt.propose(run.history, towards(0, 2))
    run.history.append(trial.command, [0.0, 0.0], path=trial.path)
    run.adapt.observe(trial, run.history.effects[-1])
    trial = run.adapt.propose(run.history, towards(1, 2))
    run.history.append(trial.command, [0.5, 0.0], path=trial.path)
    run.adapt.observe(trial, run.history.effects[-1])
    lens = 0.25 * (2 * math.pi / 3 - math.sqrt(3) / 2)
    assert run.adapt.diversities == pytest.approx((BALL, BALL - lens), rel=1e-15)


def test_the_window_leaves_all_others_alone():
    run = drive(count=3)
    for _ in range(5):
        run.step(2, new=False)
    assert run.adapt.diversities == in_balls(1, 1, 0)
    run.step(0, new=True)
    assert run.adapt.diversities == in_balls(1, 1, 0)


def test_begins_anew_with_another_history():
    run = drive()
    run.step(0, new=True)
    run.step(0, new=False)
    assert run.adapt.diversities == in_balls(2 / 3, 1)
    run.history = db.History(run.history.motor_space, run.history.sensory_space)
    assert run.step(1, new=False) == in_balls(1, 1)  # covered nothing: even this one gains


def test_effects_of_others_count_before_its_own():
    """What stands in the history already has been covered, whoever put it there."""
    run = drive(window=1)
    run.history.append([0.5], [0.0, 0.0])
    run.history.append([0.5], [10.0, 0.0])
    assert run.step(0, new=False) == in_balls(0, 1)
    assert run.step(0, new=True) == in_balls(0, 1)
    run.history.append([0.5], [50.0, 0.0])
    run.fresh = 4
    assert run.step(0, new=True) == in_balls(0, 1)
    assert run.step(1, new=True) == in_balls(0, 1)


def test_an_effect_that_is_not_in_the_history_is_refused():
    run = drive()
    trial = run.adapt.propose(run.history, towards(0, 2))
    with pytest.raises(ValueError, match="effect must be in the history"):
        run.adapt.observe(trial, [0.0, 0.0])
    assert run.adapt.diversities == (BALL, BALL)
