"""Wall: an obstacle between two points."""

from __future__ import annotations

from typing import TYPE_CHECKING

from divbandit import _core
from divbandit.environments.obstacles.base import Obstacle

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import ArrayLike, NDArray


class Wall(Obstacle):
    """A straight wall with rounded ends.

    Parameters
    ----------
    start, end : array_like, shape (2,)
        In metres.
    thickness : float
        In metres, half of it on either side; a wall of none is a line that nothing passes.

    Raises
    ------
    TypeError, ValueError
        If the ends are no points of the plane or the same, or the thickness is negative.

    Examples
    --------
    >>> import divbandit as db
    >>> arm = db.PlanarArm(1, limit=3.0, thickness=0.02, obstacles=[db.Wall([0, 0.5], [0, 2])])
    >>> round(float(arm.progress([2.0])), 6)     # upright, less what half the link is thick
    0.775397
    """

    start: NDArray[np.float64]
    end: NDArray[np.float64]
    thickness: float

    def __init__(self, start: ArrayLike, end: ArrayLike, *, thickness: float = 0.0) -> None:
        kernel = _core.Obstacle.wall(start, end, thickness)
        self.start, self.end = _core.as_point("start", start, 2), _core.as_point("end", end, 2)
        self.thickness = float(thickness)
        self._kernel = kernel

    def _arguments(self) -> tuple[object, ...]:
        return self.start, self.end, self.thickness

    def __reduce__(self) -> tuple[object, ...]:
        return _rebuild, self._arguments()

    def __repr__(self) -> str:
        ends = f"{self.start.tolist()!r}, {self.end.tolist()!r}"
        return f"Wall({ends}, thickness={self.thickness!r})"


def _rebuild(start: ArrayLike, end: ArrayLike, thickness: float) -> Wall:
    return Wall(start, end, thickness=thickness)
