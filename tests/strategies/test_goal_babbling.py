"""Goal babbling: goals uniform in their box, commands around the nearest effect's.

Uniformity is tested by Kolmogorov-Smirnov tests at level 1e-4, with a fixed seed.
"""

import numpy as np
import pytest
from scipy import stats

import divbandit as db
from divbandit.goals import UniformGoals
from divbandit.inverse import Nearest
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
    parent = history.commands[history.nearest(trial.goal)[1]]
    perturbed = ARM.motor_space.bounds.perturb(parent, 0.05, plain)
    assert trial.command.tolist() == perturbed.tolist()
    assert rng.random() == plain.random()


def test_goals_of_another_dimension_are_refused_at_the_first_effect():
    explorer = db.Explorer(db.GoalBabbling(goals=db.Box([0], [1])), ARM.motor_space, rng=0)
    trial = explorer.ask()
    with pytest.raises(ValueError, match=r"goals.* must have the dimension of the effects"):
        explorer.tell(trial, [0.0, 0.0])
    assert len(explorer.history) == 0


PLAIN_PARTS = [
    {"goals": UniformGoals()},
    {"inverse": Nearest(0.2)},
    {"goals": UniformGoals(ARM.sensory_space), "inverse": Nearest(0.2)},
]


@pytest.mark.parametrize("engine", ["python", "rust"])
@pytest.mark.parametrize("parts", PLAIN_PARTS, ids=str)
def test_the_papers_parts_by_name_are_the_same(parts, engine):
    d = 0.2 if "inverse" in parts else 0.05
    expected = db.explore(ARM, db.GoalBabbling(d), 100, rng=3).commands
    run = db.explore(ARM, db.GoalBabbling(**parts), 100, rng=3, engine=engine)
    assert run.commands.tobytes() == expected.tobytes()


class Corner:
    """A goal sampler and an inverse model."""

    def sample(self, history, rng):
        del history, rng
        return [1.0, 1.0]

    def command(self, goal, history, rng):
        del rng
        return history.motor_space.high * goal[0]


def test_user_defined_parts():
    run = db.explore(ARM, db.GoalBabbling(goals=Corner(), inverse=Corner()), 9, rng=0)
    assert np.all(run.commands[1:] == ARM.limit)
    trial = db.GoalBabbling(goals=Corner()).propose(observed(), np.random.default_rng(0))
    assert trial.goal == [1.0, 1.0]


class Climbing:
    """A sampler with a state: each goal lies higher than the one before."""

    height = 0.0

    def start(self, history):
        assert isinstance(history, db.History)
        return self

    def sample(self, history, rng):
        del history, rng
        self.height += 0.125
        return [0.0, self.height]


def test_a_sampler_with_a_state_is_copied_for_each_exploration():
    sampler = Climbing()
    explorers = [
        db.Explorer(db.GoalBabbling(goals=sampler), ARM.motor_space, rng=seed) for seed in (0, 1)
    ]
    for explorer in explorers:
        explorer.tell(explorer.ask(), [0.5, 0.5])
        heights = [explorer.ask().goal[1] for _ in range(3)]
        assert heights == [0.125, 0.25, 0.375]
    assert sampler.height == 0.0


@pytest.mark.parametrize("s", [1, 3])
def test_goals_of_another_dimension_are_refused_when_they_are_drawn(s):
    strategy = db.GoalBabbling(goals=db.Box([0] * s, [1] * s))
    with pytest.raises(ValueError, match=r"goals?\b.* must have"):
        strategy.propose(observed(), np.random.default_rng(0))
