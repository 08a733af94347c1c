"""In space: closed forms for one, two and three balls, and slices of more that are degenerate."""

import itertools
import math

import numpy as np
import pytest

import divbandit as db
from tests.reference.balls import EDGES, LATTICES, balls, lattice
from tests.reference.few_balls import union_volume
from tests.reference.slices import sliced_volume

BALL = 4 * math.pi / 3
TAUS = [1e-100, 1e-9, 0.02, 1.0, 1e9, 1e100]


def lens(distance):
    """Return the volume common to two unit balls, for 0 < distance < 2."""
    return math.pi / 12 * (2 - distance) ** 2 * (distance + 4)


def turned(rng):
    """Return a rotation, or a reflection."""
    return np.linalg.qr(rng.standard_normal((3, 3)))[0]


@pytest.mark.parametrize("tau", TAUS)
@pytest.mark.parametrize("distance", [1e-9, 1e-3, 0.3, 1.0, 1.7, 1.999, 2 - 1e-9])
def test_second_ball_gains_all_but_the_lens(distance, tau):
    rng = np.random.default_rng(0)
    for _ in range(5):
        cov = db.Coverage(tau, dim=3)
        other = tau * distance * turned(rng)[0]
        gains = cov.extend([np.zeros(3), other])
        apart = float(np.linalg.norm(other / tau))
        # BALL - lens, without losing digits to the difference.
        expected = math.pi * apart * (1 - apart**2 / 12)
        assert expected == pytest.approx(BALL - lens(apart), abs=1e-14)
        assert gains[1] / tau**3 == pytest.approx(expected, rel=0, abs=1e-14)


def triples():
    """Yield three centres: anywhere, nearly in line, nearly together, and equal sides."""
    rng = np.random.default_rng(1)
    for spread in (0.1, 0.5, 1.0, 1.5):
        for _ in range(40):
            points = spread * rng.uniform(-1, 1, (3, 3))
            yield points
            yield points * np.array([1, 1e-6, 1e-6])
            yield points[[0, 1, 1]] + rng.choice([0, 1e-3, 1e-9], (3, 1)) * points
    for side in (0.1, 1.0, 1.7, 3**0.5, 1.74, 1.99, 2.0):  # sqrt(3): all through one point
        yield side * np.eye(3) @ turned(rng) / 2**0.5


def test_three_balls():
    for points in triples():
        expected = union_volume(points, 1.0)
        for order in itertools.permutations(range(3)):
            found = db.coverage(points[list(order)], 1.0)
            assert found == pytest.approx(expected, rel=1e-14, abs=0), points.tolist()


def test_the_closed_form_is_what_slices_add_up_to():
    for points in itertools.islice(triples(), 0, None, 7):
        assert sliced_volume(points, 1.0) == pytest.approx(union_volume(points, 1.0), rel=1e-9)


@pytest.mark.parametrize("size", [5, 12, 25])
@pytest.mark.parametrize("name", ["random", "coplanar", "through a point"])
def test_slices_of_more(name, size):
    points = balls(name, size, seed=size)
    assert db.coverage(points, 1.0) == pytest.approx(sliced_volume(points, 1.0), rel=1e-11)


@pytest.mark.parametrize("noise", [0, 1e-15, 1e-12, 1e-9, 1e-6, 1e-3])
@pytest.mark.parametrize("edge", EDGES)
def test_lattices_all_but_exact(edge, noise):
    rng = np.random.default_rng(2)
    for name in LATTICES:
        places = lattice(name, 2, edge)
        points = rng.permutation(places + noise * rng.standard_normal(places.shape))[:18]
        assert db.coverage(points, 1.0) == pytest.approx(sliced_volume(points, 1.0), rel=1e-9)


def test_all_thirty_spheres_through_the_origin_on_whole_numbers():
    """Centres at distance exactly 3, with tau = 3."""
    points = [p for p in itertools.product(range(-3, 4), repeat=3) if sum(x * x for x in p) == 9]
    assert len(points) == 30
    rng = np.random.default_rng(3)
    expected = sliced_volume(points, 3.0)
    for _ in range(5):
        assert db.coverage(rng.permutation(points), 3.0) == pytest.approx(expected, rel=1e-12)


def test_a_ball_in_a_hole_and_one_in_what_is_covered():
    """Balls around a cube's corners leave its middle free."""
    corners = 1.3 * np.array([*itertools.product([-1, 1], repeat=3)])
    cov = db.Coverage(1.5, dim=3)
    before = cov.extend(corners).sum()
    assert 8 * cov.largest_gain - 12 * 1.5**3 * lens(2.6 / 1.5) == pytest.approx(before, rel=1e-14)
    hole = sliced_volume([*corners, (0, 0, 0)], 1.5) - before
    assert cov.add([0, 0, 0]) == pytest.approx(hole, abs=1e-10)
    assert cov.add([1e-3, 0, 0]) > 0
    assert cov.add([0.5e-3, 0, 0]) == pytest.approx(0, abs=1e-9)
