"""One object in many threads: what it returns is right, or it says that it is in use."""

import copy
from functools import partial

import numpy as np
import pytest

import divbandit as db
from tests.generators import state, twins
from tests.threads import at_once

THREADS, EACH, ROWS = 8, 40, 200
POINTS = np.random.default_rng(0).uniform(-1, 1, (THREADS, EACH, ROWS, 2))


def unless_in_use(call, *args):
    """Return what the call returns; None if another thread is within the object."""
    try:
        return call(*args)
    except RuntimeError as error:
        assert "already" in str(error).lower()  # noqa: PT017 - both outcomes are right
        return None


def in_threads(work):
    """Let each thread do its work on its own points, and return all that came of it."""
    results = at_once(
        partial(lambda thread: [work(points) for points in POINTS[thread]], thread)
        for thread in range(THREADS)
    )
    return [result for of_thread in results for result in of_thread]


def one_by_one(cov):
    """Return the gains and the measure of its effects where one thread adds them in that order."""
    again = db.Coverage(cov.tau, dim=cov.dim)
    return again.extend(cov.effects), again.measure


class Meanwhile:
    """Points that, when a call reads them, first let other threads make calls of their own."""

    def __init__(self, points, calls):
        self.points, self.calls, self.found = np.array(points, dtype=float), calls, None

    def __array__(self, dtype=None, copy=None):
        self.found = at_once(partial(unless_in_use, call) for call in self.calls)
        return self.points


@pytest.mark.parametrize("method", ["add", "extend", "gain", "contains"])
def test_a_coverage_that_is_in_use_says_so(method):
    cov = db.Coverage(0.1)
    cov.add([0.5, 0.5])
    meanwhile = Meanwhile(
        [[0.25, 0.25]] if method == "extend" else [0.25, 0.25],
        [
            lambda: len(cov),
            lambda: cov.measure,
            lambda: cov.effects,
            lambda: cov.add([0, 0]),
            lambda: cov.extend([[0, 0]]),
            lambda: cov.gain([0, 0]),
            lambda: cov.contains([0, 0]),
            lambda: cov.contribution(0),
            cov.boundary,
            lambda: copy.copy(cov),
        ],
    )
    outcome = getattr(cov, method)(meanwhile)
    assert meanwhile.found == [None] * len(meanwhile.calls)
    again = db.Coverage(0.1)
    again.add([0.5, 0.5])
    assert outcome == getattr(again, method)(meanwhile.points)
    assert cov.effects.tolist() == again.effects.tolist()


@pytest.mark.parametrize("method", ["add", "extend"])
def test_a_tree_that_grows_says_so(method):
    tree = db.NearestNeighbors(2)
    tree.add([0, 0])
    meanwhile = Meanwhile(
        [[1, 1]] if method == "extend" else [1, 1],
        [
            lambda: len(tree),
            lambda: tree.nearest([0, 0]),
            lambda: tree.extend([[2, 2]]) or "added",
            lambda: tree.add([2, 2]) or "added",
            lambda: copy.copy(tree),
        ],
    )
    getattr(tree, method)(meanwhile)
    assert meanwhile.found == [None] * len(meanwhile.calls)
    assert len(tree) == 2
    assert tree.nearest([2, 2]) == (np.sqrt(2), 1)


def test_a_tree_is_searched_by_all_at_once():
    tree = db.NearestNeighbors(2)
    tree.extend([[0, 0], [1, 0]])
    meanwhile = Meanwhile(
        [1, 0],
        [lambda: tree.nearest([0, 3]), lambda: len(tree), lambda: tree.add([1, 0]) or "added"],
    )
    assert tree.nearest(meanwhile) == (0, 1)
    assert meanwhile.found == [(3, 0), 2, None]
    assert len(tree) == 2


def test_effects_are_added_to_one_coverage_singly():
    cov = db.Coverage(0.05)
    gains = in_threads(lambda points: [unless_in_use(cov.add, point) for point in points[:20]])
    gains = [gain for of_call in gains for gain in of_call if gain is not None]
    assert 0 < len(gains) == len(cov)
    assert sorted(gains) == sorted(cov.gains.tolist())
    expected, measure = one_by_one(cov)
    assert cov.gains.tolist() == expected.tolist()
    assert cov.measure == measure


def test_effects_are_added_to_one_coverage_in_batches():
    """A batch goes in whole, in one piece, or not at all."""
    cov = db.Coverage(0.01)
    batches = in_threads(lambda points: (points, unless_in_use(cov.extend, points)))
    added = [(points, gains) for points, gains in batches if gains is not None]
    assert 0 < len(added) * ROWS == len(cov)
    expected, measure = one_by_one(cov)
    assert cov.gains.tolist() == expected.tolist()
    assert cov.measure == measure
    pieces = {
        (effects.tobytes(), gains.tobytes())
        for effects, gains in zip(
            cov.effects.reshape(-1, ROWS, 2), cov.gains.reshape(-1, ROWS), strict=True
        )
    }
    assert pieces == {(points.tobytes(), gains.tobytes()) for points, gains in added}


def test_one_coverage_is_asked_while_it_grows():
    """What was asked between two insertions is what it is between two insertions."""
    cov = db.Coverage(0.01)
    disc = cov.largest_gain

    def work(points):
        unless_in_use(cov.extend, points)
        gain = unless_in_use(cov.gain, points[0])
        return gain, unless_in_use(len, cov), unless_in_use(lambda: cov.measure)

    seen = in_threads(work)
    ends = {0.0, *np.cumsum(cov.gains.reshape(-1, ROWS).sum(axis=1)).tolist()}
    assert any(gain is not None for gain, _, _ in seen)
    for gain, length, measure in seen:
        assert gain is None or 0 <= gain <= disc
        assert length is None or length % ROWS == 0
        assert length is None or length <= len(cov)
        # Summed in another order: far less than the disc that would tell two lengths apart.
        assert measure is None or min(abs(measure - end) for end in ends) < 1e-6 * disc


def test_points_are_added_to_one_tree_and_found_in_it():
    tree = db.NearestNeighbors(2)

    def work(points):
        added = unless_in_use(lambda: tree.extend(points) is None)
        return points, added, unless_in_use(tree.nearest, points[7])

    seen = in_threads(work)
    added = [(points, found) for points, was_added, found in seen if was_added]
    assert 0 < len(added) * ROWS == len(tree)
    for points, found in added:
        distance, index = tree.nearest(points[7])
        assert distance == 0
        assert index % ROWS == 7
        assert found in (None, (distance, index))


def test_points_are_added_to_one_tree_singly():
    tree = db.NearestNeighbors(2)

    def work(points):
        return [
            (point, unless_in_use(lambda point=point: tree.add(point) is None))
            for point in points[:20]
        ]

    added = [point for of_call in in_threads(work) for point, was_added in of_call if was_added]
    assert 0 < len(added) == len(tree)
    found = [tree.nearest(point) for point in added]
    assert {distance for distance, _ in found} == {0.0}
    assert sorted(index for _, index in found) == list(range(len(added)))


@pytest.mark.parametrize("joints", [3, 20])
def test_one_arm_is_moved_by_all(joints):
    """It has no state that a call could change: every call is right."""
    arm = db.PlanarArm(joints)
    commands = np.random.default_rng(0).uniform(-1, 1, (THREADS, EACH, ROWS, joints))

    def moved(thread):
        return [(arm(batch), arm(batch[0]), arm.posture(batch[1])) for batch in commands[thread]]

    for found, batches in zip(
        at_once(partial(moved, thread) for thread in range(THREADS)), commands, strict=True
    ):
        for (effects, effect, posture), batch in zip(found, batches, strict=True):
            assert effects.tobytes() == db.PlanarArm(joints)(batch).tobytes()
            assert effect.tobytes() == effects[0].tobytes()
            assert posture[-1].tobytes() == effects[1].tobytes()


def test_one_box_is_drawn_from_by_all():
    box = db.Box([-1, 2, 5], [1, 2, 7])

    def drawn(thread):
        rng, plain = twins(np.random.PCG64, thread)
        points = [box.sample(rng) for _ in range(1000)]
        expected = box.low + (box.high - box.low) * plain.random((1000, 3))
        assert [point.tolist() for point in points] == expected.tolist()
        assert all(box.contains(point) for point in points)
        assert state(rng) == state(plain)
        return len(points)

    assert at_once(partial(drawn, thread) for thread in range(THREADS)) == [1000] * THREADS
