"""The measure of a union of balls in a row, in closed form, in any dimension.

Of balls in a straight line, what one has in common with another farther on lies in all between.
So the union is all balls less what each has in common with the next.
"""

from itertools import pairwise

import numpy as np
from mpmath import gamma, mp, mpf, pi
from scipy.special import betainc


def ball(dim, tau):
    """Return the measure of a ball."""
    with mp.workdps(30):
        half = mpf(dim) / 2
        return float(pi**half / gamma(half + 1) * mpf(float(tau)) ** dim)


def overlap(distance, dim):
    """Return the share of a unit ball that lies in another at this distance.

    It is two caps, each of which the regularised incomplete beta function measures.
    """
    if distance >= 2:
        return 0.0
    return float(betainc((dim + 1) / 2, 0.5, (1 - distance / 2) * (1 + distance / 2)))


def row_measure(places, dim, tau):
    """Return the measure of the union of balls at these places on a line."""
    places = np.unique(np.asarray(places, dtype=float)) / tau
    shared = sum(overlap(b - a, dim) for a, b in pairwise(places))
    return ball(dim, tau) * (len(places) - shared)


def in_direction(places, dim, rng):
    """Return the points of a line in R^dim, whose direction and middle are drawn."""
    direction = rng.standard_normal(dim)
    direction /= np.linalg.norm(direction)
    return rng.standard_normal(dim) + np.outer(places, direction)
