"""Discs that all but touch, or all but coincide: where rounding decides who crosses whom."""

import math
from itertools import permutations

import numpy as np
import pytest

import divbandit as db
from tests.reference.many_digits import exact_area

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
