"""On a line: against exact rational arithmetic, interval after interval."""

import math
from fractions import Fraction

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

import divbandit as db
from tests.reference.families import FAMILIES, family
from tests.reference.intervals import gains, union_length

# A gain is two subtractions and an addition of numbers up to 2 tau, each rounded once.
ROUNDING = 2.0**-51


def check(points, tau):
    """Compare each gain, and the total, with what exact arithmetic says."""
    cov = db.Coverage(tau, dim=1)
    found = cov.extend(np.reshape(points, (-1, 1)))
    wrong = [
        (index, got, float(exact))
        for index, (got, exact) in enumerate(zip(found.tolist(), gains(points, tau), strict=True))
        if abs(Fraction(got) - exact) > ROUNDING * Fraction(tau)
    ]
    assert not wrong
    exact = union_length(points, tau)
    assert abs(Fraction(cov.measure) - exact) <= 1e-15 * exact


@pytest.mark.parametrize("tau", [0.01, 0.1, 1.0, 1e-9, math.pi])
@pytest.mark.parametrize("name", FAMILIES)
def test_families(name, tau):
    check(family(name, 300, 1, seed=5)[:, 0], tau)


@pytest.mark.parametrize("tau", [0.125, 0.1, 1 / 3, 1.0])
def test_grids_on_which_intervals_touch(tau):
    """Steps of tau/2, tau and 2 tau: ends meet exactly, or but for rounding."""
    rng = np.random.default_rng(0)
    for step in (tau / 2, tau, 2 * tau, math.nextafter(2 * tau, 0), math.nextafter(2 * tau, 9)):
        check(rng.permutation(60) * step, tau)
        check(1e6 + rng.permutation(60) * step, tau)


def apart(rng, n, tau):
    """Return points 1e-9 to 1e9 tau from one another, and some of them twice."""
    steps = tau * 10.0 ** rng.uniform(-9, 9, n) * rng.choice([-1, 1], n)
    points = rng.choice([0, 1], n) * np.cumsum(steps) + steps
    return rng.permutation(np.concatenate([points, points[: n // 5]]))


@pytest.mark.parametrize("tau", [1e-100, 1e-9, 0.1, 1.0, 1e9, 1e100])
def test_near_and_far(tau):
    rng = np.random.default_rng(1)
    for _ in range(10):
        check(apart(rng, 50, tau), tau)


def test_as_far_as_numbers_go():
    largest = float(np.finfo(float).max)
    for tau in (1e-100, 1.0, 1e100):
        check([largest, -largest, 0.0, 1e300, -1e300, -0.0, 5e-324, largest, tau, -tau], tau)


@given(
    st.lists(
        st.integers(-16, 16).map(lambda k: k / 8)
        | st.floats(-3, 3)
        | st.floats(-1e300, 1e300)
        | st.floats(1 - 1e-14, 1 + 1e-14),
        min_size=1,
        max_size=30,
    ),
    st.sampled_from([0.125, 0.3, 0.5, 1.0, 1e-12]),
)
def test_any_points(points, tau):
    check(points, tau)
