"""The area of a union of a few equal discs, slice by slice.

The plane is cut along the vertical lines through each disc's leftmost and rightmost points and
through each point that two circles have in common. Within a slice no two arcs cross, so the
merged vertical sections are bounded by the same arcs throughout, and each arc's integral is
elementary. Circles are only ever met as graphs y = cy +- sqrt(tau^2 - (x - cx)^2): no angles,
no boundary walk. Where discs touch but for rounding, rounding decides which slices there are.
"""

import math
from itertools import combinations, pairwise


def section_area(centres, tau):
    """Return the area of the union of the discs of radius `tau` around `centres`."""
    discs = sorted({(float(x), float(y)) for x, y in centres})
    cuts = sorted(_abscissae(discs, tau))
    return math.fsum(_slice(discs, tau, a, b) for a, b in pairwise(cuts) if a < b)


def _abscissae(discs, tau):
    for x, _ in discs:
        yield from (x - tau, x + tau)
    for (x1, y1), (x2, y2) in combinations(discs, 2):
        dx, dy = x2 - x1, y2 - y1
        distance = math.hypot(dx, dy)
        if distance <= 2 * tau:
            aside = math.sqrt((tau - distance / 2) * (tau + distance / 2)) * dy / distance
            yield from (x1 + dx / 2 - aside, x1 + dx / 2 + aside)


def _slice(discs, tau, a, b):
    """Return the area between the lines x = a and x = b."""
    middle = (a + b) / 2
    sections = []
    for x, y in discs:
        if abs(middle - x) < tau:
            half = math.sqrt(tau**2 - (middle - x) ** 2)
            sections.append((y - half, y + half, x, y))
    area = 0.0
    top = None  # (height, x, y) of the disc that bounds the merged section from above
    for low, high, x, y in sorted(sections):
        if top is None or low > top[0]:
            if top is not None:
                area += _under(top[1:], +1, tau, a, b)
            area -= _under((x, y), -1, tau, a, b)
            top = (high, x, y)
        elif high > top[0]:
            top = (high, x, y)
    return area + (_under(top[1:], +1, tau, a, b) if top else 0.0)


def _under(centre, sign, tau, a, b):
    """Return the integral over [a, b] of cy + sign sqrt(tau^2 - (x - cx)^2)."""
    x, y = centre
    return y * (b - a) + sign * (_half_disc(b - x, tau) - _half_disc(a - x, tau))


def _half_disc(u, tau):
    """Return the integral of sqrt(tau^2 - u^2) from 0 to u."""
    u = min(max(u, -tau), tau)
    height = math.sqrt((tau - u) * (tau + u))
    return 0.5 * (u * height + tau**2 * math.atan2(u, height))
