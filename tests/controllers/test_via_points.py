"""ViaPoints: through the points at their times, at rest there, smoothly between."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from divbandit.controllers import ViaPoints


@given(
    points=st.integers(1, 6),
    each=st.integers(1, 30),
    dofs=st.integers(1, 4),
    seed=st.integers(0, 99),
)
def test_it_is_at_each_point_in_time(points, each, dofs, seed):
    rng = np.random.default_rng(seed)
    start = rng.uniform(-1, 1, dofs)
    via = ViaPoints([-1.0] * dofs, [1.0] * dofs, steps=points * each, points=points, start=start)
    command = rng.uniform(-1, 1, points * dofs)
    rows = via.trajectory(command)
    assert rows.shape == (points * each + 1, dofs)
    named = np.concatenate([[start], command.reshape(points, dofs)])
    assert rows[::each] == pytest.approx(named, abs=1e-12)
    # Between two points it never leaves the interval between them.
    for k in range(points):
        part = rows[k * each : (k + 1) * each + 1]
        assert (part >= np.minimum(named[k], named[k + 1]) - 1e-12).all()
        assert (part <= np.maximum(named[k], named[k + 1]) + 1e-12).all()


def test_the_jerk_is_least():
    """The course of least jerk is the polynomial of degree 5 that is at rest at both ends."""
    system = np.array(
        [
            [1, 0, 0, 0, 0, 0],  # place, speed and acceleration at 0
            [0, 1, 0, 0, 0, 0],
            [0, 0, 2, 0, 0, 0],
            [1, 1, 1, 1, 1, 1],  # and at 1
            [0, 1, 2, 3, 4, 5],
            [0, 0, 2, 6, 12, 20],
        ]
    )
    polynomial = np.linalg.solve(system, [0, 0, 0, 1, 0, 0])
    time = np.linspace(0, 1, 51)
    rows = ViaPoints([0.0], [1.0], steps=50).trajectory([1.0])
    assert rows[:, 0] == pytest.approx(np.polyval(polynomial[::-1], time), abs=1e-12)


def test_points_that_do_not_divide_the_steps():
    rows = ViaPoints([-1.0], [1.0], steps=5, points=2).trajectory([1.0, -1.0])
    assert rows[-1] == -1
    assert rows[2] == pytest.approx(0.94208)  # 10 x^3 - 15 x^4 + 6 x^5 at x = 4/5
    assert rows[3] == pytest.approx(1 - 2 * 0.05792)


def test_many_are_the_same_bits_as_one_by_one():
    via = ViaPoints([-1.0, -2.0], [1.0, 3.0], steps=17, points=3, start=[0.25, 0.5])
    commands = via.motor_space.sample_many(9, np.random.default_rng(0))
    many = via.trajectory(commands)
    assert many.tobytes() == np.stack([via.trajectory(command) for command in commands]).tobytes()
    assert via.trajectory(np.empty((0, 6))).shape == (0, 18, 2)


@pytest.mark.parametrize(
    ("options", "words"),
    [
        ({"low": [2.0]}, "low"),
        ({"high": [1.0, 2.0]}, "high"),
        ({"steps": 0}, "steps"),
        ({"steps": 2.5}, "steps"),
        ({"points": 0}, "points"),
        ({"points": 5}, "points must be from 1 to 4"),
        ({"start": [0.0, 0.0]}, "start"),
        ({"start": [np.nan]}, "start"),
    ],
)
def test_what_is_refused(options, words):
    arguments = {"low": [0.0], "high": [1.0], "steps": 4} | options
    with pytest.raises((TypeError, ValueError), match=words):
        ViaPoints(**arguments)


def test_commands_outside():
    with pytest.raises(ValueError, match="command"):
        ViaPoints([0.0], [1.0], steps=4).trajectory([1.5])
