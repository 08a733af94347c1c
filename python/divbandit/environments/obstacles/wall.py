"""Wall: an obstacle between two points."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

from divbandit import _core
from divbandit._checks import floats
from divbandit.environments.obstacles.base import Obstacle

if TYPE_CHECKING:
    from numpy.typing import ArrayLike


@dataclass(frozen=True, init=False, repr=False)
class Wall(Obstacle):
    """A straight wall with rounded ends.

    Parameters
    ----------
    start, end : array_like, shape (2,)
        In metres.
    thickness : float
        In metres, half of it on either side; with 0 the wall is a line, which stops links as well.

    Raises
    ------
    TypeError, ValueError
        If the ends are not two distinct, finite points of the plane, or the thickness is negative.

    Examples
    --------
    >>> from divbandit.environments import PlanarArm, Wall
    >>> arm = PlanarArm(1, limit=3.0, thickness=0.02, obstacles=[Wall([0, 0.5], [0, 2])])
    >>> round(float(arm.progress([2.0])), 6)     # upright, less half the thickness of the link
    0.775397
    """

    start: tuple[float, ...]
    end: tuple[float, ...]
    thickness: float

    def __init__(self, start: ArrayLike, end: ArrayLike, *, thickness: float = 0.0) -> None:
        kernel = _core.Obstacle.wall(start, end, thickness)
        self._set(
            start=floats("start", start, 2),
            end=floats("end", end, 2),
            thickness=float(thickness),
            _kernel=kernel,
        )
