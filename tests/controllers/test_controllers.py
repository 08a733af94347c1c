"""Controllers: actions worked out by hand, and what is refused."""

import math
from types import SimpleNamespace

import numpy as np
import pytest

import divbandit as db
from divbandit.controllers import (
    Controller,
    FunctionController,
    MovementPrimitives,
    OpenLoop,
    Tracking,
    Trajectories,
    ViaPoints,
)


class Ramp:
    """From 0 to the command in two steps, all joints alike."""

    motor_space = db.Box([-4, -4], [4, 4])

    def trajectory(self, command):
        return np.linspace(np.zeros(2), command, 3)


def first_two(seen):
    return seen[:2]


def last_two(seen):
    return seen[2:]


def tracking(primitives=None, **options):
    usual = {"dt": 0.5, "stiffness": 2.0, "damping": 0.25}
    return Tracking(primitives or Ramp(), first_two, last_two, **usual | options)


def pure(errors, speeds, stiffness, damping):
    """Return the formula of springs and dampers, joint by joint."""
    return [k * e + d * v for k, d, e, v in zip(stiffness, damping, errors, speeds, strict=True)]


def test_tracking_pulls_towards_the_next_row_at_its_speed():
    act = tracking().begin(np.array([1.0, -2.0]))
    seen = np.array([0.1, 0.2, 0.3, 0.4])
    # Rows are 0, (0.5, -1), (1, -2); speeds (1, -2).
    expected = pure([0.5 - 0.1, -1 - 0.2], [1 - 0.3, -2 - 0.4], [2, 2], [0.25, 0.25])
    np.testing.assert_allclose(act(0, seen), expected, rtol=1e-15)
    expected = pure([1 - 0.1, -2 - 0.2], [1 - 0.3, -2 - 0.4], [2, 2], [0.25, 0.25])
    np.testing.assert_allclose(act(1, seen), expected, rtol=1e-15)


def test_tracking_holds_the_last_row():
    act = tracking().begin(np.array([1.0, -2.0]))
    seen = np.array([0.1, 0.2, 0.3, 0.4])
    expected = pure([1 - 0.1, -2 - 0.2], [-0.3, -0.4], [2, 2], [0.25, 0.25])
    for step in (2, 3, 100):
        np.testing.assert_allclose(act(step, seen), expected, rtol=1e-15)


def test_each_joint_may_have_its_own_strength():
    act = tracking(stiffness=[1, 3], damping=[0, 0.5], limit=[9, 0.125]).begin(np.array([1.0, 1.0]))
    np.testing.assert_allclose(act(0, np.zeros(4)), [0.5, 0.125])
    act = tracking(stiffness=[1, 3], damping=[0, 0.5]).begin(np.array([1.0, 1.0]))
    np.testing.assert_allclose(act(0, np.zeros(4)), [0.5, 3 * 0.5 + 0.5 * 1])


def test_actions_are_limited_either_way():
    act = tracking(limit=0.25).begin(np.array([4.0, -4.0]))
    assert act(0, np.zeros(4)).tolist() == [0.25, -0.25]


def test_a_body_without_friction_follows():
    """A mass of 1 on each joint, integrated in small steps, ends where it is led."""
    points = ViaPoints([-1, -1], [1, 1], steps=50, points=2)
    pd = Tracking(points, first_two, last_two, dt=0.1, stiffness=40.0, damping=12.0)
    command = np.array([0.5, -0.5, -0.75, 0.25])
    act, q, v = pd.begin(command), np.zeros(2), np.zeros(2)
    for step in range(60):
        action = act(step, np.concatenate([q, v]))
        for _ in range(10):
            v += 0.01 * action
            q += 0.01 * v
    np.testing.assert_allclose(q, command[2:], atol=0.02)


@pytest.mark.parametrize("way", [1, -1])
def test_turns_are_counted(way):
    """Positions known up to a turn are followed through pi, where a plain difference jumps."""
    act = tracking(turns=True, damping=0).begin(way * np.array([4.0, 0.0]))
    jumping = tracking(damping=0).begin(way * np.array([4.0, 0.0]))
    place = way * 3.0
    for _ in range(3):
        place += way * 0.25
        wrapped = math.remainder(place, math.tau)
        seen = np.array([wrapped, 0, 0, 0])
        pull = act(1, seen)[0]
        if abs(place) > math.pi:
            assert jumping(1, seen)[0] == pytest.approx(2 * (way * 4 - wrapped))
            assert abs(jumping(1, seen)[0]) > 12
        # Nearest to the start, 0, the first is what it is; the others are nearest to it.
        known = place if abs(way * 3.25) < math.pi else place - way * math.tau
        assert pull == pytest.approx(2 * (way * 4 - known))


def test_turns_begin_nearest_to_the_start():
    points = ViaPoints([-9], [9], steps=4, start=[6.5])
    pd = Tracking(
        points,
        lambda seen: seen[:1],
        lambda seen: seen[1:],
        dt=1,
        stiffness=1,
        damping=0,
        turns=True,
    )
    act = pd.begin(np.array([6.5]))
    assert act(0, np.array([6.5 - math.tau, 0]))[0] == pytest.approx(0, abs=1e-12)


def test_episodes_of_one_controller_do_not_disturb_each_other():
    pd = tracking(turns=True)
    first, second = pd.begin(np.array([4.0, 4.0])), pd.begin(np.array([4.0, 4.0]))
    for place in np.arange(0, 9, 0.5):
        first(0, np.array([math.remainder(place, math.tau)] * 2 + [0, 0]))
    fresh = pd.begin(np.array([4.0, 4.0]))
    np.testing.assert_array_equal(second(0, np.zeros(4)), fresh(0, np.zeros(4)))
    assert (first(0, np.zeros(4)) != fresh(0, np.zeros(4))).all()


def test_open_loop_plays_rows_and_stays_at_the_last():
    act = OpenLoop(Ramp()).begin(np.array([1.0, -2.0]))
    played = [act(step, "not looked at").tolist() for step in range(5)]
    assert played == [[0, 0], [0.5, -1], [1, -2], [1, -2], [1, -2]]


def test_a_function_gets_command_step_and_observation():
    given = []
    controller = FunctionController(lambda *all_: given.append(all_), db.Box([0], [1]))
    controller.begin("command")(7, "observation")
    assert given == [("command", 7, "observation")]
    assert isinstance(controller, Controller)


@pytest.mark.parametrize("make", [tracking, OpenLoop, lambda p: tracking(p, turns=True)])
@pytest.mark.parametrize(
    ("rows", "error", "says"),
    [
        ([0.0, 1.0], ValueError, r"primitives\.trajectory must return .*got \(2,\)"),
        (np.zeros((0, 2)), ValueError, r"primitives\.trajectory must return"),
        ([[0, 0], [0, np.nan]], ValueError, "got nan in row 1, column 1"),
        ("ab", TypeError, "primitives.trajectory must return an array of numbers, got 'ab'"),
        ([[0], [0, 1]], TypeError, "primitives.trajectory must return an array of numbers"),
        (None, ValueError, "primitives.trajectory must return"),
    ],
)
def test_trajectories_that_are_none(make, rows, error, says):
    primitives = SimpleNamespace(motor_space=db.Box([0], [1]), trajectory=lambda _: rows)
    with pytest.raises(error, match=says):
        make(primitives).begin(np.zeros(1))


def test_readings_must_be_callable_and_fit():
    for name in ("positions", "velocities"):
        readings = {"positions": first_two, "velocities": last_two} | {name: 3}
        with pytest.raises(TypeError, match=f"{name} must be callable, got int"):
            Tracking(Ramp(), **readings, dt=1, stiffness=1, damping=1)
    act = tracking().begin(np.zeros(2))
    with pytest.raises(ValueError, match="positions"):
        act(0, np.zeros(1))
    with pytest.raises(ValueError, match="velocities"):
        act(0, np.zeros(3))
    with pytest.raises(ValueError, match=r"velocities\[0\] must be finite"):
        act(0, np.array([0, 0, np.nan, 0]))
    with pytest.raises(ValueError, match="stiffness must be one number or one for each of 2"):
        tracking(stiffness=[1, 2, 3]).begin(np.zeros(2))


def test_primitives_of_the_library_make_trajectories():
    for primitives in (MovementPrimitives(2), ViaPoints([0, 0], [1, 1], steps=3), Ramp()):
        assert isinstance(primitives, Trajectories)
        assert isinstance(tracking(primitives), Controller)
        assert tracking(primitives).motor_space == primitives.motor_space
