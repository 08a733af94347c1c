"""Controller and Trajectories: what turns a motor command into actions or a trajectory."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, Protocol, runtime_checkable

if TYPE_CHECKING:
    from collections.abc import Callable

    import numpy as np
    from numpy.typing import ArrayLike, NDArray

    from divbandit.box import BoxLike

    Policy = Callable[[int, Any], ArrayLike]


@runtime_checkable
class Controller(Protocol):
    """What drives a body step by step, according to a motor command.

    Any object with these two attributes will do; no base class is needed.

    Examples
    --------
    >>> import divbandit as db
    >>> class Push:
    ...     motor_space = db.Box([-1], [1])
    ...     def begin(self, command):
    ...         return lambda step, observation: command
    >>> isinstance(Push(), db.controllers.Controller)
    True
    """

    @property
    def motor_space(self) -> BoxLike:
        """M, the box of all motor commands."""

    def begin(self, command: NDArray[np.float64], /) -> Policy:
        """Return the policy of an episode, for a command of shape (m,).

        The policy takes the number of the step, from 0, and the observation before it, and returns
        the action. It serves a single episode and may have state. The controller must be without
        state, as it may serve several episodes at once.

        Examples
        --------
        >>> import numpy as np
        >>> import divbandit as db
        >>> from divbandit.controllers import FunctionController
        >>> hold = FunctionController(lambda command, step, seen: command, db.Box([-1], [1]))
        >>> hold.begin(np.array([0.5]))(0, None)
        array([0.5])
        """


@runtime_checkable
class Trajectories(Protocol):
    """What turns a motor command into a trajectory, such as `MovementPrimitives`.

    Any object with these two attributes will do; no base class is needed.

    Examples
    --------
    >>> import numpy as np
    >>> import divbandit as db
    >>> class Ramp:
    ...     motor_space = db.Box([-1], [1])
    ...     def trajectory(self, command):
    ...         return np.linspace([0.0], command, 11)
    >>> isinstance(Ramp(), db.controllers.Trajectories)
    True
    """

    @property
    def motor_space(self) -> BoxLike:
        """M, the box of all motor commands."""

    def trajectory(self, command: NDArray[np.float64], /) -> ArrayLike:
        """Return a trajectory, shape (steps + 1, dofs); the first row is its start.

        Examples
        --------
        >>> import divbandit as db
        >>> db.controllers.MovementPrimitives(2, basis=2, steps=50).trajectory([0] * 6).shape
        (51, 2)
        """
