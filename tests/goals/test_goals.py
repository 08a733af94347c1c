"""Each goal sampler draws what a few plain lines of Python draw from the same stream.

Distances in these lines are those of `tests.reference.nearest`, which looks at all effects.
"""

from itertools import product

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from scipy import stats

import divbandit as db
from divbandit.goals import (
    FrontierGoals,
    GridGoals,
    NovelGoals,
    UncoveredGoals,
    UniformGoals,
)
from tests.generators import state
from tests.known import SEEDS, histories
from tests.reference import grid_goals
from tests.reference.nearest import nearest

TAUS = st.sampled_from([1e-9, 0.05, 0.3, 10.0])
TRIES = st.integers(1, 8)
EXACT = settings(max_examples=150, deadline=None, derandomize=True)
LEVEL = 1e-4

SAMPLERS = {
    "uniform": UniformGoals,
    "grid": lambda **box: GridGoals(3, **box),
    "uncovered": lambda **box: UncoveredGoals(0.1, **box),
    "frontier": lambda **box: FrontierGoals(0.1, **box),
    "novel": lambda **box: NovelGoals(3, **box),
}
every = pytest.mark.parametrize("sampler", SAMPLERS.values(), ids=SAMPLERS)


def streams(seed):
    return np.random.default_rng(seed), np.random.default_rng(seed)


def far(history, goal):
    return float(nearest(history.effects, goal)[0][0])


def same(goal, expected, rng, plain):
    assert goal.tolist() == expected.tolist()
    assert state(rng) == state(plain)


@given(histories(), TAUS, TRIES, SEEDS)
@EXACT
def test_uncovered_goals(history, tau, tries, seed):
    rng, plain = streams(seed)
    goal = UncoveredGoals(tau, tries=tries).sample(history, rng)
    for _ in range(tries):
        expected = history.sensory_space.sample(plain)
        if far(history, expected) > tau:
            break
    same(goal, expected, rng, plain)


@given(histories(), st.integers(1, 8), SEEDS)
@EXACT
def test_novel_goals(history, candidates, seed):
    rng, plain = streams(seed)
    goal = NovelGoals(candidates).sample(history, rng)
    drawn = [history.sensory_space.sample(plain) for _ in range(candidates)]
    same(goal, max(drawn, key=lambda each: far(history, each)), rng, plain)


@given(histories(), TAUS, st.sampled_from([1.0, 1.5, 4.0]), TRIES, SEEDS)
@EXACT
def test_frontier_goals(history, tau, reach, tries, seed):
    rng, plain = streams(seed)
    goal = FrontierGoals(tau, reach=reach, tries=tries).sample(history, rng)
    box = history.sensory_space
    for _ in range(tries):
        centre = history.effects[int(plain.random() * len(history))]
        direction = np.array([2.0 * plain.random() - 1.0 for _ in range(box.dim)])
        squared = 0.0
        for x in direction.tolist():
            squared += x * x
        scale = tau * (1.0 + (reach - 1.0) * plain.random()) / np.sqrt(squared)
        expected = np.clip(centre + direction * scale, box.low, box.high)
        if far(history, expected) > tau:
            break
    same(goal, expected, rng, plain)


@given(histories(), st.integers(1, 4), st.booleans(), SEEDS)
@EXACT
def test_grid_goals(history, cells, each, seed):
    rng, plain = streams(seed)
    counts = [1 + (cells + j) % 4 for j in range(history.effect_dim)] if each else cells
    goals = GridGoals(counts).start(history)
    expected = grid_goals.GridGoals(counts, history.sensory_space)
    for _ in range(30):
        assert goals.sample(history, rng).tolist() == expected.sample(plain)
        assert state(rng) == state(plain)


@given(histories(), TAUS, SEEDS)
@EXACT
def test_what_is_known_of_a_growing_history(history, tau, seed):
    """A sampler at work remembers what is covered; its goals are those of one that does not."""
    for value in (UncoveredGoals(tau), FrontierGoals(tau)):
        sampler = value.start(history)
        rng, plain = streams(seed)
        for _ in range(20):
            goal = sampler.sample(history, rng)
            same(goal, value.sample(history, plain), rng, plain)
            history.append(history.motor_space.sample(rng), goal + tau * (rng.random() - 0.5))
            plain.bit_generator.state = rng.bit_generator.state


def test_frontier_goals_are_at_such_distances_and_uncovered():
    history = db.History(db.Box([0], [1]), db.Box([-9] * 3, [9] * 3))
    for effect in [[0, 0, 0], [0, 0.1, 0], [2, 2, 2]]:
        history.append([0.5], effect)
    goals, rng = FrontierGoals(0.5, reach=4.0).start(history), np.random.default_rng(0)
    found = np.array([far(history, goals.sample(history, rng)) for _ in range(2000)])
    assert 0.5 < found.min() < 0.51
    assert 1.95 < found.max() <= 2.0 + 1e-12


@pytest.mark.parametrize("cells", [1, 4, [1, 5], [3, 2]])
def test_a_round_of_a_grid_has_a_goal_in_each_cell(cells):
    history = db.History(db.Box([0], [1]), db.Box([-1, 10], [1, 20]))
    goals, rng = GridGoals(cells).start(history), np.random.default_rng(0)
    shape = [cells] * 2 if isinstance(cells, int) else cells
    for _ in range(3):
        drawn = [goals.sample(history, rng) for _ in range(shape[0] * shape[1])]
        shares = (np.array(drawn) - [-1, 10]) / [2, 10]
        found = sorted(map(tuple, (shares * shape).astype(int).tolist()))
        assert found == sorted(product(range(shape[0]), range(shape[1])))


def test_cells_come_in_random_order_and_goals_are_uniform_in_them():
    history = db.History(db.Box([0], [1]), db.Box([0], [1]))
    goals, rng = GridGoals(3).start(history), np.random.default_rng(0)
    drawn = np.array([[goals.sample(history, rng)[0] for _ in range(3)] for _ in range(3000)])
    orders = [tuple(row) for row in (drawn * 3).astype(int).tolist()]
    _, counts = np.unique(orders, axis=0, return_counts=True)
    assert len(counts) == 6
    assert stats.chisquare(counts).pvalue > LEVEL
    assert stats.kstest(drawn.ravel(), stats.uniform().cdf).pvalue > LEVEL


@every
@given(history=histories(), seed=SEEDS)
@settings(max_examples=25, deadline=None, derandomize=True)
def test_goals_lie_in_the_box(sampler, history, seed):
    rng, own = (
        np.random.default_rng(seed),
        db.Box([3] * history.effect_dim, [4] * history.effect_dim),
    )
    for box, goals in ((history.sensory_space, sampler()), (own, sampler(box=own))):
        for _ in range(5):
            assert box.contains(goals.sample(history, rng))


@every
def test_before_anything_is_observed(sampler):
    history = db.History(db.Box([0], [1]), db.Box([5], [6]))
    assert history.sensory_space.contains(sampler().sample(history, np.random.default_rng(0)))


@every
def test_values_are_not_changed_by_what_they_start(sampler):
    history = db.History(db.Box([0], [1]), db.Box([0, 0], [1, 1]))
    history.append([0.5], [0.5, 0.5])
    goals = sampler()

    def drawn(value):
        at_work, rng = value.start(history), np.random.default_rng(0)
        return [at_work.sample(history, rng).tolist() for _ in range(12)]

    expected = drawn(goals)
    assert drawn(goals) == expected
    assert goals.sample(history, np.random.default_rng(0)).tolist() == expected[0]


@every
def test_a_sampler_says_what_it_must_be_given(sampler):
    goals = sampler().start(db.History(db.Box([0], [1])))
    with pytest.raises(TypeError, match="history must be a History, got list"):
        goals.sample([], np.random.default_rng(0))
    with pytest.raises(TypeError, match="value must be a goal sampler of the library, got int"):
        type(goals)(3)


@every
def test_what_does_not_fit_is_refused_before_the_first_step(sampler):
    line, plane = db.Box([0], [1]), db.PlanarArm(3)
    babbling = db.GoalBabbling(goals=sampler(box=line))
    with pytest.raises(ValueError, match=r"must have the dimension of the effects, 2, got 1"):
        db.explore(plane, babbling, n=1)
    nowhere = db.FunctionEnvironment(plane, plane.motor_space)
    with pytest.raises(ValueError, match=r"there must be a sensory space .*goals=Box\(low, high\)"):
        db.explore(nowhere, db.GoalBabbling(goals=sampler()), n=1)
    assert (
        len(db.explore(nowhere, db.GoalBabbling(goals=sampler(box=plane.sensory_space)), n=9)) == 9
    )


@every
def test_driven_by_hand_what_does_not_fit_is_refused_and_nothing_drawn(sampler):
    history, rng = db.History(db.Box([0], [1])), np.random.default_rng(0)
    history.append([0.5], [0.5, 0.5])
    before = state(rng)
    with pytest.raises(ValueError, match="there must be a sensory space"):
        sampler().sample(history, rng)
    assert state(rng) == before


def test_cells_of_another_dimension_are_refused():
    with pytest.raises(ValueError, match="cells must be one number or 2"):
        GridGoals([1, 2, 3], box=db.Box([0, 0], [1, 1]))
    with pytest.raises(ValueError, match="cells must be one number or 2"):
        db.explore(db.PlanarArm(3), db.GoalBabbling(goals=GridGoals([1, 2, 3])), n=1)
    with pytest.raises(ValueError, match="cells must be at most 10000000 altogether"):
        GridGoals(10_000, box=db.Box([0, 0], [1, 1]))


def test_extreme_effects_and_boxes():
    history, rng = db.History(db.Box([0], [1])), np.random.default_rng(0)
    for effect in ([1e308, -1e308], [5e-324, 0.0], [-1e160, 1e200]):
        history.append([0.5], effect)
    for box in (db.Box([0, 0], [1, 1]), db.Box([-8e307] * 2, [8e307] * 2), db.Box([1, 1], [1, 1])):
        for sampler in SAMPLERS.values():
            assert box.contains(sampler(box=box).sample(history, rng))
