"""Controlled: an arm and a ball, moved by movement primitives."""

import pickle
from types import SimpleNamespace

import numpy as np
import pytest

import divbandit as db
from divbandit.controllers import MovementPrimitives
from divbandit.environments import Controlled, Disc, PushArm, Wall


class Ramp:
    """Straight to the command, and back for a second of two rows."""

    motor_space = db.Box([-1, -1], [1, 1])

    def trajectory(self, command):
        return [[0.0, 0.0], command]


def test_a_straight_trajectory_is_the_arm_itself():
    arm = db.PlanarArm(2, obstacles=[Disc([0.5, 0.5], 0.1)])
    moved = Controlled(arm, Ramp())
    commands = moved.motor_space.sample_many(50, np.random.default_rng(0))
    np.testing.assert_array_equal(moved(commands), arm(commands))
    np.testing.assert_array_equal(moved(commands[0]), arm(commands[0]))
    assert moved(commands[:0]).shape == (0, 2)
    assert moved.sensory_space == arm.sensory_space


@pytest.mark.parametrize("body", [db.PlanarArm, PushArm])
def test_movement_primitives_drive_arms(body):
    arm = body(4, obstacles=[Wall([-1, 0.7], [1, 0.7])])
    primitives = MovementPrimitives(4, basis=3, steps=20, weights=2.0, limit=arm.limit)
    moved = pickle.loads(pickle.dumps(Controlled(arm, primitives)))  # noqa: S301 - just written
    adapt = db.Adapt([db.MotorBabbling(), db.GoalBabbling(0.05)], tau=0.02)
    run = db.explore(moved, adapt, 200, rng=0)
    for command, effect in zip(run.commands[:20], run.effects, strict=False):
        np.testing.assert_array_equal(arm.follow(primitives.trajectory(command)), effect)
    assert run.coverage(0.02)[-1] > 0.02


def test_what_is_refused():
    arm = db.PlanarArm(2)
    with pytest.raises(TypeError, match="body must have follow"):
        Controlled(Ramp(), Ramp())
    with pytest.raises(TypeError, match="controller must have trajectory"):
        Controlled(arm, arm)
    with pytest.raises(ValueError, match="trajectory must have shape"):
        Controlled(db.PlanarArm(3), Ramp())([0.5, 0.5])
    far = SimpleNamespace(motor_space=db.Box([0], [9]), trajectory=lambda x: [[0, 0], [x[0], 0]])
    with pytest.raises(ValueError, match="within the joint's limit"):
        Controlled(arm, far)([9.0])
    nowhere = SimpleNamespace(sensory_space=None, follow=lambda _: [np.nan])
    with pytest.raises(ValueError, match="effect"):
        Controlled(nowhere, Ramp())([0.0, 0.0])
