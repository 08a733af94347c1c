"""PushArm: an arm that pushes a ball; the effect is where the ball ends."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

import numpy as np

from divbandit import _core
from divbandit._checks import real
from divbandit.box import Box
from divbandit.environments.planar_arm import PlanarArm

if TYPE_CHECKING:
    from collections.abc import Iterable

    from numpy.typing import ArrayLike, NDArray

    from divbandit._engine import Description
    from divbandit.environments.obstacles import Obstacle


class PushArm(PlanarArm):
    """A planar arm and a ball: joint angles in, position of the ball out.

    The arm moves as a `PlanarArm` does, with thick links and among obstacles, as if the ball were
    not there. Where a link comes to the ball, the ball gives way: it goes where it is clear of all
    links and obstacles by the least displacement, without friction and without inertia. Where there
    is no such place it is pinned: arm and ball stop. Of 100 commands drawn at random some 90 never
    touch it, where it is by default.

    Parameters
    ----------
    joints : int
        Number of joints, from 1 to 100,000.
    limit : float
        Every joint's limit in radians.
    thickness : float
        Of the links, in metres; at least 1e-6 and less than a link is long.
    obstacles : iterable of Disc, Rectangle, Polygon and Wall
        What stops the arm and holds the ball.
    self_contact : bool
        Whether links that are no neighbours stop each other.
    ball : array_like, shape (2,)
        Where the ball's center is at first, in metres.
    ball_radius : float
        In metres, from 0.001 to 1.

    Attributes
    ----------
    motor_space : Box
        [-limit, limit]^joints, in radians.
    sensory_space : Box
        The square around the base that the ball cannot be pushed out of, in metres.
    ball : numpy.ndarray of float64, shape (2,)

    Raises
    ------
    TypeError, ValueError
        If an argument is not what it must be, the arm at rest touches an obstacle, or the ball
        touches one of them.

    Examples
    --------
    >>> import divbandit as db
    >>> arm = db.PushArm(1, thickness=0.02, ball=[0, 0.5], ball_radius=0.04)
    >>> arm([[1.0], [-1.0]])                  # not as far as the ball
    array([[0. , 0.5],
           [0. , 0.5]])
    >>> arm([2.0]).round(3)                   # it has slid outwards along the link
    array([-0.263,  0.456])

    A ball between a link and two posts is pinned, and stops the arm:

    >>> posts = [db.Disc([0, 0.44], 0.02), db.Disc([0, 0.56], 0.02)]
    >>> arm = db.PushArm(1, obstacles=posts, ball=[0.2, 0.45], ball_radius=0.1)
    >>> bool(arm.progress([2.0]) < db.PlanarArm(1, obstacles=posts).progress([2.0]))
    True
    """

    ball: NDArray[np.float64]

    def __init__(
        self,
        joints: int = 20,
        *,
        limit: float = math.radians(150),
        thickness: float = 0.01,
        obstacles: Iterable[Obstacle] = (),
        self_contact: bool = False,
        ball: ArrayLike = (-0.5, 0.3),
        ball_radius: float = 0.05,
    ) -> None:
        super().__init__(
            joints,
            limit=limit,
            thickness=thickness,
            obstacles=obstacles,
            self_contact=self_contact,
        )
        kernels = [each._kernel for each in self.obstacles]  # noqa: SLF001 - made for this
        arm = _core.ObstructedArm(self._kernel, self.thickness, kernels, self.self_contact)
        self._moving = self._pushing = _core.PushArm(arm, ball, ball_radius)
        self._free = False
        self.ball = _core.as_point("ball", ball, 2)
        self._ball_radius = real("ball_radius", ball_radius)
        beyond = self.thickness / 2 + 2 * self.ball_radius
        reach = max(1.0 + beyond, *np.abs(self.ball))
        self.sensory_space = Box([-reach, -reach], [reach, reach])

    @property
    def ball_radius(self) -> float:
        """The ball's radius, in metres."""
        return self._ball_radius

    def __call__(self, command: ArrayLike) -> NDArray[np.float64]:
        """Return where the ball ends, for one command or for many.

        Parameters
        ----------
        command : array_like, shape (joints,) or (n, joints)
            Angles in radians.

        Returns
        -------
        numpy.ndarray of float64, shape (2,) or (n, 2)
            x and y of its center in metres.

        Raises
        ------
        TypeError, ValueError
            If it has another shape, or an angle is not finite or beyond the limit.

        Examples
        --------
        >>> import divbandit as db
        >>> db.PushArm(3)([0, 0, 0])
        array([-0.5,  0.3])
        """
        return self._pushing.effect(command)

    def path(self, command: ArrayLike) -> NDArray[np.float64]:
        """Return how the ball moves.

        Parameters
        ----------
        command : array_like, shape (joints,)
            Angles in radians.

        Returns
        -------
        numpy.ndarray of float64, shape (k, 3)
            The share of the way of the arm, from 0 to where it stops, and the ball's x and y. The
            ball is looked at whenever it may have been pushed by a fiftieth of its radius.

        Raises
        ------
        TypeError, ValueError
            If it has another shape, or an angle is not finite or beyond the limit.

        Examples
        --------
        >>> import divbandit as db
        >>> db.PushArm(2).path([0.1, 0.1])
        array([[ 0. , -0.5,  0.3],
               [ 1. , -0.5,  0.3]])
        """
        return self._pushing.path(command)

    def _describe(self, description: Description) -> tuple[int, int]:
        return description.engine.push_arm(self._pushing)

    def __repr__(self) -> str:
        return (
            f"PushArm({self.joints}, limit={self.limit!r}, thickness={self.thickness!r}, "
            f"obstacles={list(self.obstacles)!r}, self_contact={self.self_contact!r}, "
            f"ball={self.ball.tolist()!r}, ball_radius={self.ball_radius!r})"
        )

    def __reduce__(self) -> tuple[object, ...]:
        return _rebuild, (
            self.joints,
            {
                "limit": self.limit,
                "thickness": self.thickness,
                "obstacles": self.obstacles,
                "self_contact": self.self_contact,
                "ball": self.ball,
                "ball_radius": self.ball_radius,
            },
        )


def _rebuild(joints: int, arguments: dict[str, object]) -> PushArm:
    return PushArm(joints, **arguments)  # type: ignore[arg-type]
