"""Each inverse model makes of a goal what a plain computation in NumPy makes of it.

The regression's oracle is a least-squares fit by singular values, with the ridge as further rows;
the kernel solves normal equations. They agree to 1e-9 of the motor range: the ridge bounds the
condition of either by a few thousands.
"""

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

import divbandit as db
from divbandit.inverse import KNearest, LocalJacobian, LocalRegression, Nearest
from tests.generators import state
from tests.known import SEEDS, histories, history
from tests.reference.nearest import nearest

EXACT = settings(max_examples=200, deadline=None, derandomize=True)
KS = st.integers(1, 12)
SHARES = st.sampled_from([0.0, 1e-3, 0.2, 1.0])

MODELS = {
    "nearest": Nearest,
    "k nearest": lambda d=0.05: KNearest(3, d),
    "regression": lambda d=0.05: LocalRegression(5, d),
}
every = pytest.mark.parametrize("model", MODELS.values(), ids=MODELS)
ALL = MODELS | {"jacobian": lambda d=0.05: LocalJacobian(used=4, reach=d)}
also_the_jacobian = pytest.mark.parametrize("model", ALL.values(), ids=ALL)


def goal_for(past, seed):
    """Draw a goal: anywhere, far away, or an effect that was observed."""
    rng = np.random.default_rng(seed)
    if rng.random() < 0.2:
        return past.effects[rng.integers(len(past))]
    scale = 100.0 if rng.random() < 0.2 else 1.0
    return past.sensory_space.sample(rng) + scale * 0.3 * rng.normal(size=past.effect_dim)


def weighted_mean(past, goal, k):
    distances, indices = nearest(past.effects, goal, min(k, len(past)))
    weights = (distances == 0).astype(float) if distances[0] == 0 else 1 / distances
    return np.average(past.commands[indices], axis=0, weights=weights)


def regression(past, goal, k, ridge, reach):
    distances, indices = nearest(past.effects, goal, min(k, len(past)))
    effects, commands = past.effects[indices], past.commands[indices]
    weights = np.ones(len(indices))
    if distances[-1] > 0:
        weights = (1 - (distances / (1.25 * distances[-1])) ** 2) ** 2
    weights /= weights.sum()
    centre = weights @ effects
    variance = np.mean(weights @ (effects - centre) ** 2)
    if variance < 1e-28:
        return weights @ commands
    s = past.effect_dim
    features = (effects - centre) / np.sqrt(variance)
    rows = np.sqrt(weights)[:, None] * np.column_stack([np.ones(len(indices)), features])
    penalty = np.sqrt(ridge) * np.column_stack([np.zeros(s), np.eye(s)])
    target = np.vstack([np.sqrt(weights)[:, None] * commands, np.zeros((s, commands.shape[1]))])
    fitted = np.linalg.lstsq(np.vstack([rows, penalty]), target, rcond=None)[0]
    offset = (goal - centre) / np.sqrt(variance)
    offset *= min(1.0, reach * np.sqrt(s) / max(np.linalg.norm(offset), 1e-300))
    command = fitted[0] + offset @ fitted[1:]
    return np.clip(command, past.motor_space.low, past.motor_space.high)


def close(command, expected, space):
    range_ = space.high - space.low
    np.testing.assert_array_less(np.abs(command - expected), 1e-9 * range_ + 1e-14)


@given(histories(), KS, SEEDS)
@EXACT
def test_the_mean_of_the_nearest(past, k, seed):
    goal = goal_for(past, seed)
    command = KNearest(k, d=0.0).command(goal, past, np.random.default_rng(0))
    close(command, weighted_mean(past, goal, k), past.motor_space)


@given(histories(), KS, st.sampled_from([1e-3, 0.1, 3.0]), st.sampled_from([0.5, 2.0, 1e6]), SEEDS)
@EXACT
def test_the_regression_is_that_by_singular_values(past, k, ridge, reach, seed):
    goal = goal_for(past, seed)
    model = LocalRegression(k, d=0.0, ridge=ridge, reach=reach)
    command = model.command(goal, past, np.random.default_rng(0))
    # The command is clipped: what is far beyond comes out at the border in both.
    close(command, regression(past, goal, k, ridge, reach), past.motor_space)


def test_the_regression_finds_a_linear_map():
    """Of exact data and almost without a ridge, it is the map itself."""
    rng = np.random.default_rng(0)
    past = db.History(db.Box([-9] * 3, [9] * 3))
    matrix, at = rng.normal(size=(3, 2)), rng.normal(size=3)
    for effect in rng.normal(size=(40, 2)):
        past.append(matrix @ effect + at, effect)
    for goal in rng.normal(size=(20, 2)):
        command = LocalRegression(9, 0.0, ridge=1e-9, reach=1e3).command(goal, past, rng)
        np.testing.assert_allclose(command, matrix @ goal + at, atol=1e-6)


def test_the_regression_of_effects_on_a_line_makes_nothing_of_what_is_beside_it():
    past = db.History(db.Box([-9], [9]))
    for x in range(5):
        past.append([x], [x, x])
    model = LocalRegression(5, 0.0, ridge=1e-6)
    for goal, expected in [([2, 2], 2), ([3, 1], 2), ([1, 3], 2), ([2.5, 2.5], 2.5)]:
        assert model.command(goal, past, np.random.default_rng(0))[0] == pytest.approx(
            expected, abs=1e-4
        )


@every
@given(past=histories(), seed=SEEDS)
@settings(max_examples=60, deadline=None, derandomize=True)
def test_commands_lie_in_the_motor_space_and_cost_a_draw_a_coordinate(model, past, seed):
    rng, plain = np.random.default_rng(seed), np.random.default_rng(seed)
    command = model(0.3).command(goal_for(past, seed), past, rng)
    assert past.motor_space.contains(command)
    plain.random(past.motor_space.dim)
    assert state(rng) == state(plain)


@every
@given(past=histories(), d=SHARES, seed=SEEDS)
@settings(max_examples=60, deadline=None, derandomize=True)
def test_a_command_is_perturbed_as_the_paper_does(model, past, d, seed):
    rng, plain = np.random.default_rng(seed), np.random.default_rng(seed)
    goal = goal_for(past, seed)
    centre = model(0.0).command(goal, past, np.random.default_rng(0))
    expected = past.motor_space.bounds.perturb(centre, d, plain)
    assert model(d).command(goal, past, rng).tolist() == expected.tolist()


@given(histories(), SHARES, SEEDS)
@settings(max_examples=60, deadline=None, derandomize=True)
def test_of_one_effect_all_are_the_nearest_neighbour(past, d, seed):
    goal = goal_for(past, seed)
    models = Nearest(d), KNearest(1, d), LocalRegression(1, d)
    found = {tuple(model.command(goal, past, np.random.default_rng(seed))) for model in models}
    assert len(found) == 1


@every
def test_the_same_effect_again_and_again(model):
    past = db.History(db.Box([0, 2], [1, 2]))
    for x in (0.0, 0.5, 1.0):
        past.append([x, 2], [7.0, 7.0, 7.0])
    command = model(0.0).command([7.0, 7.0, 7.0], past, np.random.default_rng(0))
    assert command.tolist() == [0.0 if model is Nearest else 0.5, 2.0]


@also_the_jacobian
def test_extreme_effects(model):
    past = db.History(db.Box([-8e307], [8e307]))
    for x, effect in [(-8e307, 1e308), (8e307, -1e308), (0, 5e-324), (1, 0), (2, 1e160)]:
        past.append([x], [effect])
    for goal in ([0.0], [5e-324], [1e308], [-1e200], [3.0]):
        command = model(0.0).command(goal, past, np.random.default_rng(0))
        assert past.motor_space.contains(command)


@also_the_jacobian
def test_with_nothing_observed_it_is_refused(model):
    rng, empty = np.random.default_rng(0), db.History(db.Box([0], [1]))
    with pytest.raises(ValueError, match="history must not be empty"):
        model().command([0.0], empty, rng)
    assert state(rng) == state(np.random.default_rng(0))


@also_the_jacobian
@given(past=histories(), seed=SEEDS)
@settings(max_examples=25, deadline=None, derandomize=True)
def test_a_model_at_work_remembers_nothing(model, past, seed):
    at_work = model(0.3).start(past)
    rng, plain = np.random.default_rng(seed), np.random.default_rng(seed)
    for i in range(6):
        goal = goal_for(past, seed + i)
        expected = model(0.3).command(goal, past, plain)
        assert at_work.command(goal, past, rng).tolist() == expected.tolist()


@also_the_jacobian
def test_a_model_says_what_it_must_be_given(model):
    past = history(2, 2, 10, 0)
    at_work, rng = model().start(past), np.random.default_rng(0)
    with pytest.raises(TypeError, match="history must be a History, got list"):
        at_work.command([0.0, 0.0], [], rng)
    with pytest.raises(ValueError, match=r"goal must have shape \(2,\), got \(1,\)"):
        at_work.command([0.0], past, rng)
    with pytest.raises(ValueError, match=r"goal\[1\] must be finite, got NaN"):
        at_work.command([0.0, np.nan], past, rng)
    with pytest.raises(TypeError, match="value must be an inverse model of the library, got int"):
        type(at_work)(3)
    assert state(rng) == state(np.random.default_rng(0))
