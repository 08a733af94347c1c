"""Boxes: corners, equality, membership and uniform draws.

Uniformity is tested by a Kolmogorov-Smirnov test at level 1e-4, with a fixed seed.
"""

from types import SimpleNamespace

import numpy as np
import pytest
from scipy import stats

import divbandit as db

BOX = db.Box([-1, 0, 5], [1, 10, 5])


def test_corners_are_read_only_copies():
    low = np.zeros(2)
    box = db.Box(low, [1, 1])
    low[0] = 0.5
    assert box.low.tolist() == [0, 0]
    for corner in (box.low, box.high):
        with pytest.raises(ValueError, match="read-only"):
            corner[0] = 9


@pytest.mark.parametrize(
    ("point", "inside"),
    [
        ([0, 5, 5], True),
        ([-1, 0, 5], True),
        ([1, 10, 5], True),
        ([1 + 1e-15, 10, 5], False),
        ([0, 5, 5 - 1e-15], False),
        ([0, -1e-300, 5], False),
    ],
)
def test_contains_its_faces(point, inside):
    assert BOX.contains(point) is inside


def test_samples_are_uniform():
    rng = np.random.default_rng(0)
    points = np.array([BOX.sample(rng) for _ in range(5000)])
    assert all(BOX.contains(point) for point in points)
    assert stats.kstest(points[:, 0], stats.uniform(-1, 2).cdf).pvalue > 1e-4
    assert stats.kstest(points[:, 1], stats.uniform(0, 10).cdf).pvalue > 1e-4
    assert np.all(points[:, 2] == 5)


def test_samples_never_leave_the_box_by_rounding():
    """Between neighbouring numbers only the two ends exist."""
    low = np.array([1.0, 0.1, -1e308, 5e-324])
    high = np.array([np.nextafter(1.0, 2), np.nextafter(0.1, 1), 7e307, 1e-323])
    box, rng = db.Box(low, high), np.random.default_rng(0)
    assert all(box.contains(box.sample(rng)) for _ in range(1000))


def test_equality_and_hash():
    same = db.Box([-1.0, -0.0, 5], (1, 10, 5))
    assert same == BOX
    assert hash(same) == hash(BOX)
    assert db.Box([-1, 0, 5], [1, 10, 6]) != BOX
    assert db.Box([-1], [1]) != BOX
    assert BOX != "a box"


def test_anything_with_corners_is_a_box():
    corners = SimpleNamespace(low=np.float32([0, 0]), high=np.float32([0.5, 1]))
    assert db.Box.of(corners) == db.Box([0, 0], [0.5, 1])
    assert db.Box.of(BOX) is BOX
    run = db.explore(
        db.FunctionEnvironment(lambda x: x, corners, corners), db.GoalBabbling(), n=5, rng=0
    )
    assert run.motor_space == run.sensory_space == db.Box([0, 0], [0.5, 1])
