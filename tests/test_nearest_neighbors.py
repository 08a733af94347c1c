"""The k-d tree finds exactly what looking at all points finds, ties and all."""

import copy

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

import divbandit as db
from tests.reference.families import FAMILIES, family
from tests.reference.nearest import nearest

DIMENSIONS = range(1, 17)


def queries(points, rng):
    """Return points of the set, points beside it, and points far away."""
    some = points[rng.integers(len(points), size=4)]
    return [*some, *(some[:2] + 1e-9), *rng.uniform(-1.5, 1.5, (4, points.shape[1]))]


def assert_same(tree, points, query, k):
    distance, index = tree.nearest(query, k=k)
    expected = nearest(points, query, k)
    if k == 1:
        assert (distance, index) == (expected[0][0], expected[1][0])
    else:
        assert distance.tolist() == expected[0].tolist()
        assert index.tolist() == expected[1].tolist()


@pytest.mark.parametrize("dim", DIMENSIONS)
@pytest.mark.parametrize("name", FAMILIES)
def test_equals_brute_force(name, dim):
    points = family(name, 400, dim, seed=dim)
    tree = db.NearestNeighbors(dim)
    tree.extend(points)
    for query in queries(points, np.random.default_rng(dim)):
        for k in (1, 2, 7, 40, 400):
            assert_same(tree, points, query, k)


@pytest.mark.parametrize("dim", [1, 2, 5])
@pytest.mark.parametrize("name", FAMILIES)
def test_equals_brute_force_while_it_grows(name, dim):
    points = family(name, 300, dim, seed=9)
    tree = db.NearestNeighbors(dim)
    rng = np.random.default_rng(0)
    for n, point in enumerate(points, start=1):
        tree.add(point)
        assert len(tree) == n
        for query in (point, rng.uniform(-1, 1, dim)):
            assert_same(tree, points[:n], query, 1)
        assert_same(tree, points[:n], rng.uniform(-1, 1, dim), min(n, 5))


lattice = st.tuples(st.integers(0, 3), st.integers(0, 3))


@given(st.lists(lattice, min_size=1), st.tuples(st.integers(0, 6), st.integers(0, 6)), st.data())
def test_ties_go_to_the_earliest(points, doubled, data):
    """On a coarse lattice nearly all distances are shared."""
    tree = db.NearestNeighbors(2)
    tree.extend(points)
    query = np.array(doubled) / 2
    assert_same(tree, points, query, 1)
    assert_same(tree, points, query, data.draw(st.integers(1, len(points))))


def test_a_thousand_times_the_same_point():
    tree = db.NearestNeighbors(3)
    tree.extend(np.ones((1000, 3)))
    assert tree.nearest([1, 1, 1]) == (0.0, 0)
    assert tree.nearest([0, 1, 1], k=1000)[1].tolist() == list(range(1000))


@pytest.mark.parametrize("duplicate", [copy.copy, copy.deepcopy])
def test_a_copy_goes_its_own_way(duplicate):
    tree = db.NearestNeighbors(1)
    tree.extend([[0.0], [1.0]])
    other = duplicate(tree)
    other.add([0.4])
    assert (len(tree), len(other), other.dim) == (2, 3, 1)
    assert tree.nearest([0.4]) == (0.4, 0)
    assert other.nearest([0.4]) == (0.0, 2)
