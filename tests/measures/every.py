"""Every measure by what it is called in a test."""

import copy
import pickle

import numpy as np

import divbandit as db


def fresh():
    """Return {name: an empty measure}."""
    return {
        "coverage": db.Coverage(0.3),
        "coverage, one dimension": db.Coverage(0.1, dim=1),
        "coverage, three dimensions": db.Coverage(0.4, dim=3),
        "coverage, four dimensions": db.Coverage(0.8, dim=4, accuracy=0.01, rng=0),
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


COPIES = {
    "copy": copy.copy,
    "deepcopy": copy.deepcopy,
    "pickle": lambda measure: pickle.loads(pickle.dumps(measure)),  # noqa: S301
}
