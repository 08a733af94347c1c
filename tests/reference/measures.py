"""Measures in plain Python, as short as their definitions: what the compiled ones are held to."""

from fractions import Fraction
from math import floor, fsum

import numpy as np

from divbandit._core import log


class Specified:
    """A measure by what an effect gains, given all before it."""

    def __init__(self):
        self.effects = []

    def add(self, effect):
        before = self.of(self.effects)
        self.effects.append(effect)
        return self.of(self.effects) - before


class Histogram(Specified):
    """How many effects lie in each cell of a grid."""

    def __init__(self, cell, origin, dim):
        super().__init__()
        self.edges, self.corner = np.broadcast_to(cell, dim), np.broadcast_to(origin, dim)

    def counts(self, effects):
        cells = {}
        for effect in effects:
            quotients = (np.asarray(effect) - self.corner) / self.edges
            # Python's whole numbers have no largest: 1e300 with an edge of 1 has its cell, too.
            cell = tuple(floor(quotient) for quotient in quotients)
            cells[cell] = cells.get(cell, 0) + 1
        return list(cells.values())


class GridCoverage(Histogram):
    """The number of occupied cells."""

    def of(self, effects):
        return float(len(self.counts(effects)))


class Entropy(Histogram):
    """H = (n log n - sum of c log c) / n, the sum being exact but for its logarithms."""

    def of(self, effects):
        return entropy(self.counts(effects))


class Sparseness(Specified):
    """The sum of the mean distances to the k nearest before."""

    def __init__(self, k):
        super().__init__()
        self.k = k

    def of(self, effects):
        return fsum(self.novelty(effects[:i], effect) for i, effect in enumerate(effects))

    def novelty(self, before, effect):
        # The squares are added up from the first coordinate to the last.
        squares = [0.0 for _ in before]
        for j, x in enumerate(effect):
            squares = [
                square + (x - other[j]) ** 2 for square, other in zip(squares, before, strict=True)
            ]
        nearest = sorted(np.sqrt(squares))[: self.k]
        return fsum(nearest) / len(nearest) if nearest else 0.0

    def add(self, effect):
        gain = self.novelty(self.effects, effect)
        self.effects.append(effect)
        return gain


def entropy(counts):
    """Return the entropy of a histogram of which no count is 0, from logarithms as floats."""
    n = sum(counts)
    if n == 0:
        return 0.0
    total = n * Fraction(log(n)) - sum(count * Fraction(log(count)) for count in counts)
    return float(total) / n
