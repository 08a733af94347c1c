"""Rectangle: an obstacle along the axes."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

from divbandit import _core
from divbandit._checks import floats
from divbandit.environments.obstacles.base import Obstacle

if TYPE_CHECKING:
    from numpy.typing import ArrayLike


@dataclass(frozen=True, init=False, repr=False)
class Rectangle(Obstacle):
    """A rectangle with sides parallel to the axes; for others use `Polygon`.

    Parameters
    ----------
    low, high : array_like, shape (2,)
        The lower left and the upper right corner, in metres.

    Raises
    ------
    TypeError, ValueError
        If the corners are not finite points of the plane, or `low` is not below `high`.

    Examples
    --------
    >>> from divbandit.environments import PlanarArm, Rectangle
    >>> arm = PlanarArm(5, obstacles=[Rectangle([0.2, 0.1], [0.6, 0.3])])
    >>> bool(arm.progress([0.5, 0, 0, 0, 0]) < 1)
    True
    """

    low: tuple[float, ...]
    high: tuple[float, ...]

    def __init__(self, low: ArrayLike, high: ArrayLike) -> None:
        kernel = _core.Obstacle.rectangle(low, high)
        self._set(low=floats("low", low, 2), high=floats("high", high, 2), _kernel=kernel)
