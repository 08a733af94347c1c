"""Rectangle: an obstacle along the axes."""

from __future__ import annotations

from typing import TYPE_CHECKING

from divbandit import _core
from divbandit.environments.obstacles.base import Obstacle

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import ArrayLike, NDArray


class Rectangle(Obstacle):
    """A rectangle whose sides are along the axes; `Polygon` makes others.

    Parameters
    ----------
    low, high : array_like, shape (2,)
        The lower left and the upper right corner, in metres.

    Raises
    ------
    TypeError, ValueError
        If these are no points of the plane, or `low` is not below `high`.

    Examples
    --------
    >>> import divbandit as db
    >>> arm = db.PlanarArm(5, obstacles=[db.Rectangle([0.2, 0.1], [0.6, 0.3])])
    >>> bool(arm.progress([0.5, 0, 0, 0, 0]) < 1)
    True
    """

    low: NDArray[np.float64]
    high: NDArray[np.float64]

    def __init__(self, low: ArrayLike, high: ArrayLike) -> None:
        kernel = _core.Obstacle.rectangle(low, high)
        self.low, self.high = _core.as_point("low", low, 2), _core.as_point("high", high, 2)
        self._kernel = kernel

    def _arguments(self) -> tuple[object, ...]:
        return self.low, self.high
