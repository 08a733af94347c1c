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


PLAIN_PARTS = [
    {"goals": db.UniformGoals()},
    {"inverse": db.NearestNeighbor(0.2)},
    {"goals": db.UniformGoals(ARM.sensory_space), "inverse": db.NearestNeighbor(0.2)},
]


@pytest.mark.parametrize("engine", ["python", "rust"])
@pytest.mark.parametrize("parts", PLAIN_PARTS, ids=str)
def test_the_papers_parts_by_name_are_the_same(parts, engine):
    d = 0.2 if "inverse" in parts else 0.05
    expected = db.explore(ARM, db.GoalBabbling(d), 100, rng=3).commands
    run = db.explore(ARM, db.GoalBabbling(**parts), 100, rng=3, engine=engine)
    assert run.commands.tobytes() == expected.tobytes()


class Corner:
    """A goal sampler and an inverse model of one's own."""

    def sample(self, history, rng):
        del history, rng
        return [1.0, 1.0]

    def command(self, goal, history, rng):
        del rng
        return history.motor_space.high * goal[0]


def test_parts_of_ones_own():
    run = db.explore(ARM, db.GoalBabbling(goals=Corner(), inverse=Corner()), 9, rng=0)
    assert np.all(run.commands[1:] == ARM.limit)
    trials = db.GoalBabbling(goals=Corner()).propose_many(observed(), 3, np.random.default_rng(0))
    assert [trial.goal for trial in trials] == [[1.0, 1.0]] * 3


def test_a_box_that_draws_in_its_own_way_is_asked():
    class Middle(db.Box):
        def sample(self, rng):
            del rng
            return (self.low + self.high) / 2

    babbling, rng = db.GoalBabbling(goals=Middle([0, 0], [1, 1])), np.random.default_rng(0)
    for trial in babbling.propose_many(observed(), 3, rng):
        assert trial.goal.tolist() == [0.5, 0.5]
    assert Middle([0], [1]).sample_many(2, rng).tolist() == [[0.5], [0.5]]


@pytest.mark.parametrize("goals", [None, db.NovelGoals(2), db.Box([0, 0], [1, 1])], ids=str)
@pytest.mark.parametrize("inverse", [None, db.KNearest(2, 0.1)], ids=str)
def test_its_repr_is_the_call_that_makes_it(goals, inverse):
    babbling = db.GoalBabbling(goals=goals, inverse=inverse)
    again = eval(repr(babbling), {name: getattr(db, name) for name in db.__all__})  # noqa: S307
    assert repr(again) == repr(babbling)


@pytest.mark.parametrize("s", [1, 3])
def test_goals_of_another_dimension_are_refused_for_many_as_for_one(s):
    strategy = db.GoalBabbling(goals=db.Box([0] * s, [1] * s))
    for call in (strategy.propose, lambda past, rng: strategy.propose_many(past, 2, rng)):
        with pytest.raises(ValueError, match=r"goals? must have"):
            call(observed(), np.random.default_rng(0))
