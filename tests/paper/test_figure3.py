"""What the paper says of figure 3 holds for the mean over 25 explorations."""

import numpy as np
import pytest

from divbandit.paper import figure3


@pytest.fixture(scope="module")
def motor_usage():
    """The mean usage of motor babbling at each step, by d."""
    return {row.d: row.mean_usage for row in figure3.run(0, repetitions=25)}


def test_motor_babbling_overwhelms_at_first_where_goal_babbling_hardly_moves(motor_usage):
    assert motor_usage[0.001][:1000].mean() > 0.75


def test_both_are_used_alike_in_the_end_where_goal_babbling_hardly_moves(motor_usage):
    assert abs(motor_usage[0.001][4000:].mean() - 0.5) < 0.06


def test_goal_babbling_is_used_more_and_more_where_it_moves_well(motor_usage):
    blocks = 1 - motor_usage[0.05].reshape(5, 1000).mean(axis=1)
    assert np.all(np.diff(blocks) > 0)
    assert blocks[-1] > 0.75


def test_goal_babbling_dominates_after_1500_steps_where_it_moves_far(motor_usage):
    blocks = 1 - motor_usage[0.5].reshape(10, 500).mean(axis=1)
    assert np.all(blocks[3:] > 0.55)
    assert blocks[-1] > 0.7


def test_the_exploration_shown_is_one_of_those_averaged():
    rows = figure3.run(3, n=300, repetitions=1)
    for row in rows:
        from divbandit.plot.data import usage_of  # noqa: PLC0415

        np.testing.assert_array_equal(row.mean_usage, usage_of(row.exploration)[:, 0])
