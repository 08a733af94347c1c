"""UntriedGoals draws what plain Python draws from the same stream, and needs no box."""

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

import divbandit as db
from divbandit.goals import UntriedGoals
from tests.generators import state
from tests.known import SEEDS, histories
from tests.reference import untried_goals

TAUS = st.sampled_from([1e-9, 0.05, 0.3, 10.0])
NUMBERS = st.integers(1, 8)
REACHES = st.sampled_from([1.0, 1.5, 4.0])


@given(histories(), TAUS, NUMBERS, NUMBERS, REACHES, st.booleans(), SEEDS)
@settings(max_examples=200, deadline=None, derandomize=True)
def test_goals_are_those_of_a_plain_search(history, tau, candidates, tries, reach, boxed, seed):
    rng, plain = np.random.default_rng(seed), np.random.default_rng(seed)
    box = history.sensory_space if boxed else None
    value = UntriedGoals(tau, candidates=candidates, tries=tries, reach=reach, box=box)
    goals = value.start(history)
    expected = untried_goals.UntriedGoals(tau, candidates, tries, reach, box)
    for step in range(12):
        goal = goals.sample(history, rng)
        assert goal.tolist() == expected.sample(history, plain).tolist()
        assert state(rng) == state(plain)
        assert box is None or box.contains(goal)
        for _ in range(step):  # more and more effects, also outside of where all were
            away = goal + tau * rng.normal(size=len(goal))
            history.append(history.motor_space.sample(rng), away)
        plain.bit_generator.state = rng.bit_generator.state


def line():
    history = db.History(db.Box([0], [1]))
    for effect in (0.0, 1.0):
        history.append([0.5], [effect])
    return history


def test_effects_take_turns():
    history, rng = line(), np.random.default_rng(0)
    goals = UntriedGoals(0.1, reach=1.0, box=db.Box([0], [1])).start(history)
    drawn = [round(float(goals.sample(history, rng)[0]), 12) for _ in range(20)]
    assert all(set(drawn[i : i + 2]) == {0.1, 0.9} for i in range(0, 20, 2))


def test_where_nearly_all_is_covered_goals_lie_beyond_the_border():
    """A square with a hole: once the others have had their turn, goals lie in it."""
    history, rng = db.History(db.Box([0], [1])), np.random.default_rng(0)
    for effect in rng.random((6000, 2)):
        if np.linalg.norm(effect - 0.5) > 0.15:
            history.append([0.5], effect)
    box = db.Box([0.1] * 2, [0.9] * 2)
    sampler = UntriedGoals(0.03, tries=1, reach=2.0, box=box).start(history)
    goals = np.array([sampler.sample(history, rng) for _ in range(400)])[300:]
    assert np.mean(np.linalg.norm(goals - 0.5, axis=1) < 0.15) > 0.5


def test_goals_go_beyond_what_is_known():
    """Without a box or a sensory space, an exploration spreads as far as the effects can."""
    wide = db.FunctionEnvironment(lambda x: 100 * x, db.Box([-1, -1], [1, 1]))
    babbling = db.GoalBabbling(0.05, goals=UntriedGoals(5.0))
    mixture = db.Mixture([db.MotorBabbling(), babbling], weights=[0.02, 0.98])
    run = db.explore(wide, mixture, n=1500, rng=0)
    assert run.coverage(5.0)[-1] > 0.93 * 200 * 200


def test_what_was_counted_belongs_to_one_start():
    goals, history = UntriedGoals(0.1), line()

    def drawn():
        at_work, rng = goals.start(history), np.random.default_rng(3)
        return [at_work.sample(history, rng).tolist() for _ in range(4)]

    first = drawn()
    assert first == drawn()
    rng = np.random.default_rng(3)
    assert first != [goals.sample(history, rng).tolist() for _ in range(4)]  # the counts tell


def test_with_nothing_observed_goals_are_uniform():
    history = db.History(db.Box([0], [1]), db.Box([5], [7]))
    goal = UntriedGoals(0.1).sample(history, np.random.default_rng(0))
    assert goal.tolist() == history.sensory_space.sample(np.random.default_rng(0)).tolist()
    with pytest.raises(ValueError, match=r"there must be a sensory space .* UntriedGoals\(box="):
        UntriedGoals(0.1).sample(db.History(db.Box([0], [1])), np.random.default_rng(0))


def test_extreme_effects():
    history, rng = db.History(db.Box([0], [1])), np.random.default_rng(0)
    for effect in ([8e307, -1e308], [5e-324, 0.0], [-1e160, 1e200]):
        history.append([0.5], effect)
        assert np.isfinite(UntriedGoals(0.1).sample(history, rng)).all()
    history.append([0.5], [-1e308, 0.0])
    with pytest.raises(ValueError, match=r"low\[0\] must be at most"):
        UntriedGoals(0.1).sample(history, rng)
