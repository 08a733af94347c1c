"""Controller: what turns a motor command into actions, one after the other."""

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
    """What drives a body step by step, as a motor command says.

    Anything with these two is one; no base class is needed.

    Examples
    --------
    >>> import divbandit as db
    >>> class Push:
    ...     motor_space = db.Box([-1], [1])
    ...     def begin(self, command):
    ...         return lambda step, observation: command
    >>> isinstance(Push(), db.Controller)
    True
    """

    @property
    def motor_space(self) -> BoxLike:
        """M, the box of all motor commands."""

    def begin(self, command: NDArray[np.float64], /) -> Policy:
        """Return what acts in an episode of this command, of shape (m,).

        It is called with the number of the step, from 0, and what was observed before it, and
        returns the action. It serves one episode and may remember; the controller itself may
        serve several episodes at once, and must not.

        Examples
        --------
        >>> import numpy as np
        >>> import divbandit as db
        >>> hold = db.FunctionController(lambda command, step, seen: command, db.Box([-1], [1]))
        >>> hold.begin(np.array([0.5]))(0, None)
        array([0.5])
        """


@runtime_checkable
class Trajectories(Protocol):
    """What turns a motor command into a trajectory, such as `MovementPrimitives`.

    Anything with these two is one; no base class is needed.

    Examples
    --------
    >>> import numpy as np
    >>> import divbandit as db
    >>> class Ramp:
    ...     motor_space = db.Box([-1], [1])
    ...     def trajectory(self, command):
    ...         return np.linspace([0.0], command, 11)
    >>> isinstance(Ramp(), db.Trajectories)
    True
    """

    @property
    def motor_space(self) -> BoxLike:
        """M, the box of all motor commands."""

    def trajectory(self, command: NDArray[np.float64], /) -> ArrayLike:
        """Return where it goes, shape (steps + 1, dofs); the first row is where it starts.

        Examples
        --------
        >>> import divbandit as db
        >>> db.MovementPrimitives(2, basis=2, steps=50).trajectory([0] * 6).shape
        (51, 2)
        """
