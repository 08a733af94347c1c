"""MovementPrimitives: a few numbers as a smooth trajectory of joints."""

from __future__ import annotations

from itertools import pairwise
from typing import TYPE_CHECKING

import numpy as np

from divbandit._checks import positive, whole
from divbandit._core import as_point, exp, log
from divbandit.box import Box

if TYPE_CHECKING:
    from numpy.typing import ArrayLike, NDArray

#: The spring of the transformation system, with the damper that makes it critically damped.
_ALPHA, _BETA = 25.0, 6.25
#: How far the phase has decayed in the end, and what a bump leaves at the next one's centre.
_LAST_PHASE, _OVERLAP = 0.01, 0.8
#: The equation of motion is integrated in at least so many steps.
_FINE = 1000


class MovementPrimitives:
    """Dynamical movement primitives: weights and goals in, a trajectory out.

    Each joint is drawn to its goal by a critically damped spring, and on its way is moved by a
    forcing term, a weighted sum of bumps that fades with time (Ijspeert, Nakanishi, Hoffmann,
    Pastor and Schaal, Neural Computation 25, 2013, section 2.1)::

        y'' = alpha * (beta * (goal - y) - y') + sum_i weight_i psi_i(z) z / sum_i psi_i(z)

    with time from 0 to 1, alpha = 25, beta = alpha / 4 and z(t) = 0.01 ** t. This is linear in
    weights and goal: a trajectory is a sum of responses that are worked out once.

    The last bumps still act in the end, and as each weight moves a joint equally far, a trajectory
    ends beside its goal by what they leave: of five bumps the last leaves 0.84 of its weight, the
    one before 0.58, the first three 0.17 together.

    Parameters
    ----------
    dofs : int
        How many joints, from 1 to 10,000.
    basis : int
        How many weights each has, from 2 to 1000.
    steps : int
        A trajectory has ``steps + 1`` rows, evenly spaced in time; from 1 to 100,000.
    weights : float
        Weights lie in [-weights, weights], in the units of the joints: a weight of 1 moves a joint
        by 1 at most, when its bump has acted.
    goals : float, optional
        Goals lie in [-goals, goals]; None for none: joints come back to where they started.
    start : array_like, shape (dofs,), optional
        Where a trajectory starts; by default at 0.
    limit : float, optional
        Positions beyond [-limit, limit] are brought back to it.

    Attributes
    ----------
    motor_space : Box
        For each joint in turn its weights and, last, its goal: ``dofs * (basis + 1)`` dimensions,
        or ``dofs * basis`` without goals.
    scales : numpy.ndarray of float64, shape (basis,)
        The weights of the equation are those of a command times these.

    Raises
    ------
    TypeError, ValueError
        If an argument is not what it must be.

    Examples
    --------
    >>> import divbandit as db
    >>> primitives = db.MovementPrimitives(1, basis=3, steps=4)
    >>> primitives.motor_space.dim
    4
    >>> primitives.trajectory([0, 0, 0, 1]).ravel().round(3)      # drawn to its goal
    array([0.   , 0.819, 0.986, 0.999, 1.   ])
    """

    motor_space: Box

    def __init__(
        self,
        dofs: int,
        *,
        basis: int = 5,
        steps: int = 50,
        weights: float = 1.0,
        goals: float | None = 1.0,
        start: ArrayLike | None = None,
        limit: float | None = None,
    ) -> None:
        self.dofs = whole("dofs", dofs, low=1, high=10_000)
        self.basis = whole("basis", basis, low=2, high=1000)
        self.steps = whole("steps", steps, low=1, high=100_000)
        self.weights = positive("weights", weights)
        self.goals = None if goals is None else positive("goals", goals)
        self.start = as_point("start", np.zeros(self.dofs) if start is None else start, self.dofs)
        self.limit = None if limit is None else positive("limit", limit)
        if self.limit is not None and (np.abs(self.start) > self.limit).any():
            raise ValueError(f"start must be within the limit {limit!r}, got {self.start.tolist()}")
        of_one = [self.weights] * self.basis + ([] if self.goals is None else [self.goals])
        highest = np.tile(of_one, self.dofs)
        self.motor_space = Box(-highest, highest)
        self._width = len(of_one)
        raw = _responses(self.basis, self.steps)
        peaks = np.abs(raw).max(axis=1)
        self.scales = 1.0 / peaks
        self._bumps = raw / peaks[:, None]
        self._pull = _pull(self.steps)

    def trajectory(self, command: ArrayLike) -> NDArray[np.float64]:
        """Return the trajectory of one command, or those of many.

        Parameters
        ----------
        command : array_like, shape (m,) or (n, m)

        Returns
        -------
        numpy.ndarray of float64, shape (steps + 1, dofs) or (n, steps + 1, dofs)
            The first row is the start.

        Raises
        ------
        TypeError, ValueError
            If a command is no point of the motor space.

        Examples
        --------
        >>> import divbandit as db
        >>> primitives = db.MovementPrimitives(2, basis=2, steps=10, goals=None)
        >>> primitives.trajectory([[1, 0, 0, 0], [0, 0, 0, 1]]).shape
        (2, 11, 2)
        """
        commands = self.motor_space.bounds.commands(command)
        parts = commands.reshape(*commands.shape[:-1], 1, self.dofs, self._width)
        rows = np.broadcast_to(self.start, (*commands.shape[:-1], self.steps + 1, self.dofs))
        # One product and one sum at a time, in this order: a matrix product would be worked out in
        # another order by another CPU.
        for index in range(self.basis):
            rows = rows + self._bumps[index, :, None] * parts[..., index]
        if self.goals is not None:
            rows = rows + self._pull[:, None] * (parts[..., self.basis] - self.start)
        if self.limit is not None:
            rows = np.clip(rows, -self.limit, self.limit)
        return np.ascontiguousarray(rows)

    def __repr__(self) -> str:
        return (
            f"MovementPrimitives({self.dofs}, basis={self.basis}, steps={self.steps}, "
            f"weights={self.weights!r}, goals={self.goals!r}, start={self.start.tolist()!r}, "
            f"limit={self.limit!r})"
        )


def _pull(steps: int) -> NDArray[np.float64]:
    """Return how far the spring alone has drawn a joint to its goal, row by row."""
    rate = _ALPHA / 2  # twice, as the damping is critical
    times = [step / steps for step in range(steps + 1)]
    return np.array([1.0 - (1.0 + rate * time) * exp(-rate * time) for time in times])


def _responses(basis: int, steps: int) -> NDArray[np.float64]:
    """Return how a joint at rest answers to each bump alone, shape (basis, steps + 1)."""
    fine = -(-_FINE // steps)
    count = 2 * fine * steps  # Runge and Kutta look at the middle of each step, too
    forces = np.array([_forces(basis, place / count) for place in range(count + 1)])
    dt = 2.0 / count
    place, speed = np.zeros(basis), np.zeros(basis)
    rows = [place]
    for step in range(fine * steps):
        before, between, after = forces[2 * step], forces[2 * step + 1], forces[2 * step + 2]
        a = _acceleration(place, speed, before)
        b = _acceleration(place + dt / 2 * speed, speed + dt / 2 * a, between)
        c = _acceleration(place + dt / 2 * (speed + dt / 2 * a), speed + dt / 2 * b, between)
        d = _acceleration(place + dt * (speed + dt / 2 * b), speed + dt * c, after)
        place = place + dt * (speed + dt / 6 * (a + b + c))
        speed = speed + dt / 6 * (a + 2 * b + 2 * c + d)
        if (step + 1) % fine == 0:
            rows.append(place)
    return np.array(rows).T


def _acceleration(
    place: NDArray[np.float64], speed: NDArray[np.float64], force: NDArray[np.float64]
) -> NDArray[np.float64]:
    return _ALPHA * (-_BETA * place - speed) + force


def _forces(basis: int, time: float) -> list[float]:
    """Return each bump's share of the forcing term at a time, for a weight of 1."""
    decay = log(_LAST_PHASE)
    phase = exp(decay * time)
    centers = [exp(decay * index / (basis - 1)) for index in range(basis)]
    gaps = [after - before for before, after in pairwise(centers)]
    gaps.append(gaps[-1])
    away = [(phase - center) / gap for center, gap in zip(centers, gaps, strict=True)]
    # A product: the platform's power is not rounded alike everywhere.
    bumps = [exp(log(_OVERLAP) * (distance * distance)) for distance in away]
    total = 0.0
    for bump in bumps:
        total += bump
    return [phase * bump / total for bump in bumps]
