"""The area of a union of a few equal discs with 50 digits, for where rounding decides.

Coordinates are taken as the exact numbers that they are. Each disc's free angles are found one
interval after another, and Green's theorem gives the area.
"""

from mpmath import acos, atan2, cos, hypot, mp, mpf, pi, sin


def exact_area(centres, tau):
    """Return the area of the union of the discs of radius `tau` around `centres`."""
    with mp.workdps(50):
        tau = mpf(float(tau))
        discs = sorted({(float(x), float(y)) for x, y in centres})
        discs = [(mpf(x), mpf(y)) for x, y in discs]
        return float(sum(_under_free_arcs(disc, discs, tau) for disc in discs) / 2)


def _under_free_arcs(disc, discs, tau):
    x, y = disc
    total = mpf(0)
    for a, b in _gaps(_covered(disc, discs, tau)):
        total += tau**2 * (b - a) + tau * (x * (sin(b) - sin(a)) - y * (cos(b) - cos(a)))
    return total


def _covered(disc, discs, tau):
    """Yield the angles that other discs cover, each interval within [-pi, pi]."""
    for other in discs:
        dx, dy = other[0] - disc[0], other[1] - disc[1]
        distance = hypot(dx, dy)
        if other == disc or distance >= 2 * tau:
            continue
        towards, half = atan2(dy, dx), acos(distance / (2 * tau))
        start, end = towards - half, towards + half
        yield max(start, -pi), min(end, +pi)
        if start < -pi:
            yield start + 2 * pi, +pi
        if end > pi:
            yield -pi, end - 2 * pi


def _gaps(intervals):
    reached = -pi
    for start, end in sorted(intervals):
        if start > reached:
            yield reached, start
        reached = max(reached, end)
    if reached < pi:
        yield reached, +pi
