"""ViaPoints: joints that go smoothly through positions which the command names."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from divbandit._checks import whole
from divbandit._core import as_point
from divbandit.box import Box

if TYPE_CHECKING:
    from numpy.typing import ArrayLike, NDArray


class ViaPoints:
    """Trajectories through positions of all joints, evenly spaced in time.

    From one to the next each joint goes with minimum jerk (Flash and Hogan 1985), and all come to
    rest there. A command has the joints' positions at the first point, then at the second,
    and so on.

    Parameters
    ----------
    low, high : array_like, shape (dofs,)
        Between which positions the points lie, in radians (or metres).
    steps : int
        How many steps a trajectory has.
    points : int
        How many points there are; at most `steps`.
    start : array_like, shape (dofs,), optional
        Where a trajectory starts. Without one, at 0.

    Attributes
    ----------
    low, high, start : numpy.ndarray of float64, shape (dofs,)
    steps, points : int
    motor_space : Box
        [low, high] for each point, of ``points * dofs`` dimensions.

    Raises
    ------
    TypeError, ValueError
        If an argument is not what it must be.

    Examples
    --------
    >>> from divbandit.controllers import ViaPoints
    >>> points = ViaPoints([-1.0], [1.0], steps=4, points=2)
    >>> points.motor_space
    Box([-1.0, -1.0], [1.0, 1.0])
    >>> points.trajectory([1.0, 0.5]).ravel()
    array([0.  , 0.5 , 1.  , 0.75, 0.5 ])
    """

    motor_space: Box

    def __init__(
        self,
        low: ArrayLike,
        high: ArrayLike,
        *,
        steps: int,
        points: int = 1,
        start: ArrayLike | None = None,
    ) -> None:
        positions = Box(low, high)
        self.low, self.high = positions.low, positions.high
        self.steps = whole("steps", steps, low=1)
        self.points = whole("points", points, low=1, high=self.steps)
        at = np.zeros(positions.dim) if start is None else start
        self.start = as_point("start", at, positions.dim)
        self.motor_space = Box(np.tile(self.low, self.points), np.tile(self.high, self.points))
        # Of each row: between which points it is, and what share of the way it has gone.
        place = np.arange(self.steps + 1) * self.points
        self._after = np.minimum(place // self.steps, self.points - 1)
        time = (place - self._after * self.steps) / self.steps
        self._share = time * time * time * (10.0 + time * (6.0 * time - 15.0))

    def trajectory(self, command: ArrayLike) -> NDArray[np.float64]:
        """Return the trajectory of one command, or those of many.

        Parameters
        ----------
        command : array_like, shape (m,) or (n, m)

        Returns
        -------
        numpy.ndarray of float64, shape (steps + 1, dofs) or (n, steps + 1, dofs)

        Raises
        ------
        TypeError, ValueError
            If a command is no point of the motor space.

        Examples
        --------
        >>> from divbandit.controllers import ViaPoints
        >>> ViaPoints([0, 0], [1, 1], steps=1).trajectory([0.5, 1.0])
        array([[0. , 0. ],
               [0.5, 1. ]])
        """
        commands = self.motor_space.bounds.commands(command)
        many = commands.shape[:-1]
        start = np.broadcast_to(self.start, (*many, 1, len(self.start)))
        named = commands.reshape(*many, self.points, len(self.start))
        points = np.concatenate([start, named], axis=-2)
        before, after = points[..., self._after, :], points[..., self._after + 1, :]
        way: NDArray[np.float64] = before + self._share[:, None] * (after - before)
        return way

    def __repr__(self) -> str:
        text = f"{self.low.tolist()}, {self.high.tolist()}, steps={self.steps}"
        return f"ViaPoints({text}, points={self.points}, start={self.start.tolist()})"
