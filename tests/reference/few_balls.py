"""The volume of a union of one, two or three balls in space, in closed form and 50 digits.

That three have in common consists, if their spheres meet in two points, of a tetrahedron on
either side of the plane of the centres and of what lies beyond its faces (Gibson and Scheraga,
The Journal of Physical Chemistry 91, 4121, 1987; here for equal radii). Coordinates are taken
as the exact numbers that they are.
"""

from itertools import combinations

from mpmath import atan2, mp, mpf, pi, sqrt


def union_volume(centres, tau):
    """Return the volume of the union of up to three balls of radius `tau`."""
    with mp.workdps(50):
        tau = mpf(float(tau))
        balls = sorted({tuple(float(x) for x in centre) for centre in centres})
        squares = [
            sum((mpf(x) - mpf(y)) ** 2 for x, y in zip(*pair, strict=True)) / tau**2
            for pair in combinations(balls, 2)
        ]
        total = len(balls) * 4 * pi / 3 - sum(map(_lens, squares))
        if len(squares) == 3:
            total += _triangle(squares)
        return float(total * tau**3)


def _lens(square):
    """Return the volume common to two unit balls, from their distance's square."""
    distance = sqrt(square)
    return pi / 12 * (2 - distance) ** 2 * (distance + 4) if distance < 2 else mpf(0)


def _triangle(squares):
    """Return the volume common to three different unit balls."""
    # Positive at an acute angle opposite to the side.
    opening = [sum(squares) - 2 * square for square in squares]
    a, b, c = squares
    # 16 times the square of the triangle's area, and of the tetrahedron's volume times 3/h.
    area = 2 * (a * b + b * c + c * a) - a * a - b * b - c * c
    squared = area - a * b * c
    if squared <= 0:  # no common point of the spheres
        return _lens(max(squares)) if min(opening) <= 0 else mpf(0)
    w = sqrt(squared)
    total = w / 6
    for square, acute in zip(squares, opening, strict=True):
        side = sqrt(square)
        total -= side * (1 - square / 12) * atan2(2 * w, side * acute)
        total += mpf(4) / 3 * atan2(w, acute)
    return total
