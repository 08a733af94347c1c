"""An array that another thread changes during a call does no harm beyond its own numbers."""

import threading

import numpy as np
import pytest

import divbandit as db


@pytest.fixture
def restless():
    """Points of the unit square that are turned into NaN and back all the time."""
    points = np.random.default_rng(0).random((20_000, 2))
    fine = points.copy()
    done = threading.Event()

    def change():
        while not done.is_set():
            points[:] = np.nan
            points[:] = fine

    thread = threading.Thread(target=change)
    thread.start()
    yield points
    done.set()
    thread.join()


def accepted(call, points):
    """Call until the points were accepted once or refused often."""
    for _ in range(30):
        try:
            return call(points)
        except ValueError as error:
            assert "must be finite" in str(error)  # noqa: PT017 - both outcomes are right
    return None


def test_neighbours_are_found_among_points_that_exist(restless):
    tree = db.NearestNeighbors(2)
    accepted(tree.extend, restless)
    if len(tree):
        distance, index = tree.nearest([0.5, 0.5])
        assert 0 <= distance < 1
        assert index < len(tree)


def test_coverage_stays_within_the_square(restless):
    area = accepted(lambda points: db.coverage(points, 0.01), restless)
    assert area is None or 0.9 < area < 1.1
