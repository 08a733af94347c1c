"""Perturb_d: uniform within d of the parent's coordinates, clipped at the box's faces.

Each distribution is compared with the uniform one by a Kolmogorov-Smirnov test at level 1e-4;
seeds are fixed, so a test passes always or never.
"""

import numpy as np
import pytest
from scipy import stats

import divbandit as db

LEVEL = 1e-4
BOX = db.Box([-1.0, 0.0, 10.0], [1.0, 10.0, 10.5])
PARENTS = {
    "inside": [0.0, 5.0, 10.25],
    "near the faces": [-0.99, 9.9, 10.499],
    "on the faces": [-1.0, 10.0, 10.5],
}


def drawn(parent, d, n=4000):
    rng = np.random.default_rng(11)
    return np.array([BOX.bounds.perturb(parent, d, rng) for _ in range(n)])


@pytest.mark.parametrize("d", [0.001, 0.05, 0.5, 1.0])
@pytest.mark.parametrize("parent", PARENTS.values(), ids=PARENTS)
def test_uniform_where_it_may_be(parent, d):
    reach = d * (BOX.high - BOX.low)
    low = np.maximum(BOX.low, parent - reach)
    high = np.minimum(BOX.high, parent + reach)
    commands = drawn(parent, d)
    assert np.all((low <= commands) & (commands <= high))
    for j in range(BOX.dim):
        fit = stats.kstest(commands[:, j], stats.uniform(low[j], high[j] - low[j]).cdf)
        assert fit.pvalue > LEVEL


def test_coordinates_are_independent():
    """Spearman's rank correlation of each pair, each tested at level 1e-4."""
    commands = drawn(PARENTS["near the faces"], 0.2)
    for a, b in [(0, 1), (0, 2), (1, 2)]:
        assert stats.spearmanr(commands[:, a], commands[:, b]).pvalue > LEVEL


@pytest.mark.parametrize("parent", PARENTS.values(), ids=PARENTS)
def test_none_with_d_zero(parent):
    assert np.all(drawn(parent, 0.0, n=10) == parent)
