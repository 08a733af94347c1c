"""LocalJacobian makes of a goal what a plain computation in NumPy makes of it.

The oracle solves a regularised least-squares problem by singular values; the kernel factorises
normal equations, of a condition of 1e4 or so: they agree to 1e-7 of the motor range.
"""

import numpy as np
from hypothesis import given, settings
from hypothesis import strategies as st

import divbandit as db
from divbandit.inverse import LocalJacobian
from tests.generators import state
from tests.known import SEEDS, histories
from tests.reference.nearest import nearest


def step(past, goal, model):
    """Return the centre of the perturbation, and its reach as a share of the ranges."""
    space = past.motor_space
    width = np.where(space.high > space.low, space.high - space.low, 1.0)
    free = max(1, np.count_nonzero(space.high > space.low))
    distances, indices = nearest(past.effects, goal, min(model.k + 1, len(past)))
    del distances
    base, others = indices[0], indices[1:]
    moved = (past.commands[others] - past.commands[base]) / width
    away = np.sqrt(np.sum(moved**2, axis=1))
    order = np.lexsort((others, away))
    order = order[away[order] > 0][: model.used]
    u, d = moved[order] / away[order, None], away[order]
    v = (past.effects[others[order]] - past.effects[base]) / d[:, None]
    error = goal - past.effects[base]
    if len(d) == 0 or not v.any():
        return past.commands[base], model.noise * model.reach
    # |u J - v|^2 weighted by 1 / (ridge (d / d_1)^2), plus |J|^2, is least at the Jacobian.
    weight = d[0] / d / np.sqrt(model.ridge)
    rows = np.vstack([weight[:, None] * u, np.eye(len(width))])
    target = np.vstack([weight[:, None] * v, np.zeros((len(width), v.shape[1]))])
    jacobian = np.linalg.lstsq(rows, target, rcond=None)[0].T
    damping = np.sqrt(1e-6 * np.sum(jacobian**2))
    damped = np.vstack([jacobian, damping * np.eye(len(width))])
    taken = np.linalg.lstsq(damped, np.append(error, np.zeros(len(width))), rcond=None)[0]
    length = np.sqrt(np.sum(taken**2) / free)
    cut = min(1.0, model.reach / length) if length > 0 else 1.0
    centre = np.clip(past.commands[base] + cut * taken * width, space.low, space.high)
    return centre, model.noise * min(length, model.reach)


@given(
    histories(),
    st.integers(1, 40),
    st.integers(1, 12),
    st.sampled_from([1e-3, 0.01, 1.0]),
    st.sampled_from([0.015, 1.0]),
    st.sampled_from([0.0, 0.3, 1.0]),
    SEEDS,
)
@settings(max_examples=300, deadline=None, derandomize=True)
def test_the_step_is_that_by_singular_values(past, k, used, ridge, reach, noise, seed):
    model = LocalJacobian(k, used, ridge=ridge, reach=reach, noise=noise)
    rng, plain = np.random.default_rng(seed), np.random.default_rng(seed)
    goal = past.sensory_space.sample(np.random.default_rng(seed + 1)) + 0.1
    command = model.command(goal, past, rng)
    assert past.motor_space.contains(command)
    centre, d = step(past, goal, model)
    expected = past.motor_space.bounds.perturb(centre, d, plain)
    range_ = past.motor_space.high - past.motor_space.low
    np.testing.assert_array_less(np.abs(command - expected), 1e-7 * range_ + 1e-14)
    assert state(rng) == state(plain)


def scaled(past, motor, effects):
    """Return the same history in other units."""
    space = past.motor_space
    other = db.History(db.Box(space.low * motor, space.high * motor))
    for command, effect in zip(past.commands, past.effects, strict=True):
        other.append(command * motor, effect * effects)
    return other


@given(histories(), st.sampled_from([2.0**-40, 8.0]), st.sampled_from([2.0**-300, 1024.0]), SEEDS)
@settings(max_examples=60, deadline=None, derandomize=True)
def test_units_do_not_matter(past, motor, effects, seed):
    goal = past.sensory_space.sample(np.random.default_rng(seed)) + 0.1
    model = LocalJacobian(reach=0.1)
    command = model.command(goal, past, np.random.default_rng(0))
    other = scaled(past, motor, effects)
    # Powers of two: not a bit differs.
    again = model.command(goal * effects, other, np.random.default_rng(0))
    assert again.tolist() == (command * motor).tolist()


def test_a_linear_map_is_inverted_in_one_step():
    rng = np.random.default_rng(0)
    past = db.History(db.Box([-9] * 5, [9] * 5))
    matrix = rng.normal(size=(2, 5))
    for command in rng.uniform(-1, 1, size=(40, 5)):
        past.append(command, matrix @ command)
    model = LocalJacobian(ridge=1e-9, reach=1.0, noise=0.0)
    for goal in rng.normal(size=(20, 2)):
        command = model.command(goal, past, rng)
        np.testing.assert_allclose(matrix @ command, goal, atol=1e-4)


def test_where_no_step_can_be_told_the_nearest_command_is_perturbed():
    past, model = (db.History(db.Box([0, 3], [10, 3])), LocalJacobian(reach=0.1, noise=0.5))
    for x in (5.0, 5.0, 9.0):
        past.append([x, 3], [1.0])
        drawn = [model.command([0.0], past, np.random.default_rng(i)) for i in range(200)]
        assert 4.5 <= min(x for x, _ in drawn) < 4.55
        assert 5.45 < max(x for x, _ in drawn) <= 5.5
        assert {y for _, y in drawn} == {3.0}


def test_a_goal_that_was_reached_gives_its_command_again():
    past, rng = db.History(db.Box([0], [1])), np.random.default_rng(0)
    for x in (0.2, 0.5):
        past.append([x], [x])
    assert LocalJacobian().command([0.5], past, rng).tolist() == [0.5]
