"""Goal babbling: goals uniform in their box, commands around the nearest effect's.

Uniformity is tested by Kolmogorov-Smirnov tests at level 1e-4, with a fixed seed.
"""

import numpy as np
import pytest
from scipy import stats

import divbandit as db
from tests.reference.nearest import nearest

LEVEL = 1e-4
ARM = db.PlanarArm(4)


def observed(n=20):
    history = db.History(ARM.motor_space, ARM.sensory_space)
    rng = np.random.default_rng(5)
    for _ in range(n):
        command = ARM.motor_space.sample(rng)
        history.append(command, ARM(command))
    return history


@pytest.mark.parametrize("goals", [None, db.Box([2, -1], [3, 5])])
def test_goals_are_uniform(goals):
    strategy, history, rng = db.GoalBabbling(0.1, goals=goals), observed(), np.random.default_rng(0)
    drawn = np.array([strategy.propose(history, rng).goal for _ in range(4000)])
    box = goals or ARM.sensory_space
    for j in range(2):
        whole = stats.uniform(box.low[j], box.high[j] - box.low[j])
        assert stats.kstest(drawn[:, j], whole.cdf).pvalue > LEVEL


@pytest.mark.parametrize("d", [0.0, 0.01, 0.3])
def test_commands_are_within_d_of_the_nearest_effects_command(d):
    strategy, history, rng = db.GoalBabbling(d), observed(), np.random.default_rng(0)
    for _ in range(200):
        trial = strategy.propose(history, rng)
        _, (index,) = nearest(history.effects, trial.goal)
        reach = d * 2 * ARM.limit
        assert np.all(np.abs(trial.command - history.commands[index]) <= reach * (1 + 1e-12))


def test_babbles_in_m_with_nothing_observed():
    rng, plain = np.random.default_rng(0), np.random.default_rng(0)
    empty = db.History(ARM.motor_space, ARM.sensory_space)
    trial = db.GoalBabbling(0.05).propose(empty, rng)
    assert trial.goal is None
    assert trial.command.tolist() == ARM.motor_space.sample(plain).tolist()


def test_one_draw_a_coordinate_of_the_goal_and_then_of_the_command():
    rng, plain, history = np.random.default_rng(7), np.random.default_rng(7), observed()
    trial = db.GoalBabbling(0.05).propose(history, rng)
    assert trial.goal.tolist() == ARM.sensory_space.sample(plain).tolist()
    assert trial.command.tolist() == history.inverse(trial.goal, plain, d=0.05).tolist()
    assert rng.random() == plain.random()


def test_goals_of_another_dimension_are_refused_before_the_first_step():
    strategy = db.GoalBabbling(goals=db.Box([0], [1]))
    with pytest.raises(ValueError, match=r"goals must have the dimension of the effects, 2, got 1"):
        db.explore(ARM, strategy, n=1)


def test_goals_of_another_dimension_are_refused_at_the_first_effect():
    explorer = db.Explorer(db.GoalBabbling(goals=db.Box([0], [1])), ARM.motor_space, rng=0)
    trial = explorer.ask()
    with pytest.raises(ValueError, match="goals must have the dimension of the effects"):
        explorer.tell(trial, [0.0, 0.0])
    assert len(explorer.history) == 0
