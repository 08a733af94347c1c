"""Tracking: torques that make joints follow a trajectory, as springs and dampers would."""

from __future__ import annotations

import math
from numbers import Real
from typing import TYPE_CHECKING, Any

import numpy as np

from divbandit._checks import real, truth
from divbandit._core import as_point
from divbandit._library import named
from divbandit.controllers._rows import motor_space_of, rows_of

if TYPE_CHECKING:
    from collections.abc import Callable

    from numpy.typing import ArrayLike, NDArray

    from divbandit.box import Box
    from divbandit.controllers.protocol import Policy, Trajectories

    Reading = Callable[[Any], ArrayLike]


class Tracking:
    """A controller that makes joints follow a trajectory (a PD controller).

    In step k it pulls towards row k + 1, where the joints should be when the step has ended, at
    the speed that leads there from row k::

        action = stiffness * (q_ref - q) + damping * (v_ref - v)

    After the last row it holds the joints there.

    Parameters
    ----------
    primitives : object with ``motor_space`` and ``trajectory(command)``
        Such as `MovementPrimitives`; a row is where the joints should be, in radians (or metres).
    positions, velocities : callable
        Read where the joints are, and how fast they move, out of an observation: two arrays of
        shape (dofs,), in radians and radians a second.
    dt : float
        How long a step of the body takes, which is the time from row to row, in seconds.
    stiffness, damping : float or array_like, shape (dofs,)
        What is done about an error of one radian, and of one radian a second, in the units of
        the actions; of all joints or of each. At least 0.
    limit : float or array_like, shape (dofs,), optional
        The largest action, either way. Without one there is none but the body's own.
    turns : bool
        Whether positions are known only up to whole turns, as those are that were found from a
        cosine and a sine. Each is then taken for the one that is nearest to the one before; the
        first, for that nearest to the trajectory's start. So a joint can be led round and round,
        and is not sent the shorter way where a joint limit bars it.

    Attributes
    ----------
    primitives, positions, velocities, dt, turns
        As given.
    stiffness, damping : numpy.ndarray of float64, shape (dofs,) or ()
    limit : numpy.ndarray of float64, shape (dofs,) or (), or None
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
    >>> ramp = SimpleNamespace(
    ...     motor_space=db.Box([-1], [1]),
    ...     trajectory=lambda command: np.linspace([0.0], command, 11),
    ... )
    >>> tracking = db.Tracking(
    ...     ramp, lambda seen: seen[:1], lambda seen: seen[1:], dt=0.5, stiffness=2.0, damping=1.0
    ... )
    >>> act = tracking.begin(np.array([1.0]))
    >>> act(0, np.array([0.0, 0.0])).round(12)  # 2 * 0.1 + 1 * 0.1 / 0.5
    array([0.4])
    """

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
        self.motor_space = motor_space_of(primitives)
        for name, reading in (("positions", positions), ("velocities", velocities)):
            if not callable(reading):
                raise TypeError(f"{name} must be callable, got {type(reading).__name__}")
        self.primitives, self.positions, self.velocities = primitives, positions, velocities
        self.dt = real("dt", dt)
        if self.dt <= 0:
            raise ValueError(f"dt must be above 0, got {dt!r}")
        self.stiffness = _strength("stiffness", stiffness)
        self.damping = _strength("damping", damping)
        self.limit = None if limit is None else _strength("limit", limit)
        self.turns = truth("turns", turns)

    def begin(self, command: NDArray[np.float64]) -> Policy:
        """Return what acts in an episode of this command.

        Parameters
        ----------
        command : numpy.ndarray of float64, shape (m,)

        Returns
        -------
        callable
            ``(step, observation) -> action``, of shape (dofs,); for one episode, from step to
            step.

        Raises
        ------
        ValueError
            If `primitives` returns no trajectory, or one of other joints than there are
            strengths for; and, when it is called, if there are other positions or velocities.

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
        >>> tracking = db.Tracking(
        ...     Turn(), angle, lambda seen: seen[2:], dt=1, stiffness=1, damping=0, turns=True
        ... )
        >>> act = tracking.begin(np.array([8.0]))
        >>> errors = []
        >>> for step in range(4):  # always where it should be; the next row is 2 rad ahead
        ...     q = 2.0 * step
        ...     errors.append(float(act(step, np.array([np.cos(q), np.sin(q), 0.0]))[0]))
        >>> np.round(errors, 9).tolist()
        [2.0, 2.0, 2.0, 2.0]
        """
        rows = rows_of(self.primitives, command)
        for name in ("stiffness", "damping", "limit"):
            strength = getattr(self, name)
            if strength is not None and strength.shape not in {(), rows.shape[1:]}:
                raise ValueError(
                    f"{name} must be one number or one for each of {rows.shape[1]} joints, "
                    f"got {strength.size}"
                )
        return _Pursuit(self, rows)

    def __repr__(self) -> str:
        options = f"dt={self.dt!r}, stiffness={self.stiffness.tolist()!r}"
        options += f", damping={self.damping.tolist()!r}"
        if self.limit is not None:
            options += f", limit={self.limit.tolist()!r}"
        if self.turns:
            options += ", turns=True"
        readings = f"{named(self.positions)}, {named(self.velocities)}"
        return f"Tracking({self.primitives!r}, {readings}, {options})"


class _Pursuit:
    """The pursuit of one trajectory."""

    def __init__(self, tracking: Tracking, rows: NDArray[np.float64]) -> None:
        self._tracking = tracking
        # A last row of its own is where the joints are held: nothing moves from there.
        self._rows = np.concatenate([rows, rows[-1:]])
        self._speeds = np.diff(self._rows, axis=0) / tracking.dt
        self._position = rows[0]

    def __call__(self, step: int, observation: Any) -> NDArray[np.float64]:  # noqa: ANN401 - the body's own
        tracking = self._tracking
        dofs = self._rows.shape[1]
        position = as_point("positions", tracking.positions(observation), dofs)
        velocity = as_point("velocities", tracking.velocities(observation), dofs)
        if tracking.turns:
            turns = np.rint((self._position - position) / math.tau)
            position = self._position = position + math.tau * turns
        row = min(step, len(self._speeds) - 1)
        action: NDArray[np.float64] = tracking.stiffness * (self._rows[row + 1] - position)
        action += tracking.damping * (self._speeds[row] - velocity)
        if tracking.limit is not None:
            action = np.clip(action, -tracking.limit, tracking.limit)
        return action


def _strength(name: str, value: ArrayLike) -> NDArray[np.float64]:
    """Return one number or a list of them, none below 0."""
    if isinstance(value, Real):
        return np.array(real(name, value, low=0))
    strengths = as_point(name, value)
    if (strengths < 0).any():
        raise ValueError(f"{name} must be at least 0, got {strengths.min()} among its numbers")
    return strengths
