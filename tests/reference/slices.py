"""The volume of a union of a few equal balls, slice by slice.

A slice at height z is a union of discs of several radii, whose area Green's theorem gives. Between
heights where something on the union's surface begins, ends or turns - poles of balls, the highest
and lowest points of circles that two spheres share, points that three share - the area is
analytic but for square roots at both ends, which the substitution z = middle - half cos t removes.
Gauss and Legendre integrate each slab, and its halves, until both agree.
"""

from itertools import pairwise

import numpy as np

NODES, WEIGHTS = np.polynomial.legendre.leggauss(12)
#: How much halving a slab may still change, in balls of radius 1, and how often to halve.
SETTLED, DEPTH = 1e-11, 8


def sliced_volume(centres, tau):
    """Return the volume of the union of the balls of radius `tau` around `centres`, (n, 3)."""
    balls = np.unique(np.asarray(centres, dtype=float), axis=0)
    balls = (balls - balls.mean(axis=0)) / tau
    heights = np.unique(_surface_heights(balls))
    return tau**3 * sum(_slab(balls, low, high) for low, high in pairwise(heights))


def _slab(balls, low, high):
    near = balls[(balls[:, 2] - 1 < high) & (balls[:, 2] + 1 > low)]
    middle, half = (low + high) / 2, (high - low) / 2
    if half < 1e-14 or len(near) == 0:
        return 0.0

    def integral(start, end):
        angle = (start + end) / 2 + (end - start) / 2 * NODES
        heights = middle - half * np.cos(angle)
        return (end - start) / 2 * half * float(WEIGHTS @ (np.sin(angle) * areas(near, heights)))

    def refined(start, end, whole, depth):
        centre = (start + end) / 2
        left, right = integral(start, centre), integral(centre, end)
        if depth == 0 or abs(left + right - whole) < SETTLED:
            return left + right
        return refined(start, centre, left, depth - 1) + refined(centre, end, right, depth - 1)

    return refined(0.0, np.pi, integral(0.0, np.pi), DEPTH)


def areas(balls, heights):
    """Return the area of the union of unit balls' slices, at each height."""
    squared = 1 - (heights[:, None] - balls[:, 2]) ** 2
    radius = np.sqrt(np.maximum(squared, 0))
    r, s = radius[:, :, None], radius[:, None, :]  # a disc, and another
    dx, dy = (balls[None, :, axis] - balls[:, None, axis] for axis in (0, 1))
    distance = np.hypot(dx, dy)
    earlier = np.tri(len(balls), k=-1, dtype=bool)  # of discs that are equal, one counts
    within = (distance < s - r) | ((distance <= s - r) & ((s > r) | earlier))
    crossing = (distance < r + s) & (distance > abs(r - s))
    with np.errstate(divide="ignore", invalid="ignore"):
        cosine = (distance**2 + (r - s) * (r + s)) / (2 * distance * r)
        half = np.where(crossing, np.arccos(np.clip(cosine, -1, 1)), 0.0)
    start = np.where(crossing, np.mod(np.arctan2(dy, dx) - half, 2 * np.pi), 0.0)
    end = start + 2 * half
    beginning = np.maximum(end.max(axis=2, keepdims=True) - 2 * np.pi, 0.0)
    order = np.argsort(start, axis=2)
    start, end = (np.take_along_axis(angles, order, axis=2) for angles in (start, end))
    a = np.maximum.accumulate(np.concatenate([beginning, end], axis=2), axis=2)
    b = np.concatenate([start, np.full_like(beginning, 2 * np.pi)], axis=2)
    x, y = balls[:, 0, None], balls[:, 1, None]
    swept = radius[:, :, None] * (b - a)
    moved = x * (np.sin(b) - np.sin(a)) - y * (np.cos(b) - np.cos(a))
    free = (b > a) & ~within.any(axis=2)[:, :, None]
    return 0.5 * np.sum(np.where(free, radius[:, :, None] * (swept + moved), 0.0), axis=(1, 2))


def _surface_heights(balls):
    """Return the heights at which the slice's area is not analytic."""
    up = np.array([0.0, 0.0, 1.0])
    found = [balls + up, balls - up]
    i, j = np.triu_indices(len(balls), 1)
    apart = balls[j] - balls[i]
    distance = np.linalg.norm(apart, axis=1)
    i, j, apart, distance = (each[distance <= 2] for each in (i, j, apart, distance))
    # The circles of pairs: their highest and lowest points; of level ones, some around.
    middle = (balls[i] + balls[j]) / 2
    radius = np.sqrt(np.maximum(1 - distance**2 / 4, 0))[:, None]
    unit = apart / distance[:, None]
    steepest = up - unit[:, 2:] * unit
    length = np.linalg.norm(steepest, axis=1, keepdims=True)
    level = length[:, 0] < 1e-9
    with np.errstate(divide="ignore", invalid="ignore"):
        steepest = np.where(level[:, None], 0.0, steepest / length)
    found += [middle + radius * steepest, middle - radius * steepest]
    for direction in np.array([[1.0, 0, 0], [-1, 0, 0], [0, 1, 0], [0, -1, 0]]):
        found.append((middle + radius * direction)[level])
    # The two points of triples.
    pairs = {*zip(i.tolist(), j.tolist(), strict=True)}
    triples = [
        (a, b, c) for a, b in pairs for c in range(b + 1, len(balls)) if {(a, c), (b, c)} <= pairs
    ]
    if triples:
        found += _common_points(*(balls[list(each)] for each in zip(*triples, strict=True)))
    points = np.concatenate(found)
    # What lies inside a ball leaves no mark.
    squared = np.sum((points[:, None] - balls[None]) ** 2, axis=2)
    return points[np.all(squared > 1 - 1e-7, axis=1), 2]


def _common_points(a, b, c):
    """Return the points at distance 1 from three centres: two arrays, of those that have them."""
    ab, ac = b - a, c - a
    normal = np.cross(ab, ac)
    squared = np.sum(normal**2, axis=1, keepdims=True)
    lengths = np.sum(ab**2, axis=1, keepdims=True), np.sum(ac**2, axis=1, keepdims=True)
    with np.errstate(divide="ignore", invalid="ignore"):
        towards = lengths[1] * np.cross(ab, normal) - lengths[0] * np.cross(ac, normal)
        offset = -towards / (2 * squared)
        height = np.sqrt((1 - np.sum(offset**2, axis=1, keepdims=True)) / squared)
    known = np.isfinite(height[:, 0])
    centre, step = (a + offset)[known], (height * normal)[known]
    return [centre + step, centre - step]
