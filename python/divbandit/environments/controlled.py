"""Controlled: a body that follows the trajectories of a controller."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Protocol, runtime_checkable

import numpy as np

from divbandit._value import Value
from divbandit.box import Box, BoxLike, box_or_none
from divbandit.controllers import Trajectories
from divbandit.environments._one_by_one import one_by_one

if TYPE_CHECKING:
    from numpy.typing import ArrayLike, NDArray


@runtime_checkable
class Body(Protocol):
    """What can follow a trajectory, such as `PlanarArm` and `PushArm`.

    Examples
    --------
    >>> import divbandit as db
    >>> from divbandit.environments.controlled import Body
    >>> isinstance(db.PlanarArm(3), Body)
    True
    """

    @property
    def sensory_space(self) -> BoxLike | None:
        """A box in S to draw goals from; None if unknown."""

    def follow(self, trajectory: NDArray[np.float64], /) -> ArrayLike:
        """Return the effect, shape (s,), of following a trajectory of shape (steps, dofs)."""


@dataclass(frozen=True, init=False, repr=False)
class Controlled(Value):
    """A body driven by a controller: f(command) = body.follow(controller.trajectory(command)).

    Parameters
    ----------
    body : object with ``follow`` and ``sensory_space``
        Such as a `PlanarArm` or a `PushArm`.
    controller : object with ``trajectory`` and ``motor_space``
        Such as `MovementPrimitives`.

    Attributes
    ----------
    motor_space : Box
        That of the controller.
    sensory_space : Box or None
        That of the body.

    Raises
    ------
    TypeError, ValueError
        If an argument is not what it must be.

    Examples
    --------
    >>> import divbandit as db
    >>> from divbandit.controllers import MovementPrimitives
    >>> arm = db.PlanarArm(5)
    >>> moved = db.environments.Controlled(arm, MovementPrimitives(5, limit=arm.limit))
    >>> moved.motor_space.dim
    30
    >>> run = db.explore(moved, db.GoalBabbling(0.05), n=50, rng=0)
    """

    body: Body
    controller: Trajectories

    if TYPE_CHECKING:
        motor_space: Box
        sensory_space: Box | None

    def __init__(self, body: Body, controller: Trajectories) -> None:
        if not isinstance(body, Body):
            raise TypeError(
                f"body must have follow(trajectory) and sensory_space, got {type(body).__name__}"
            )
        if not isinstance(controller, Trajectories):
            raise TypeError(
                "controller must have trajectory(command) and motor_space, "
                f"got {type(controller).__name__}"
            )
        self._set(
            body=body,
            controller=controller,
            motor_space=Box.of(controller.motor_space, name="controller.motor_space"),
            sensory_space=box_or_none("body.sensory_space", body.sensory_space),
        )

    def __call__(self, command: ArrayLike) -> NDArray[np.float64]:
        """Return the effect of one command, or the effects of many, one by one.

        Parameters
        ----------
        command : array_like, shape (m,) or (n, m)

        Returns
        -------
        numpy.ndarray of float64, shape (s,) or (n, s)

        Raises
        ------
        TypeError, ValueError
            If a command is not a point of the motor space, the body cannot follow the trajectory,
            or what it returns is not a finite point of the sensory space.

        Examples
        --------
        >>> import divbandit as db
        >>> primitives = db.controllers.MovementPrimitives(2, goals=None)
        >>> moved = db.environments.Controlled(db.PlanarArm(2), primitives)
        >>> moved(moved.motor_space.low * 0).round(6)
        array([1., 0.])
        """
        return one_by_one(self._effect, command, self.motor_space, self.sensory_space)

    def _effect(self, command: NDArray[np.float64]) -> ArrayLike:
        trajectory = np.asarray(self.controller.trajectory(command), dtype=np.float64)
        return self.body.follow(trajectory)
