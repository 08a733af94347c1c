"""After a million insertions the total agrees with a fresh batch in another order."""

import math

import numpy as np
import pytest

import divbandit as db


def effects(name, dim, n):
    rng = np.random.default_rng(dim)
    if name == "uniform":
        return rng.uniform(-1, 1, (n, dim))
    clusters = rng.uniform(-1, 1, (30, dim))
    return clusters[rng.integers(30, size=n)] + 0.02 * rng.standard_normal((n, dim))


@pytest.mark.parametrize(
    ("dim", "n", "tau"), [(1, 1_000_000, 1e-6), (2, 1_000_000, 2e-3), (3, 20_000, 0.05)]
)
@pytest.mark.parametrize("name", ["uniform", "clustered"])
def test_no_drift(name, dim, n, tau):
    points = effects(name, dim, n)
    cov = db.Coverage(tau, dim=dim)
    for some in np.array_split(points, 100):
        cov.extend(some)
    fresh = db.coverage(np.random.default_rng(9).permutation(points), tau)
    assert cov.measure == pytest.approx(fresh, rel=1e-12, abs=0)
    assert cov.measure == pytest.approx(math.fsum(cov.gains), rel=1e-15, abs=0)
    assert len(cov) == n


@pytest.mark.parametrize("dim", [4, 8])
def test_estimates_do_not_drift_beyond_their_errors(dim):
    """Errors of gains do not add up in one direction, and the total's says so."""
    points = effects("uniform", dim, 3000)
    one, other = (db.Coverage(0.5, dim=dim, accuracy=0.05, rng=seed) for seed in (0, 1))
    one.extend(points)
    other.extend(points[::-1])
    assert abs(one.measure - other.measure) <= 4 * math.hypot(
        one.standard_error, other.standard_error
    )
    assert one.standard_error < 0.05 * math.sqrt(3000) * one.largest_gain
