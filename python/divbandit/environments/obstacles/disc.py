"""Disc: a round obstacle."""

from __future__ import annotations

from typing import TYPE_CHECKING

from divbandit import _core
from divbandit.environments.obstacles.base import Obstacle

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import ArrayLike, NDArray


class Disc(Obstacle):
    """A disc.

    Parameters
    ----------
    center : array_like, shape (2,)
        In metres.
    radius : float
        In metres; positive.

    Raises
    ------
    TypeError, ValueError
        If the center is no point of the plane, or the radius is not positive.

    Examples
    --------
    >>> import divbandit as db
    >>> arm = db.PlanarArm(1, thickness=0.1, obstacles=[db.Disc([0, 0.5], 0.1)])
    >>> bool(arm.progress([1.6]) < 1)
    True
    """

    center: NDArray[np.float64]
    radius: float

    def __init__(self, center: ArrayLike, radius: float) -> None:
        kernel = _core.Obstacle.disc(center, radius)
        self.center, self.radius = _core.as_point("center", center, 2), float(radius)
        self._kernel = kernel

    def _arguments(self) -> tuple[object, ...]:
        return self.center, self.radius
