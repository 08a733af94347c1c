"""The area of a union of equal discs: what of each circle is free, and Green's theorem.

All discs are known beforehand. A point of disc i's circle belongs to the boundary of the union
if it lies in no other disc, and another disc whose centre lies at distance d in direction phi
covers the angles within arccos(d / 2 tau) of phi. The free angles are the gaps between those
intervals, and the integral of (x dy - y dx) / 2 along them is the area.
"""

import numpy as np
from scipy.spatial import cKDTree


def union_area(centres, tau):
    """Return the area of the union of the discs of radius `tau` around `centres`, (n, 2)."""
    centres = np.unique(np.asarray(centres, dtype=float), axis=0)
    if len(centres) == 0:
        return 0.0
    origin = centres.mean(axis=0)
    neighbours = cKDTree(centres).query_ball_point(centres, 2 * tau)
    parts = [
        _area_under_free_arcs(centres[i] - origin, _others(centres, i, near), tau)
        for i, near in enumerate(neighbours)
    ]
    return float(np.sum(parts))


def _others(centres, i, near):
    """Return where the neighbours' centres lie, seen from disc `i`."""
    offsets = centres[near] - centres[i]
    return offsets[np.any(offsets != 0, axis=1)]


def free_angles(offsets, tau):
    """Return (starts, ends) of the angles that no disc at `offsets` covers."""
    distance = np.hypot(offsets[:, 0], offsets[:, 1])
    overlapping = distance < 2 * tau
    offsets, distance = offsets[overlapping], distance[overlapping]
    towards = np.arctan2(offsets[:, 1], offsets[:, 0])
    half = np.arccos(distance / (2 * tau))
    starts = np.mod(towards - half, 2 * np.pi)
    ends = starts + 2 * half
    order = np.argsort(starts)
    starts, ends = starts[order], ends[order]
    # An interval that passes 2 pi covers the beginning of the circle.
    beginning = max(0.0, ends.max() - 2 * np.pi) if len(ends) else 0.0
    reached = np.maximum.accumulate(np.concatenate([[beginning], ends]))
    upto = np.concatenate([starts, [2 * np.pi]])
    free = upto > reached
    return reached[free], upto[free]


def _area_under_free_arcs(centre, offsets, tau):
    a, b = free_angles(offsets, tau)
    x, y = centre
    swept = tau**2 * (b - a)
    moved = tau * (x * (np.sin(b) - np.sin(a)) - y * (np.cos(b) - np.cos(a)))
    return 0.5 * np.sum(swept + moved)
