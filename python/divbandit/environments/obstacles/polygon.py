"""Polygon: an obstacle with straight sides."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from divbandit import _core
from divbandit.environments.obstacles.base import Obstacle

if TYPE_CHECKING:
    from numpy.typing import ArrayLike, NDArray


class Polygon(Obstacle):
    """A polygon, convex or not.

    Parameters
    ----------
    points : array_like, shape (k, 2)
        Its 3 to 10,000 corners in order, in metres; the last is joined to the first.

    Raises
    ------
    TypeError, ValueError
        If these are no points of the plane, or the outline touches itself.

    Examples
    --------
    >>> import divbandit as db
    >>> db.Polygon([[0.5, 0.5], [0.9, 0.5], [0.6, 0.6], [0.5, 0.9]]).points.shape
    (4, 2)
    """

    points: NDArray[np.float64]

    def __init__(self, points: ArrayLike) -> None:
        kernel = _core.Obstacle.polygon(points)
        corners = np.array(points, dtype=np.float64)
        corners.flags.writeable = False
        self.points = corners
        self._kernel = kernel

    def _arguments(self) -> tuple[object, ...]:
        return (self.points,)
