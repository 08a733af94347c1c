"""PlanarArm: the paper's environment."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from divbandit import _core
from divbandit._checks import positive, truth
from divbandit._value import Value
from divbandit.box import Box
from divbandit.environments.obstacles import checked, kernels

if TYPE_CHECKING:
    from collections.abc import Iterable

    from numpy.typing import ArrayLike, NDArray

    from divbandit.environments.obstacles import Obstacle

#: The smallest thickness of links, in metres.
_THINNEST = 1e-6


@dataclass(frozen=True, init=False, repr=False)
class PlanarArm(Value):
    """A planar arm: joint angles in, position of the tip out.

    The environment of Benureau and Oudeyer (2015). Its segments have equal length and are
    together 1 m long; its base is at the origin. Each angle, in radians, is relative to the
    previous segment; with all angles 0 the arm lies along +x.

    Parameters
    ----------
    joints : int
        Number of joints, from 1 to 100,000.
    limit : float
        The limit of every joint in radians: angles lie in [-limit, limit].
    thickness : float
        Thickness of the links, in metres. Links are capsules: their ends are rounded. It matters
        only if there are obstacles or self-contact; it is then at least 1e-6 and less than the
        length of a link.
    obstacles : iterable of Disc, Rectangle, Polygon and Wall
        What is in the way. The arm moves from rest, all angles 0, along the straight line in joint
        space and stops at the first contact: the effect is the position of the tip there. The
        contact is located to within 1e-9 of the motion, always on the side where the arm is clear.
    self_contact : bool
        Whether links that are not neighbours stop each other, too.

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
        arm touches an obstacle at rest.

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

    With a post in the way, a single link stops when its side touches the post:

    >>> post = db.environments.Disc([0, 0.5], 0.1)
    >>> arm = db.PlanarArm(1, thickness=0.02, obstacles=[post])
    >>> arm([math.radians(150)]).round(6)
    array([0.22  , 0.9755])
    """

    joints: int
    limit: float
    thickness: float
    obstacles: tuple[Obstacle, ...]
    self_contact: bool

    if TYPE_CHECKING:
        motor_space: Box
        sensory_space: Box
        #: What the engine explores, and what moves among obstacles.
        _kernel: _core.PlanarArm | _core.ObstructedArm
        _moving: _core.ObstructedArm

    def __init__(
        self,
        joints: int = 20,
        *,
        limit: float = math.radians(150),
        thickness: float = 0.01,
        obstacles: Iterable[Obstacle] = (),
        self_contact: bool = False,
    ) -> None:
        arm = _core.PlanarArm(joints, limit)
        obstacles = checked(obstacles)
        thickness = positive("thickness", thickness)
        self_contact = truth("self_contact", self_contact)
        free = not (obstacles or self_contact)
        # A free arm touches nothing, so that any thickness will do.
        thick = _THINNEST if free else thickness
        moving = _core.ObstructedArm(arm, thick, kernels(obstacles), self_contact)
        highest = np.full(arm.joints, arm.limit)
        self._set(
            joints=arm.joints,
            limit=arm.limit,
            thickness=thickness,
            obstacles=obstacles,
            self_contact=self_contact,
            motor_space=Box(-highest, highest),
            sensory_space=Box([-1, -1], [1, 1]),
            _kernel=arm if free else moving,
            _moving=moving,
        )

    def __call__(self, command: ArrayLike) -> NDArray[np.float64]:
        """Return the position of the tip for one command, or for each of many.

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
            If the shape is wrong, or an angle is not finite or beyond the limit.

        Examples
        --------
        >>> import divbandit as db
        >>> db.PlanarArm(3)([0, 0, 0])
        array([1., 0.])
        """
        return self._kernel.effect(command)

    def posture(self, command: ArrayLike) -> NDArray[np.float64]:
        """Return the posture of the arm: its base, then the far end of each segment, up to the tip.

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
            If the shape is wrong, or an angle is not finite or beyond the limit.

        Examples
        --------
        >>> import divbandit as db
        >>> db.PlanarArm(2).posture([0, 0])
        array([[0. , 0. ],
               [0.5, 0. ],
               [1. , 0. ]])
        """
        return self._kernel.posture(command)

    def progress(self, command: ArrayLike) -> NDArray[np.float64]:
        """Return how far the arm gets from rest towards a command, or towards each of many.

        Parameters
        ----------
        command : array_like, shape (joints,) or (n, joints)
            Angles in radians.

        Returns
        -------
        numpy.ndarray of float64, shape () or (n,)
            The fraction of the motion: 1 if nothing stops it.

        Raises
        ------
        TypeError, ValueError
            If the shape is wrong, or an angle is not finite or beyond the limit.

        Examples
        --------
        >>> import divbandit as db
        >>> arm = db.PlanarArm(1, obstacles=[db.environments.Wall([-1, 0.5], [1, 0.5])])
        >>> arm.progress([[0.5], [1.0]]).round(6)
        array([1.      , 0.517835])
        """
        return self._moving.progress(command)[..., 0]

    def follow(self, trajectory: ArrayLike) -> NDArray[np.float64]:
        """Return the position of the tip after the arm has followed a trajectory as far as it can.

        Parameters
        ----------
        trajectory : array_like, shape (k, joints) or (n, k, joints)
            Postures in radians, the first of them rest. From each to the next the arm moves along a
            straight line in joint space; it stays where it is stopped.

        Returns
        -------
        numpy.ndarray of float64, shape (2,) or (n, 2)
            x and y in metres.

        Raises
        ------
        TypeError, ValueError
            If the shape is wrong, there are no rows, an angle is not finite or beyond the limit, or
            the first posture is not rest.

        Examples
        --------
        >>> import divbandit as db
        >>> arm = db.PlanarArm(2, obstacles=[db.environments.Wall([0.9, 0.5], [0.6, 0.5])])
        >>> arm.follow([[0, 0], [0, 1.5], [0.9, 0.3]]).round(6)     # folded first, it passes
        array([0.491984, 0.857683])
        >>> arm([0.9, 0.3]).round(6)
        array([0.865725, 0.495   ])
        """
        return each_followed(self._moving, trajectory)


def each_followed(arm: _core.ObstructedArm, trajectory: ArrayLike) -> NDArray[np.float64]:
    """Return the effect of following one trajectory, or those of following many."""
    try:
        many = np.ndim(trajectory) == 3
    except ValueError:  # ragged: the arm says so
        many = False
    if not many:
        return arm.follow(trajectory)
    effects = [arm.follow(each) for each in np.asarray(trajectory)]
    return np.stack(effects) if effects else np.empty((0, 2))
