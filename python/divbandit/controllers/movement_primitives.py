"""MovementPrimitives: a few numbers as a smooth trajectory of joints."""

from __future__ import annotations

from dataclasses import dataclass
from itertools import pairwise
from typing import TYPE_CHECKING

import numpy as np

from divbandit._checks import floats, positive, whole
from divbandit._core import exp, log
from divbandit._value import Value
from divbandit.box import Box

if TYPE_CHECKING:
    from numpy.typing import ArrayLike, NDArray

#: Constants of the transformation system, which is critically damped.
_ALPHA, _BETA = 25.0, 6.25
#: The phase at the end, and the height of a bump at the center of the next one.
_LAST_PHASE, _OVERLAP = 0.01, 0.8
#: The equation of motion is integrated in at least this many steps.
_FINE = 1000


@dataclass(frozen=True, init=False, repr=False)
class MovementPrimitives(Value):
    """Dynamical movement primitives: weights and goals in, a trajectory out.

    A critically damped spring pulls each joint to its goal. On the way a forcing term acts, a
    weighted sum of bumps that fades with time (Ijspeert, Nakanishi, Hoffmann, Pastor and Schaal,
    Neural Computation 25, 2013, section 2.1)::

        y'' = alpha * (beta * (goal - y) - y') + sum_i weight_i psi_i(z) z / sum_i psi_i(z)

    with time from 0 to 1, alpha = 25, beta = alpha / 4 and z(t) = 0.01 ** t. This is linear in
    weights and goal: a trajectory is a sum of responses that are computed once.

    The last bumps are still active at the end. Since all weights displace a joint equally far, a
    trajectory ends at a distance from its goal: of five bumps, the last contributes 0.84 of its
    weight, the one before it 0.58, and the first three 0.17 together.

    Parameters
    ----------
    dofs : int
        Number of joints, from 1 to 10,000.
    basis : int
        Number of weights of each joint, from 2 to 1000.
    steps : int
        A trajectory has ``steps + 1`` rows, evenly spaced in time; from 1 to 100,000.
    weights : float
        Weights lie in [-weights, weights], in the units of the joints: a weight of 1 displaces a
        joint by at most 1.
    goals : float, optional
        Goals lie in [-goals, goals]. With None, joints return to their start instead.
    start : array_like, shape (dofs,), optional
        Where a trajectory starts; 0 by default.
    limit : float, optional
        Positions are clipped to [-limit, limit].

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
    >>> from divbandit.controllers import MovementPrimitives
    >>> primitives = MovementPrimitives(1, basis=3, steps=4)
    >>> primitives.motor_space.dim
    4
    >>> primitives.trajectory([0, 0, 0, 1]).ravel().round(3)      # pulled to the goal
    array([0.   , 0.819, 0.986, 0.999, 1.   ])
    """

    dofs: int
    basis: int
    steps: int
    weights: float
    goals: float | None
    start: tuple[float, ...] | None
    limit: float | None

    if TYPE_CHECKING:
        motor_space: Box
        scales: NDArray[np.float64]
        #: The responses to each bump, and to the goal.
        _bumps: NDArray[np.float64]
        _pull: NDArray[np.float64]

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
        dofs = whole("dofs", dofs, low=1, high=10_000)
        basis = whole("basis", basis, low=2, high=1000)
        steps = whole("steps", steps, low=1, high=100_000)
        weights = positive("weights", weights)
        goals = None if goals is None else positive("goals", goals)
        start = None if start is None else floats("start", start, dofs)
        limit = None if limit is None else positive("limit", limit)
        if start is not None and limit is not None and max(map(abs, start)) > limit:
            raise ValueError(f"start must be within the limit {limit!r}, got {list(start)}")
        highest = np.tile([weights] * basis + ([] if goals is None else [goals]), dofs)
        responses = _responses(basis, steps)
        peaks = np.abs(responses).max(axis=1)
        self._set(
            dofs=dofs,
            basis=basis,
            steps=steps,
            weights=weights,
            goals=goals,
            start=start,
            limit=limit,
            motor_space=Box(-highest, highest),
            scales=1.0 / peaks,
            _bumps=responses / peaks[:, None],
            _pull=_pull(steps),
        )

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
            If a command is not a point of the motor space.

        Examples
        --------
        >>> from divbandit.controllers import MovementPrimitives
        >>> primitives = MovementPrimitives(2, basis=2, steps=10, goals=None)
        >>> primitives.trajectory([[1, 0, 0, 0], [0, 0, 0, 1]]).shape
        (2, 11, 2)
        """
        commands = self.motor_space.bounds.commands(command)
        width = commands.shape[-1] // self.dofs
        parts = commands.reshape(*commands.shape[:-1], 1, self.dofs, width)
        start = np.zeros(self.dofs) if self.start is None else np.array(self.start)
        rows = np.broadcast_to(start, (*commands.shape[:-1], self.steps + 1, self.dofs))
        # One product and one sum at a time, in this order: the order of the sums of a matrix
        # product depends on the CPU.
        for index in range(self.basis):
            rows = rows + self._bumps[index, :, None] * parts[..., index]
        if self.goals is not None:
            rows = rows + self._pull[:, None] * (parts[..., self.basis] - start)
        if self.limit is not None:
            rows = np.clip(rows, -self.limit, self.limit)
        return np.ascontiguousarray(rows)


def _pull(steps: int) -> NDArray[np.float64]:
    """Return the fraction of the way to the goal that the spring alone moves a joint, by row."""
    rate = _ALPHA / 2  # twice, as the damping is critical
    times = [step / steps for step in range(steps + 1)]
    return np.array([1.0 - (1.0 + rate * time) * exp(-rate * time) for time in times])


def _responses(basis: int, steps: int) -> NDArray[np.float64]:
    """Return the response of a joint at rest to each bump alone, shape (basis, steps + 1)."""
    fine = -(-_FINE // steps)
    count = 2 * fine * steps  # Runge-Kutta needs the middle of each step, too
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
    """Return the contribution of each bump to the forcing term, for a weight of 1."""
    decay = log(_LAST_PHASE)
    phase = exp(decay * time)
    centers = [exp(decay * index / (basis - 1)) for index in range(basis)]
    gaps = [after - before for before, after in pairwise(centers)]
    gaps.append(gaps[-1])
    away = [(phase - center) / gap for center, gap in zip(centers, gaps, strict=True)]
    # A product, as the rounding of powers depends on the platform.
    bumps = [exp(log(_OVERLAP) * (distance * distance)) for distance in away]
    total = 0.0
    for bump in bumps:
        total += bump
    return [phase * bump / total for bump in bumps]
