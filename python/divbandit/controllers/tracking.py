"""Tracking: torques that make joints follow a trajectory, like springs and dampers."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np

from divbandit._checks import per_coordinate, positive, truth
from divbandit._core import as_point
from divbandit._value import Value
from divbandit.controllers._rows import motor_space_of, rows_of

if TYPE_CHECKING:
    from collections.abc import Callable

    from numpy.typing import ArrayLike, NDArray

    from divbandit._checks import PerCoordinate
    from divbandit.box import Box
    from divbandit.controllers.protocol import Policy, Trajectories

    Reading = Callable[[Any], ArrayLike]


@dataclass(frozen=True, init=False, repr=False)
class Tracking(Value):
    """A controller that makes joints follow a trajectory (a PD controller).

    In step k it pulls towards row k + 1, where the joints should be at the end of the step, at the
    velocity that leads there from row k::

        action = stiffness * (q_ref - q) + damping * (v_ref - v)

    After the last row it holds the joints there.

    Parameters
    ----------
    primitives : object with ``motor_space`` and ``trajectory(command)``
        Such as `MovementPrimitives`; a row holds the target positions of the joints, in radians
        (or metres).
    positions, velocities : callable
        Read the positions and the velocities of the joints from an observation: two arrays of
        shape (dofs,), in radians and radians per second.
    dt : float
        The duration of a step, which is the time between rows, in seconds.
    stiffness, damping : float or array_like, shape (dofs,)
        The action per radian of error, and per radian per second of error, of all joints or of
        each. At least 0.
    limit : float or array_like, shape (dofs,), optional
        The largest absolute value of an action. By default only the body limits actions.
    turns : bool
        Whether positions are known only up to full turns, for example because they are computed
        from a cosine and a sine. Each position is then unwrapped: shifted by full turns to be
        nearest to the previous one, and the first to the start of the trajectory. So a joint can
        be led through several turns, and does not take the shorter way past a joint limit.

    Attributes
    ----------
    motor_space : Box
        That of `primitives`.

    Raises
    ------
    TypeError, ValueError
        If an argument is not what it must be.

    Examples
    --------
    >>> from types import SimpleNamespace
    >>> import numpy as np
    >>> import divbandit as db
    >>> from divbandit.controllers import Tracking
    >>> ramp = SimpleNamespace(
    ...     motor_space=db.Box([-1], [1]),
    ...     trajectory=lambda command: np.linspace([0.0], command, 11),
    ... )
    >>> tracking = Tracking(
    ...     ramp, lambda seen: seen[:1], lambda seen: seen[1:], dt=0.5, stiffness=2.0, damping=1.0
    ... )
    >>> act = tracking.begin(np.array([1.0]))
    >>> act(0, np.array([0.0, 0.0])).round(12)  # 2 * 0.1 + 1 * 0.1 / 0.5
    array([0.4])
    """

    primitives: Trajectories
    positions: Reading
    velocities: Reading
    dt: float
    stiffness: PerCoordinate
    damping: PerCoordinate
    limit: PerCoordinate | None
    turns: bool

    if TYPE_CHECKING:
        motor_space: Box

    def __init__(
        self,
        primitives: Trajectories,
        positions: Reading,
        velocities: Reading,
        *,
        dt: float,
        stiffness: ArrayLike,
        damping: ArrayLike,
        limit: ArrayLike | None = None,
        turns: bool = False,
    ) -> None:
        motor_space = motor_space_of(primitives)
        for name, reading in (("positions", positions), ("velocities", velocities)):
            if not callable(reading):
                raise TypeError(f"{name} must be callable, got {type(reading).__name__}")
        self._set(
            primitives=primitives,
            positions=positions,
            velocities=velocities,
            dt=positive("dt", dt),
            stiffness=_strength("stiffness", stiffness),
            damping=_strength("damping", damping),
            limit=None if limit is None else _strength("limit", limit),
            turns=truth("turns", turns),
            motor_space=motor_space,
        )

    def begin(self, command: NDArray[np.float64]) -> Policy:
        """Return the policy of an episode.

        Parameters
        ----------
        command : numpy.ndarray of float64, shape (m,)

        Returns
        -------
        callable
            ``(step, observation) -> action``, of shape (dofs,); for one episode, step by step.

        Raises
        ------
        ValueError
            If `primitives` does not return a trajectory, or its number of joints is not that of
            `stiffness`, `damping` or `limit`. The policy raises it if the number of positions or
            velocities is another one.

        Examples
        --------
        >>> import numpy as np
        >>> import divbandit as db
        >>> class Turn:
        ...     motor_space = db.Box([-9], [9])
        ...     def trajectory(self, command):
        ...         return np.linspace([0.0], command, 5)
        >>> def angle(seen):
        ...     return [np.arctan2(seen[1], seen[0])]
        >>> tracking = db.controllers.Tracking(
        ...     Turn(), angle, lambda seen: seen[2:], dt=1, stiffness=1, damping=0, turns=True
        ... )
        >>> act = tracking.begin(np.array([8.0]))
        >>> errors = []
        >>> for step in range(4):  # on the trajectory; the next row is 2 rad ahead
        ...     q = 2.0 * step
        ...     errors.append(float(act(step, np.array([np.cos(q), np.sin(q), 0.0]))[0]))
        >>> np.round(errors, 9).tolist()
        [2.0, 2.0, 2.0, 2.0]
        """
        rows = rows_of(self.primitives, command)
        for name in ("stiffness", "damping", "limit"):
            strength = getattr(self, name)
            if isinstance(strength, tuple) and len(strength) != rows.shape[1]:
                raise ValueError(
                    f"{name} must be one number or one for each of {rows.shape[1]} joints, "
                    f"got {len(strength)}"
                )
        return _Pursuit(self, rows)


class _Pursuit:
    """The pursuit of one trajectory: the policy of an episode."""

    def __init__(self, tracking: Tracking, rows: NDArray[np.float64]) -> None:
        self._tracking = tracking
        # The last row is repeated: the joints are held there, at velocity 0.
        self._rows = np.concatenate([rows, rows[-1:]])
        self._speeds = np.diff(self._rows, axis=0) / tracking.dt
        self._position = rows[0]
        self._stiffness, self._damping = np.array(tracking.stiffness), np.array(tracking.damping)
        self._limit = None if tracking.limit is None else np.array(tracking.limit)

    def __call__(self, step: int, observation: Any) -> NDArray[np.float64]:  # noqa: ANN401 - any
        tracking = self._tracking
        dofs = self._rows.shape[1]
        position = as_point("positions", tracking.positions(observation), dofs)
        velocity = as_point("velocities", tracking.velocities(observation), dofs)
        if tracking.turns:
            turns = np.rint((self._position - position) / math.tau)
            position = self._position = position + math.tau * turns
        row = min(step, len(self._speeds) - 1)
        action: NDArray[np.float64] = self._stiffness * (self._rows[row + 1] - position)
        action += self._damping * (self._speeds[row] - velocity)
        return action if self._limit is None else np.clip(action, -self._limit, self._limit)


def _strength(name: str, value: ArrayLike) -> PerCoordinate:
    """Return a number or several, all at least 0, or say what is wrong with them."""
    found = per_coordinate(name, value)
    if np.min(found) < 0:
        raise ValueError(f"{name} must be at least 0, got {value!r}")
    return found
