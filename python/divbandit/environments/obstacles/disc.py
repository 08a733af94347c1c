"""Disc: a round obstacle."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

from divbandit import _core
from divbandit._checks import floats
from divbandit.environments.obstacles.base import Obstacle

if TYPE_CHECKING:
    from numpy.typing import ArrayLike


@dataclass(frozen=True, init=False, repr=False)
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
        If the center is not a finite point of the plane, or the radius is not positive.

    Examples
    --------
    >>> from divbandit.environments import Disc, PlanarArm
    >>> arm = PlanarArm(1, thickness=0.1, obstacles=[Disc([0, 0.5], 0.1)])
    >>> bool(arm.progress([1.6]) < 1)
    True
    """

    center: tuple[float, ...]
    radius: float

    def __init__(self, center: ArrayLike, radius: float) -> None:
        kernel = _core.Obstacle.disc(center, radius)
        self._set(center=floats("center", center, 2), radius=float(radius), _kernel=kernel)
