"""PlanarArm: the paper's environment."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

import numpy as np

from divbandit import _core
from divbandit.box import Box

if TYPE_CHECKING:
    from numpy.typing import ArrayLike, NDArray

    from divbandit._engine import Description


class PlanarArm:
    """A planar arm: joint angles in, position of the tip out.

    The environment of Benureau and Oudeyer (2015). Its segments are equal and
    together 1 m long, its base is at the origin. Each angle, in radians, is relative to the
    segment before; with all of them 0 the arm lies along +x.

    Parameters
    ----------
    joints : int
        Number of joints, from 1 to 100,000.
    limit : float
        Every joint's limit in radians: angles lie in [-limit, limit].

    Attributes
    ----------
    motor_space : Box
        [-limit, limit]^joints, in radians.
    sensory_space : Box
        [-1, 1] x [-1, 1], in metres.

    Raises
    ------
    TypeError, ValueError
        If `joints` is not a whole number in its range, or `limit` is not positive and finite.

    Examples
    --------
    >>> import math
    >>> import divbandit as db
    >>> arm = db.PlanarArm(2, limit=math.radians(150))
    >>> arm([0, math.pi / 2]).round(12)
    array([0.5, 0.5])
    >>> arm([[0, 0], [math.pi / 2, 0]]).round(12)
    array([[1., 0.],
           [0., 1.]])
    """

    motor_space: Box
    sensory_space: Box

    def __init__(self, joints: int = 20, *, limit: float = math.radians(150)) -> None:
        self._kernel = _core.PlanarArm(joints, limit)
        highest = np.full(self._kernel.joints, self._kernel.limit)
        self.motor_space = Box(-highest, highest)
        self.sensory_space = Box([-1, -1], [1, 1])

    @property
    def joints(self) -> int:
        """The number of joints."""
        return self._kernel.joints

    @property
    def limit(self) -> float:
        """Every joint's limit, in radians."""
        return self._kernel.limit

    def __call__(self, command: ArrayLike) -> NDArray[np.float64]:
        """Return the tip's position for one command or for many.

        Parameters
        ----------
        command : array_like, shape (joints,) or (n, joints)
            Angles in radians.

        Returns
        -------
        numpy.ndarray of float64, shape (2,) or (n, 2)
            x and y in metres.

        Raises
        ------
        TypeError, ValueError
            If it has another shape, or an angle is not finite or beyond the limit.

        Examples
        --------
        >>> import divbandit as db
        >>> db.PlanarArm(3)([0, 0, 0])
        array([1., 0.])
        """
        return self._kernel.effect(command)

    def posture(self, command: ArrayLike) -> NDArray[np.float64]:
        """Return where the arm lies: the base, each joint's far end and, last, the tip.

        Parameters
        ----------
        command : array_like, shape (joints,)
            Angles in radians.

        Returns
        -------
        numpy.ndarray of float64, shape (joints + 1, 2)
            x and y in metres; the last row equals the effect.

        Raises
        ------
        TypeError, ValueError
            If it has another shape, or an angle is not finite or beyond the limit.

        Examples
        --------
        >>> import divbandit as db
        >>> db.PlanarArm(2).posture([0, 0])
        array([[0. , 0. ],
               [0.5, 0. ],
               [1. , 0. ]])
        """
        return self._kernel.posture(command)

    def _describe(self, description: Description) -> tuple[int, int]:
        return description.engine.planar_arm(self._kernel)

    def __repr__(self) -> str:
        return f"PlanarArm({self.joints}, limit={self.limit!r})"

    def __reduce__(self) -> tuple[object, ...]:
        return _rebuild, (self.joints, self.limit)


def _rebuild(joints: int, limit: float) -> PlanarArm:
    return PlanarArm(joints, limit=limit)
