"""Line variation and crossover make of a goal what a few plain lines of Python make of it."""

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from scipy import stats

import divbandit as db
from divbandit._core import normal_quantile
from divbandit.inverse import Crossover, LineVariation, Nearest
from tests.generators import state
from tests.known import SEEDS, histories
from tests.reference.nearest import nearest

EXACT = settings(max_examples=150, deadline=None, derandomize=True)
SHARES = st.sampled_from([0.0, 1e-3, 0.2, 1.0])


def goal_for(past, seed):
    rng = np.random.default_rng(seed)
    return past.sensory_space.sample(rng) + 0.3 * rng.normal(size=past.effect_dim)


@given(histories(), SHARES, st.sampled_from([0.0, 0.2, 30.0]), SEEDS)
@EXACT
def test_line_variation(past, d, along, seed):
    rng, plain = np.random.default_rng(seed), np.random.default_rng(seed)
    goal = goal_for(past, seed)
    command = LineVariation(d, along=along).command(goal, past, rng)
    parent = past.commands[nearest(past.effects, goal)[1][0]]
    other = past.commands[int(plain.random() * len(past))]
    step = along * normal_quantile(plain.random())
    moved = np.clip(parent + step * (other - parent), past.motor_space.low, past.motor_space.high)
    assert command.tolist() == past.motor_space.bounds.perturb(moved, d, plain).tolist()
    assert state(rng) == state(plain)


@given(histories(), st.integers(1, 40), SHARES, SEEDS)
@EXACT
def test_crossover(past, k, d, seed):
    rng, plain = np.random.default_rng(seed), np.random.default_rng(seed)
    goal = goal_for(past, seed)
    command = Crossover(k, d).command(goal, past, rng)
    found = nearest(past.effects, goal, min(k, len(past)))[1]
    parent, other = past.commands[found[0]], past.commands[found[int(plain.random() * len(found))]]
    share = 0.5 * plain.random()
    crossed = np.where(plain.random(past.motor_space.dim) < share, other, parent)
    assert command.tolist() == past.motor_space.bounds.perturb(crossed, d, plain).tolist()
    assert state(rng) == state(plain)


def test_steps_are_normal_along_the_line():
    past = db.History(db.Box([-9] * 2, [9] * 2))
    past.append([0, 0], [0.0])
    past.append([1, 2], [1.0])
    model, rng = LineVariation(0.0), np.random.default_rng(0)
    drawn = np.array([model.command([0.0], past, rng) for _ in range(4000)])
    np.testing.assert_allclose(drawn[:, 1], 2 * drawn[:, 0])
    moved = drawn[drawn[:, 0] != 0, 0]  # the other one was not the nearest itself
    assert 0.45 < len(moved) / len(drawn) < 0.55
    assert stats.kstest(moved, stats.norm(scale=0.2).cdf).pvalue > 1e-4


def test_coordinates_come_from_either_and_at_most_half_from_the_other():
    past = db.History(db.Box([0] * 400, [1] * 400))
    past.append([0.0] * 400, [0.0])
    past.append([1.0] * 400, [1.0])
    rng = np.random.default_rng(0)
    drawn = np.array([Crossover(2, 0.0).command([0.0], past, rng) for _ in range(1000)])
    assert set(np.unique(drawn)) == {0.0, 1.0}
    shares = drawn.mean(axis=1)[drawn.any(axis=1)]
    assert stats.kstest(shares, stats.uniform(0, 0.5).cdf).statistic < 0.06


@pytest.mark.parametrize("model", [LineVariation(0.1), Crossover(d=0.1)])
def test_of_one_effect_both_are_the_nearest_neighbour(model):
    past = db.History(db.Box([0, 0], [1, 1]))
    past.append([0.25, 0.5], [7.0])
    rng, plain = np.random.default_rng(0), np.random.default_rng(0)
    command = model.command([8.0], past, rng)
    plain.random(2 if isinstance(model, LineVariation) else 4)
    assert command.tolist() == Nearest(0.1).command([8.0], past, plain).tolist()
