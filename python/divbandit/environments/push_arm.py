"""PushArm: an arm that pushes a ball; the effect is the final position of the ball."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from divbandit import _core
from divbandit._checks import floats, real
from divbandit.box import Box
from divbandit.environments.obstacles import kernels
from divbandit.environments.planar_arm import PlanarArm

if TYPE_CHECKING:
    from collections.abc import Iterable

    from numpy.typing import ArrayLike, NDArray

    from divbandit.environments.obstacles import Obstacle


@dataclass(frozen=True, init=False, repr=False)
class PushArm(PlanarArm):
    """A planar arm and a ball: joint angles in, position of the ball out.

    The arm moves like a `PlanarArm` with thick links among obstacles, as if the ball were not
    there. When a link reaches the ball, the ball gives way: it is displaced by the shortest way to
    a position clear of all links and obstacles, without friction and without inertia. If there is
    no such position, the ball is pinned: arm and ball stop. By default about 90 of 100 random
    commands never touch the ball.

    Parameters
    ----------
    joints : int
        Number of joints, from 1 to 100,000.
    limit : float
        The limit of every joint in radians.
    thickness : float
        Thickness of the links, in metres; at least 1e-6 and less than the length of a link.
    obstacles : iterable of Disc, Rectangle, Polygon and Wall
        What stops the arm and holds the ball.
    self_contact : bool
        Whether links that are not neighbours stop each other.
    ball : array_like, shape (2,)
        Initial position of the ball's center, in metres.
    ball_radius : float
        In metres, from 0.001 to 1.

    Attributes
    ----------
    motor_space : Box
        [-limit, limit]^joints, in radians.
    sensory_space : Box
        A square around the base, in metres, that the ball cannot leave.

    Raises
    ------
    TypeError, ValueError
        If an argument is not what it must be, or, at rest, the arm touches an obstacle or the ball
        touches the arm or an obstacle.

    Examples
    --------
    >>> from divbandit.environments import Disc, PlanarArm, PushArm
    >>> arm = PushArm(1, thickness=0.02, ball=[0, 0.5], ball_radius=0.04)
    >>> arm([[1.0], [-1.0]])                  # does not reach the ball
    array([[0. , 0.5],
           [0. , 0.5]])
    >>> arm([2.0]).round(3)                   # the ball slid outwards along the link
    array([-0.263,  0.456])

    A ball between a link and two posts is pinned, and stops the arm:

    >>> posts = [Disc([0, 0.44], 0.02), Disc([0, 0.56], 0.02)]
    >>> arm = PushArm(1, obstacles=posts, ball=[0.2, 0.45], ball_radius=0.1)
    >>> bool(arm.progress([2.0]) < PlanarArm(1, obstacles=posts).progress([2.0]))
    True
    """

    ball: tuple[float, ...]
    ball_radius: float

    if TYPE_CHECKING:
        _kernel: _core.ObstructedArm

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
        arm = _core.PlanarArm(self.joints, self.limit)
        obstructed = _core.ObstructedArm(
            arm, self.thickness, kernels(self.obstacles), self.self_contact
        )
        kernel = obstructed.pushing(ball, ball_radius)
        ball, ball_radius = floats("ball", ball, 2), real("ball_radius", ball_radius)
        beyond = self.thickness / 2 + 2 * ball_radius
        reach = max(1.0 + beyond, *np.abs(ball))
        self._set(
            ball=ball,
            ball_radius=ball_radius,
            sensory_space=Box([-reach, -reach], [reach, reach]),
            _kernel=kernel,
            _moving=kernel,
        )

    def __call__(self, command: ArrayLike) -> NDArray[np.float64]:
        """Return the final position of the ball for one command, or for each of many.

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
            If the shape is wrong, or an angle is not finite or beyond the limit.

        Examples
        --------
        >>> from divbandit.environments import PushArm
        >>> PushArm(3)([0, 0, 0])
        array([-0.5,  0.3])
        """
        return self._kernel.effect(command)

    def path(self, command: ArrayLike) -> NDArray[np.float64]:
        """Return the path of the ball.

        Parameters
        ----------
        command : array_like, shape (joints,)
            Angles in radians.

        Returns
        -------
        numpy.ndarray of float64, shape (k, 3)
            The fraction of the arm's motion, from 0 to where it stops, and x and y of the ball.
            There is a row whenever the ball may have moved by a fiftieth of its radius.

        Raises
        ------
        TypeError, ValueError
            If the shape is wrong, or an angle is not finite or beyond the limit.

        Examples
        --------
        >>> from divbandit.environments import PushArm
        >>> PushArm(2).path([0.1, 0.1])
        array([[ 0. , -0.5,  0.3],
               [ 1. , -0.5,  0.3]])
        """
        return self._kernel.path(command)
