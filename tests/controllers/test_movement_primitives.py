"""Movement primitives: against another library's, and laws of what is linear."""

import numpy as np
import pytest
from movement_primitives.dmp import DMP

from divbandit.controllers import MovementPrimitives


def of_the_library(primitives, command, steps):
    """Return the trajectory by the library's own integration, in so many steps."""
    weights = command.reshape(primitives.dofs, -1)
    dmp = DMP(primitives.dofs, execution_time=1.0, dt=1 / steps, n_weights_per_dim=primitives.basis)
    goals = primitives.start if primitives.goals is None else weights[:, primitives.basis]
    dmp.configure(start_y=np.array(primitives.start), goal_y=np.array(goals))
    dmp.set_weights((weights[:, : primitives.basis] * primitives.scales).ravel())
    rows = dmp.open_loop()[1]
    return rows[:: steps // primitives.steps]


@pytest.mark.parametrize("goals", [None, 0.7])
@pytest.mark.parametrize(("dofs", "basis", "steps"), [(1, 2, 10), (2, 5, 50), (7, 9, 25)])
def test_the_library_converges_to_it(dofs, basis, steps, goals):
    rng = np.random.default_rng(dofs)
    primitives = MovementPrimitives(
        dofs, basis=basis, steps=steps, weights=0.5, goals=goals, start=rng.uniform(-1, 1, dofs)
    )
    command = primitives.motor_space.sample(rng)
    ours = primitives.trajectory(command)
    # The library's steps are of the first order, as it looks at the force one step late: with ten
    # times as many it is ten times as near.
    coarse, fine = (
        np.abs(of_the_library(primitives, command, count) - ours).max() for count in (1000, 10000)
    )
    assert fine < 2e-3
    assert fine < 0.12 * coarse


def test_a_weight_of_one_moves_a_joint_by_one():
    primitives = MovementPrimitives(1, basis=4, steps=100, goals=None)
    moved = primitives.trajectory(np.eye(4))
    np.testing.assert_allclose(np.abs(moved).max(axis=1), 1.0, rtol=1e-12)
    assert (moved[:, 0] == 0).all()


def test_it_ends_at_its_goal_but_for_what_the_last_bumps_leave():
    primitives = MovementPrimitives(1, steps=100)
    ends = primitives.trajectory(np.eye(6))[:, -1, 0]
    np.testing.assert_allclose(ends, [0.015, 0.027, 0.132, 0.578, 0.835, 1.0], atol=1e-3)


def test_it_is_linear_and_joints_do_not_mix():
    primitives = MovementPrimitives(3, basis=4, steps=20)
    rng = np.random.default_rng(0)
    one, other = primitives.motor_space.sample_many(2, rng) / 2
    both = primitives.trajectory(one) + primitives.trajectory(other)
    np.testing.assert_allclose(primitives.trajectory(one + other), both, atol=1e-13)
    third = one.copy()
    third[5:10] = other[5:10]
    same = primitives.trajectory(third) == primitives.trajectory(one)
    assert same.all(axis=0).tolist() == [True, False, True]


def test_many_at_once_are_the_same_bits_as_one_by_one():
    primitives = MovementPrimitives(4, start=[0.1, 0.2, 0.3, 0.4], limit=0.5)
    commands = primitives.motor_space.sample_many(30, np.random.default_rng(1))
    many = primitives.trajectory(commands)
    assert many.shape == (30, 51, 4)
    assert np.array_equal(many, [primitives.trajectory(command) for command in commands])
    assert np.abs(many).max() == 0.5
    assert primitives.trajectory(commands[:0]).shape == (0, 51, 4)
