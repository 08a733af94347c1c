"""Every measure by what it is called in a test."""

import copy
import pickle

import numpy as np

from divbandit.measures import BallCoverage, Coverage, Entropy, GridCoverage, Sparseness
from tests.reference import measures as reference


def started():
    """Return {name: a running measure of no effects}."""
    return {
        "coverage, one dimension": Coverage(0.1, dim=1),
        "coverage, three dimensions": Coverage(0.4, dim=3),
    } | {name: measure.start(dim) for name, (measure, dim) in VALUES.items()}


#: Each of the values, and the dimension in which it is tried.
VALUES = {
    "balls": (BallCoverage(0.3), 2),
    "balls, four dimensions": (BallCoverage(0.8, accuracy=0.05), 4),
    "grid": (GridCoverage(0.25), 2),
    "grid, edges and origin": (GridCoverage([0.25, 0.5], origin=[0.1, -3]), 2),
    "grid, one dimension": (GridCoverage(0.25), 1),
    "grid, four dimensions": (GridCoverage(0.5), 4),
    "sparseness": (Sparseness(), 2),
    "sparseness, k = 1": (Sparseness(1), 2),
    "sparseness, k = 3": (Sparseness(k=3), 3),
    "entropy": (Entropy(0.25), 2),
    "entropy, edges and origin": (Entropy([0.25, 0.5, 1.0], origin=0.1), 3),
}

NAMES = tuple(started())


def specified(measure, dim):
    """Return the plain specification of a value."""
    match measure:
        case GridCoverage():
            return reference.GridCoverage(measure.cell, measure.origin, dim)
        case Entropy():
            return reference.Entropy(measure.cell, measure.origin, dim)
        case Sparseness():
            return reference.Sparseness(measure.k)
        case BallCoverage():
            return Coverage(measure.tau, dim=dim, accuracy=measure.accuracy, rng=0)


def clustered(dim, n=200, seed=0):
    """Return effects of which many share a place, and some are equal."""
    rng = np.random.default_rng(seed)
    effects = rng.uniform(-1, 1, (n, dim)) * rng.choice([0.05, 1.0], (n, 1))
    effects[n // 2 :: 7] = effects[0]
    return effects


COPIES = {
    "copy": copy.copy,
    "deepcopy": copy.deepcopy,
    "pickle": lambda value: pickle.loads(pickle.dumps(value)),  # noqa: S301
}


class Furthest:
    """How far the farthest effect is from 0: a user's measure, which starts itself."""

    largest_gain = 0.0

    def start(self, dim):
        self.dim, self.measure, self.count = dim, 0.0, 0
        return self

    def gain(self, effect):
        return max(self.measure, float(np.linalg.norm(effect))) - self.measure

    def add(self, effect):
        gain = self.gain(effect)
        self.measure, self.count = self.measure + gain, self.count + 1
        return gain

    def extend(self, effects):
        return np.array([self.add(effect) for effect in effects])

    def __len__(self):
        return self.count
