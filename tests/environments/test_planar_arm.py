"""The planar arm's kinematics, against the definition evaluated with 50 digits and with NumPy."""

import math

import mpmath
import numpy as np
import pytest

import divbandit as db


def exact_tip(command):
    """Return the tip with 50 digits: each segment points along the sum of the angles so far."""
    with mpmath.workdps(50):
        heading, x, y = mpmath.mpf(0), mpmath.mpf(0), mpmath.mpf(0)
        for angle in command:
            heading += mpmath.mpf(float(angle))
            x += mpmath.cos(heading)
            y += mpmath.sin(heading)
        return float(x / len(command)), float(y / len(command))


def commands_of(arm, n, seed=0):
    rng = np.random.default_rng(seed)
    return rng.uniform(-arm.limit, arm.limit, (n, arm.joints))


@pytest.mark.parametrize("limit", [0.01, math.radians(150), math.pi, 100.0])
@pytest.mark.parametrize("joints", [1, 2, 3, 7, 8, 9, 16, 20, 100])
def test_the_tip_is_right_to_rounding(joints, limit):
    arm = db.PlanarArm(joints, limit=limit)
    heading = 2.3e-16 * max(1.0, joints * limit)  # the sum of angles is rounded
    for command in commands_of(arm, 20):
        assert arm(command) == pytest.approx(exact_tip(command), abs=4e-16 + heading * joints**0.5)


@pytest.mark.parametrize("n", [0, 1, 2, 7, 8, 9, 15, 16, 17, 100])
@pytest.mark.parametrize("joints", [1, 3, 8, 20])
def test_many_at_once_are_the_same_bits_as_one_by_one(joints, n):
    arm = db.PlanarArm(joints)
    commands = commands_of(arm, n)
    tips = arm(commands)
    assert tips.shape == (n, 2)
    assert tips.tolist() == [arm(command).tolist() for command in commands]


@pytest.mark.parametrize("joints", [1, 2, 8, 20])
def test_the_posture_ends_at_the_tip(joints):
    arm = db.PlanarArm(joints)
    for command in commands_of(arm, 50):
        posture = arm.posture(command)
        assert posture.shape == (joints + 1, 2)
        assert posture[0].tolist() == [0, 0]
        assert posture[-1].tolist() == arm(command).tolist()
        lengths = np.hypot(*np.diff(posture, axis=0).T)
        assert lengths == pytest.approx(np.full(joints, 1 / joints), rel=1e-13)
        turned = np.diff(np.unwrap(np.arctan2(*np.diff(posture, axis=0).T[::-1])))
        wrapped = np.mod(command[1:] - turned + math.pi, 2 * math.pi) - math.pi
        assert wrapped == pytest.approx(np.zeros(joints - 1), abs=1e-12)


def test_the_papers_arm():
    arm = db.PlanarArm()
    assert (arm.joints, arm.limit) == (20, math.radians(150))
    assert arm.motor_space == db.Box([-math.radians(150)] * 20, [math.radians(150)] * 20)
    assert arm.sensory_space == db.Box([-1, -1], [1, 1])
    assert arm(np.zeros(20)).tolist() == [1, 0]


def test_limits_are_included():
    arm = db.PlanarArm(2, limit=1.0)
    assert arm([1.0, -1.0]) == pytest.approx(exact_tip([1.0, -1.0]), abs=1e-15)
    with pytest.raises(ValueError, match=r"command\[1\]"):
        arm([1.0, math.nextafter(1.0, 2.0)])


@pytest.mark.parametrize(
    "changed",
    [
        lambda x: x.tolist(),
        np.asfortranarray,
        lambda x: np.repeat(x, 2, axis=1)[:, ::2],
        lambda x: x.astype(">f8"),
        lambda x: x[::-1][::-1],
    ],
    ids=["list", "Fortran order", "strided", "big-endian", "reversed twice"],
)
def test_any_layout_of_the_same_numbers(changed):
    arm = db.PlanarArm(4)
    commands = commands_of(arm, 10)
    assert arm(changed(commands)).tolist() == arm(commands).tolist()


def test_whole_numbers_are_numbers():
    arm = db.PlanarArm(2)
    assert arm(np.array([1, -1])).tolist() == arm([1.0, -1.0]).tolist()
    assert arm(np.array([1, 2], dtype=np.uint8)).tolist() == arm([1.0, 2.0]).tolist()
