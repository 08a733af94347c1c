"""Where numbers are at their worst: huge and tiny distances, exact tangencies, common points."""

import itertools
import math
from itertools import permutations

import numpy as np
import pytest

import divbandit as db
from tests.reference.few_balls import union_volume
from tests.reference.intervals import union_length
from tests.reference.many_digits import exact_area
from tests.reference.rows_of_balls import ball, overlap
from tests.reference.sections import section_area

TRUTH = {
    1: lambda points, tau: float(union_length(np.ravel(points), tau)),
    2: exact_area,
    3: union_volume,
}
ALL = [1, 2, 3, 5]
LARGEST = float(np.finfo(float).max)


def steps(rng, n, dim, tau):
    """Return `n` points, each 1e-9 to 1e9 tau away from another; two are equal."""
    points = [np.zeros(dim)]
    while len(points) < n - 1:
        direction = rng.standard_normal(dim)
        length = tau * 10.0 ** rng.uniform(-9, 9) / np.linalg.norm(direction)
        points.append(points[rng.integers(len(points))] + length * direction)
    return rng.permutation([*points, points[-1]])


@pytest.mark.parametrize("tau", [1e-100, 0.02, 1.0, 1e100])
@pytest.mark.parametrize(("dim", "n"), [(1, 20), (2, 12), (3, 4)])
def test_from_1e_9_to_1e9_tau_apart(dim, n, tau):
    rng = np.random.default_rng(dim)
    for _ in range(20):
        points = steps(rng, n, dim, tau)
        for order in (points, points[::-1]):
            total = db.coverage(order, tau)
            assert total == pytest.approx(TRUTH[dim](points, tau), rel=1e-13, abs=0)


@pytest.mark.parametrize("dim", ALL)
def test_second_ball_at_any_distance(dim):
    """What it gains, to some digits even where that is little."""
    for distance in 10.0 ** np.arange(-9, 10):
        cov = db.Coverage(1.0, dim=dim, rng=0)
        found = cov.extend([[0.0] * dim, [*[0.0] * (dim - 1), distance]])[1]
        # Near 0 a ball gains its section times the distance.
        expected = 1 - overlap(distance, dim) if distance > 1e-3 else None
        if expected is None:
            section = ball(dim - 1, 1.0) / ball(dim, 1.0) if dim > 1 else 0.5
            expected = section * distance
        assert found / cov.largest_gain == pytest.approx(expected, rel=1e-6, abs=1e-13)


@pytest.mark.parametrize("tau", [1e-60, 1e-9, 1.0, 1e60])
@pytest.mark.parametrize("dim", ALL)
@pytest.mark.parametrize("far", [1e300, LARGEST, LARGEST / 2])
def test_as_far_as_numbers_go(dim, tau, far):
    corners = np.array([*itertools.product([-far, 0.0, far], repeat=dim)])
    corners = corners[:: max(1, len(corners) // 30)]
    cov = db.Coverage(tau, dim=dim, rng=0)
    gains = cov.extend(corners)
    assert gains.tolist() == [cov.largest_gain] * len(corners)
    assert cov.gain(corners).tolist() == [0.0] * len(corners)
    assert cov.contains(corners).all()
    assert not cov.contains(corners[0] / 3)
    assert cov.contribution(0) == cov.largest_gain


@pytest.mark.parametrize("dim", ALL)
@pytest.mark.parametrize("exponent", [-320, -308, -200, -17, 17, 200, 308])
def test_no_number_is_left_finite_by_luck(dim, exponent):
    """Coordinates of any magnitude, mixed: all gains are measures of parts of a ball."""
    rng = np.random.default_rng(abs(exponent))
    points = rng.choice([0.0, 1.0, -1.0, 0.5], (60, dim)) * 10.0**exponent
    points[::3] = rng.uniform(-2, 2, (20, dim))
    for tau in (1.0, 1e-60, 1e60):
        cov = db.Coverage(tau, dim=dim, accuracy=0.05, rng=0)
        gains = cov.extend(points)
        assert np.all((gains >= 0) & (gains <= cov.largest_gain))
        assert np.all(np.isfinite(cov.standard_errors))
        assert np.all(np.isfinite([cov.contribution(index) for index in range(0, 60, 7)]))
        assert cov.contains(points).all()
        assert cov.largest_gain <= cov.measure <= 60 * cov.largest_gain


@pytest.mark.parametrize("dim", ALL)
def test_exactly_two_tau_apart(dim):
    """On a grid, where balls touch and nothing more."""
    side = {1: 200, 2: 15, 3: 6, 5: 3}[dim]
    grid = np.stack(np.meshgrid(*[np.arange(side)] * dim), axis=-1).reshape(-1, dim)
    for tau in (0.1, 0.25, 1.0, 1e9):
        points = np.random.default_rng(0).permutation(grid) * (2 * tau)
        cov = db.Coverage(tau, dim=dim, rng=0)
        cov.extend(points)
        assert cov.measure == pytest.approx(len(points) * cov.largest_gain, rel=1e-13)


def hexagonal(columns, rows, step):
    """Return a patch of a hexagonal lattice, and how many pairs are a step apart."""
    places = [(x + y / 2, y * math.sqrt(3) / 2) for x in range(columns) for y in range(rows)]
    pairs = (columns - 1) * rows + columns * (rows - 1) + (columns - 1) * (rows - 1)
    return step * np.array(places), pairs


@pytest.mark.parametrize("step", [2.0, math.sqrt(3), 1.8, 3.0, 1.0, 0.5])
def test_hexagonal_lattices(step):
    """At 2 all discs touch; at the root of 3 three circles each go through one point."""
    points, pairs = hexagonal(12, 9, step)
    assert len(points) == 108
    total = db.coverage(np.random.default_rng(1).permutation(points), 1.0)
    if step >= math.sqrt(3):
        expected = math.pi * (len(points) - pairs * overlap(step, 2))
        assert total == pytest.approx(expected, rel=1e-13)
    assert total == pytest.approx(section_area(points, 1.0), rel=1e-12)


@pytest.mark.parametrize(("a", "b"), [(1, 0), (3, 4), (5, 12), (20, 21)])
def test_turned_square_lattices_on_whole_numbers(a, b):
    """Exact tangencies in directions that are none of the axes'.

    Their area is that of a lattice along the axes, for which slices can be told apart.
    """
    length = math.isqrt(a * a + b * b)
    points = [(a * i - b * j, b * i + a * j) for i in range(9) for j in range(9)]
    shuffled = np.random.default_rng(2).permutation(points)
    straight = [(i, j) for i in range(9) for j in range(9)]
    for radius in (0.5, 0.6, math.sqrt(0.5), 0.8, 1.0):
        tau, expected = radius * length, section_area(straight, radius) * length**2
        assert db.coverage(shuffled, tau) == pytest.approx(expected, rel=1e-12)
    touching = 81 * math.pi * (length / 2) ** 2
    assert db.coverage(shuffled, length / 2) == pytest.approx(touching, rel=1e-14)


@pytest.mark.parametrize("tau", [5, 25, 65])
def test_many_circles_through_one_point_on_whole_numbers(tau):
    """12, 20 and 36 centres exactly tau from the origin."""
    around = range(-tau, tau + 1)
    points = [(x, y) for x in around for y in around if x * x + y * y == tau * tau]
    assert len(points) == {5: 12, 25: 20, 65: 36}[tau]
    expected = exact_area(points, tau)
    rng = np.random.default_rng(3)
    for _ in range(20):
        assert db.coverage(rng.permutation(points), tau) == pytest.approx(expected, rel=1e-14)
    cov = db.Coverage(tau, rng=0)
    cov.extend(points)
    assert cov.gain([0, 0]) == pytest.approx(0, abs=1e-14 * cov.largest_gain)


@pytest.mark.parametrize("dim", ALL)
def test_duplicates_in_between_change_nothing(dim):
    """Exact duplicates, and the next number beside each coordinate."""
    points = np.random.default_rng(4).uniform(-1, 1, (30, dim))
    tau = {1: 0.02, 2: 0.2, 3: 0.4, 5: 0.7}[dim]
    one, other = (db.Coverage(tau, dim=dim, accuracy=0.02, rng=0) for _ in range(2))
    one.extend(points)
    copies = np.concatenate([points, points, np.nextafter(points, 2), points])
    other.extend(np.random.default_rng(5).permutation(copies))
    off = 5 * math.hypot(one.standard_error, other.standard_error)
    assert other.measure == pytest.approx(one.measure, rel=1e-12, abs=off)


# Two that all but coincide, and a third that touches both but for rounding.
TOUCHING = [
    (
        [0.36602540378443843, 0.3660254037844384],
        [-0.5000000000000002, 0.8660254037844384],
        [0.36602540378443815, 0.36602540378443793],
        0.5,
    ),
    (
        [-0.4330127018922194, -0.24999999999999986],
        [-0.18301270189221938, 0.18301270189221944],
        [-0.4330127018922196, -0.24999999999999975],
        0.25,
    ),
]


@pytest.mark.parametrize("order", [*permutations(range(3))], ids=str)
@pytest.mark.parametrize("case", TOUCHING, ids=["tau = 0.5", "tau = 0.25"])
def test_two_balls_and_nothing_more(case, order):
    """The first two share next to nothing, and so do their doubles: each sum is two balls."""
    *points, tau = case
    gains = db.Coverage(tau).extend([points[index] for index in order])
    ball = math.pi * tau**2
    assert gains.sum() == pytest.approx(2 * ball, rel=0, abs=1e-13 * ball)


@pytest.mark.parametrize("exponent", range(-17, -2))
def test_perturbed_lattices(exponent):
    """Lattices on which circles touch or cross in common points, moved by less and less."""
    rng = np.random.default_rng(-exponent)
    for _ in range(6):
        tau = rng.choice([0.02, 0.25, 0.5, 1.0, math.sqrt(0.5)])
        lattice = rng.integers(0, 4, (15, 2)) * tau * rng.choice([0.5, 1, 2])
        points = lattice + 10.0**exponent * rng.standard_normal((15, 2))
        expected = exact_area(points, tau)
        assert db.coverage(points, tau) == pytest.approx(expected, rel=0, abs=1e-12 * tau**2)


@pytest.mark.parametrize("exponent", range(-17, -2))
def test_rings_of_touching_discs(exponent):
    """Chains of unit steps in twelve directions: nearly tangent, nearly coincident discs."""
    rng = np.random.default_rng(-exponent)
    for _ in range(6):
        tau = rng.choice([0.02, 0.25, 0.5, 1.0, math.sqrt(0.5)])
        angles = rng.integers(0, 12, 15) * math.pi / 6
        steps = 2 * tau * np.stack([np.cos(angles), np.sin(angles)], axis=1)
        points = np.cumsum(steps, axis=0) + 10.0**exponent * rng.standard_normal((15, 2))
        expected = exact_area(points, tau)
        assert db.coverage(points, tau) == pytest.approx(expected, rel=0, abs=1e-12 * tau**2)
