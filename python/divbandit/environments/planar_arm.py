"""PlanarArm: the paper's environment."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

import numpy as np

from divbandit import _core
from divbandit._checks import positive, truth
from divbandit.box import Box
from divbandit.environments.obstacles import checked

if TYPE_CHECKING:
    from collections.abc import Iterable

    from numpy.typing import ArrayLike, NDArray

    from divbandit._engine import Description
    from divbandit.environments.obstacles import Obstacle

#: The thinnest links that can be followed, in metres.
_THINNEST = 1e-6


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
    thickness : float
        Of its links, in metres; they are capsules, that is, their ends are rounded. It matters
        where they can touch something, and is at least 1e-6 and less than a link is long then.
    obstacles : iterable of Disc, Rectangle, Polygon and Wall
        What is in its way. The arm moves from rest, all angles 0, along the straight line in joint
        space, and stops at the first contact: the effect is where the tip is then. Contact is found
        to 1e-9 of the way; the clearance left is positive.
    self_contact : bool
        Whether links that are no neighbours stop each other, too.

    Attributes
    ----------
    motor_space : Box
        [-limit, limit]^joints, in radians.
    sensory_space : Box
        [-1, 1] x [-1, 1], in metres.

    Raises
    ------
    TypeError, ValueError
        If `joints` is not a whole number in its range, `limit` is not positive and finite, or the
        arm at rest touches an obstacle.

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

    With a post in its way, one link stops where its side touches it:

    >>> arm = db.PlanarArm(1, thickness=0.02, obstacles=[db.Disc([0, 0.5], 0.1)])
    >>> arm([math.radians(150)]).round(6)
    array([0.22  , 0.9755])
    """

    motor_space: Box
    sensory_space: Box

    def __init__(
        self,
        joints: int = 20,
        *,
        limit: float = math.radians(150),
        thickness: float = 0.01,
        obstacles: Iterable[Obstacle] = (),
        self_contact: bool = False,
    ) -> None:
        self._kernel = _core.PlanarArm(joints, limit)
        self.obstacles = checked(obstacles)
        self._thickness = positive("thickness", thickness)
        self._self_contact = truth("self_contact", self_contact)
        kernels = [each._kernel for each in self.obstacles]  # noqa: SLF001 - made for this
        self._free = not (kernels or self_contact)
        # Where nothing can be touched any thickness will do.
        thick = _THINNEST if self._free else self._thickness
        self._obstructed = _core.ObstructedArm(self._kernel, thick, kernels, self._self_contact)
        self._moving: _core.ObstructedArm | _core.PushArm = self._obstructed
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

    @property
    def thickness(self) -> float:
        """How thick its links are, in metres."""
        return self._thickness

    @property
    def self_contact(self) -> bool:
        """Whether links that are no neighbours stop each other."""
        return self._self_contact

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
        return (self._kernel if self._free else self._moving).effect(command)

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
        return (self._kernel if self._free else self._moving).posture(command)

    def progress(self, command: ArrayLike) -> NDArray[np.float64]:
        """Return how far the arm gets on its way from rest to a command, or to each of many.

        Parameters
        ----------
        command : array_like, shape (joints,) or (n, joints)
            Angles in radians.

        Returns
        -------
        numpy.ndarray of float64, shape () or (n,)
            The share of the way: 1 where nothing stops it.

        Raises
        ------
        TypeError, ValueError
            If it has another shape, or an angle is not finite or beyond the limit.

        Examples
        --------
        >>> import divbandit as db
        >>> arm = db.PlanarArm(1, obstacles=[db.Wall([-1, 0.5], [1, 0.5])])
        >>> arm.progress([[0.5], [1.0]]).round(6)
        array([1.      , 0.517835])
        """
        return self._moving.progress(command)[..., 0]

    def follow(self, trajectory: ArrayLike) -> NDArray[np.float64]:
        """Return where the tip is when the arm has followed a trajectory as far as it can.

        Parameters
        ----------
        trajectory : array_like, shape (k, joints) or (n, k, joints)
            Postures in radians, the first of them rest; the arm goes along straight lines in joint
            space from each to the next, and stays where something stops it.

        Returns
        -------
        numpy.ndarray of float64, shape (2,) or (n, 2)
            x and y in metres.

        Raises
        ------
        TypeError, ValueError
            If it has another shape or no rows, an angle is not finite or beyond the limit, or the
            first posture is not rest.

        Examples
        --------
        >>> import divbandit as db
        >>> arm = db.PlanarArm(2, obstacles=[db.Wall([0.9, 0.5], [0.6, 0.5])])
        >>> arm.follow([[0, 0], [0, 1.5], [0.9, 0.3]]).round(6)     # folded first, it passes
        array([0.491984, 0.857683])
        >>> arm([0.9, 0.3]).round(6)
        array([0.865725, 0.495   ])
        """
        return each_followed(self._moving, trajectory)

    def _describe(self, description: Description) -> tuple[int, int]:
        if self._free:
            return description.engine.planar_arm(self._kernel)
        return description.engine.obstructed_arm(self._obstructed)

    def __repr__(self) -> str:
        free = f"PlanarArm({self.joints}, limit={self.limit!r}"
        if self._free:
            return f"{free})"
        return (
            f"{free}, thickness={self.thickness!r}, obstacles={list(self.obstacles)!r}, "
            f"self_contact={self.self_contact!r})"
        )

    def __reduce__(self) -> tuple[object, ...]:
        kept = (self.joints, self.limit, self.thickness, self.obstacles, self.self_contact)
        return _rebuild, kept


def each_followed(
    arm: _core.ObstructedArm | _core.PushArm, trajectory: ArrayLike
) -> NDArray[np.float64]:
    """Return the effect of following one trajectory, or those of following many.

    Examples
    --------
    >>> import divbandit as db
    >>> each_followed(db.PlanarArm(2)._moving, [[[0, 0], [1, 0]], [[0, 0], [0, 0]]]).shape
    (2, 2)
    """
    try:
        many = np.ndim(trajectory) == 3
    except ValueError:  # ragged: the arm says so
        many = False
    if not many:
        return arm.follow(trajectory)
    effects = [arm.follow(each) for each in np.asarray(trajectory)]
    return np.stack(effects) if effects else np.empty((0, 2))


def _rebuild(
    joints: int,
    limit: float,
    thickness: float,
    obstacles: tuple[Obstacle, ...],
    self_contact: bool,  # noqa: FBT001 - as pickle passes it
) -> PlanarArm:
    return PlanarArm(
        joints, limit=limit, thickness=thickness, obstacles=obstacles, self_contact=self_contact
    )
