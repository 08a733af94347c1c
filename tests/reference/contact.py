"""Where a thick arm first touches an obstacle or itself: every small step, Shapely's distances.

The arm turns from rest, where all angles are 0, along ``s * command`` with s from 0 to 1. Its links
are lines, thickened by a radius; so are walls; a disc is a point thickened by its radius. What
lies between two of them is the distance of the thin shapes less both radii.
"""

import numpy as np
import shapely

from divbandit.environments import Disc, Polygon, Rectangle, Wall

#: Steps that are looked at in one go.
BLOCK = 500


def postures(angles):
    """Return the base, the joints' far ends and the tip: (..., joints) -> (..., joints + 1, 2)."""
    headings = np.cumsum(angles, axis=-1)
    links = np.stack([np.cos(headings), np.sin(headings)], axis=-1) / headings.shape[-1]
    return np.concatenate([np.zeros_like(links[..., :1, :]), np.cumsum(links, axis=-2)], axis=-2)


def shape(obstacle):
    """Return an obstacle as a thin shape and the radius by which it is thickened."""
    match obstacle:
        case Disc():
            return shapely.Point(obstacle.center), obstacle.radius
        case Rectangle():
            return shapely.box(*obstacle.low, *obstacle.high), 0.0
        case Polygon():
            return shapely.Polygon(obstacle.points), 0.0
        case Wall():
            return shapely.LineString([obstacle.start, obstacle.end]), obstacle.thickness / 2
    raise TypeError(obstacle)


def clearances(arm, chains):
    """Return the distances that there are: of the arm to each obstacle, of links to later ones.

    Negative where a radius is entered; a shape that is crossed has distance 0.

    Parameters
    ----------
    arm : object with ``thickness``, ``obstacles`` and ``self_contact``
    chains : (n, joints + 1, 2) array
        Postures.

    Returns
    -------
    (n, k) array
    """
    lines = shapely.linestrings(chains)
    shapes = [shape(obstacle) for obstacle in arm.obstacles]
    found = [shapely.distance(lines, thin) - radius - arm.thickness / 2 for thin, radius in shapes]
    found += [shapely.distance(a, b) - arm.thickness for a, b in _own(arm, chains)]
    return np.stack([*found, np.full(len(chains), np.inf)], axis=-1)


def clearance(arm, angles):
    """Return how far the arm is from contact, (joints,) -> () or (n, joints) -> (n,)."""
    angles = np.asarray(angles, dtype=float)
    least = clearances(arm, postures(np.atleast_2d(angles))).min(axis=-1)
    return least if angles.ndim == 2 else float(least[0])


def first_contact(arm, command, *, start=None, steps=10_000):
    """Return the least s = 1 / steps, 2 / steps, ... 1 at which there is contact, or None.

    Parameters
    ----------
    arm : object with ``thickness``, ``obstacles`` and ``self_contact``
    command : (joints,) array
        Where the straight line in the space of angles ends.
    start : (joints,) array, optional
        Where it begins; by default at rest.
    """
    end = np.asarray(command, dtype=float)
    start = np.zeros_like(end) if start is None else np.asarray(start, dtype=float)
    shares = np.arange(1, steps + 1) / steps
    for block in np.split(shares, range(BLOCK, steps, BLOCK)):
        touching = _touching(arm, postures(start + block[:, None] * (end - start)))
        if touching.any():
            return float(block[touching.argmax()])
    return None


def _touching(arm, chains):
    """Return whether each posture has a clearance of 0 or less: (n,) bools.

    Shapely need not measure a distance to say that it is too large, so this is much faster.
    """
    lines = shapely.linestrings(chains)
    found = np.zeros(len(chains), dtype=bool)
    for obstacle in arm.obstacles:
        thin, radius = shape(obstacle)
        shapely.prepare(thin)
        found |= shapely.dwithin(thin, lines, radius + arm.thickness / 2)
    for a, b in _own(arm, chains):
        found |= shapely.dwithin(a, b, arm.thickness)
    return found


def _own(arm, chains):
    """Yield each link, in all postures, and all that follow its neighbour, as lines."""
    if arm.self_contact:
        for k in range(chains.shape[1] - 3):
            yield shapely.linestrings(chains[:, k : k + 2]), shapely.linestrings(chains[:, k + 2 :])
