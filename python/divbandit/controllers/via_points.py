"""ViaPoints: smooth trajectories through the positions that a command holds."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from divbandit._checks import floats, whole
from divbandit._value import Value
from divbandit.box import Box

if TYPE_CHECKING:
    from numpy.typing import ArrayLike, NDArray


@dataclass(frozen=True, init=False, repr=False)
class ViaPoints(Value):
    """Trajectories through positions of all joints, evenly spaced in time.

    Each joint moves from point to point with minimum jerk (Flash and Hogan 1985), and all joints
    come to rest at each point. A command holds the positions of the joints at the first point, then
    at the second, and so on.

    Parameters
    ----------
    low, high : array_like, shape (dofs,)
        The range of the positions, in radians (or metres).
    steps : int
        Number of steps of a trajectory.
    points : int
        Number of points; at most `steps`.
    start : array_like, shape (dofs,), optional
        Where a trajectory starts; 0 by default.

    Attributes
    ----------
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

    low: tuple[float, ...]
    high: tuple[float, ...]
    steps: int
    points: int
    start: tuple[float, ...] | None

    if TYPE_CHECKING:
        motor_space: Box
        #: Of each row: the index of the point before it, and the fraction of the way from there.
        _before: NDArray[np.int64]
        _fraction: NDArray[np.float64]

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
        steps = whole("steps", steps, low=1)
        points = whole("points", points, low=1, high=steps)
        place = np.arange(steps + 1) * points
        before = np.minimum(place // steps, points - 1)
        time = (place - before * steps) / steps
        self._set(
            low=tuple(positions.low.tolist()),
            high=tuple(positions.high.tolist()),
            steps=steps,
            points=points,
            start=None if start is None else floats("start", start, positions.dim),
            motor_space=Box(np.tile(positions.low, points), np.tile(positions.high, points)),
            _before=before,
            _fraction=time * time * time * (10.0 + time * (6.0 * time - 15.0)),
        )

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
            If a command is not a point of the motor space.

        Examples
        --------
        >>> from divbandit.controllers import ViaPoints
        >>> ViaPoints([0, 0], [1, 1], steps=1).trajectory([0.5, 1.0])
        array([[0. , 0. ],
               [0.5, 1. ]])
        """
        commands = self.motor_space.bounds.commands(command)
        many, dofs = commands.shape[:-1], len(self.low)
        start = np.zeros(dofs) if self.start is None else self.start
        first = np.broadcast_to(start, (*many, 1, dofs))
        points = np.concatenate([first, commands.reshape(*many, self.points, dofs)], axis=-2)
        before, after = points[..., self._before, :], points[..., self._before + 1, :]
        rows: NDArray[np.float64] = before + self._fraction[:, None] * (after - before)
        return rows
