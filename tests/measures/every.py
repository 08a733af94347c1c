"""Every measure by what it is called in a test, and what Coverage can do so far."""

import copy
import pickle

import numpy as np

import divbandit as db


def fresh():
    """Return {name: an empty measure}."""
    return {
        "coverage": db.Coverage(0.3),
        "grid": db.GridCoverage(0.25),
        "grid, edges and origin": db.GridCoverage([0.25, 0.5], origin=[0.1, -3]),
        "grid, one dimension": db.GridCoverage(0.25, dim=1),
        "grid, four dimensions": db.GridCoverage(0.5, dim=4),
        "sparseness": db.Sparseness(),
        "sparseness, k = 1": db.Sparseness(1),
        "sparseness, k = 3": db.Sparseness(k=3, dim=3),
        "entropy": db.Entropy(0.25),
        "entropy, edges and origin": db.Entropy([0.25, 0.5, 1.0], dim=3, origin=0.1),
    }


NAMES = tuple(fresh())


def clustered(dim, n=200, seed=0):
    """Return effects of which many share a place, and some are equal."""
    rng = np.random.default_rng(seed)
    effects = rng.uniform(-1, 1, (n, dim)) * rng.choice([0.05, 1.0], (n, 1))
    effects[n // 2 :: 7] = effects[0]
    return effects


def can(call):
    """Say whether it works."""
    try:
        call()
    except (TypeError, ValueError, AttributeError):
        return False
    return True


# Coverage is to learn these; the tests hold before and after.
COVERAGE_PEEKS_AT_MANY = can(lambda: db.Coverage(1.0).gain([[0.0, 0.0], [1.0, 1.0]]))
COVERAGE_PICKLES = can(lambda: pickle.loads(pickle.dumps(db.Coverage(1.0))))  # noqa: S301
COVERAGE_KNOWS_ITS_LARGEST_GAIN = can(lambda: db.Coverage(1.0).largest_gain)


def coverage_dims(highest=20):
    """Return the dimensions that Coverage takes."""
    return [dim for dim in range(1, highest + 1) if can(lambda dim=dim: db.Coverage(0.5, dim=dim))]


COPIES = {
    "copy": copy.copy,
    "deepcopy": copy.deepcopy,
    "pickle": lambda measure: pickle.loads(pickle.dumps(measure)),  # noqa: S301
}
