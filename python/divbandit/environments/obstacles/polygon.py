"""Polygon: an obstacle with straight sides."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from divbandit import _core
from divbandit.environments.obstacles.base import Obstacle

if TYPE_CHECKING:
    from numpy.typing import ArrayLike


@dataclass(frozen=True, init=False, repr=False)
class Polygon(Obstacle):
    """A polygon, convex or not.

    Parameters
    ----------
    points : array_like, shape (k, 2)
        Its 3 to 10,000 corners in order, in metres; the last is joined to the first.

    Raises
    ------
    TypeError, ValueError
        If the corners are not finite points of the plane, or the outline touches itself.

    Examples
    --------
    >>> from divbandit.environments import Polygon
    >>> Polygon([[0.5, 0.5], [0.9, 0.5], [0.6, 0.6], [0.5, 0.9]]).points[2]
    (0.6, 0.6)
    """

    points: tuple[tuple[float, ...], ...]

    def __init__(self, points: ArrayLike) -> None:
        kernel = _core.Obstacle.polygon(points)
        corners = np.asarray(points, dtype=np.float64).tolist()
        self._set(points=tuple(map(tuple, corners)), _kernel=kernel)
