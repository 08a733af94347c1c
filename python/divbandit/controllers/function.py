"""FunctionController: any function of command, step and observation drives the body."""

from __future__ import annotations

from functools import partial
from typing import TYPE_CHECKING, Any

from divbandit._library import named
from divbandit.box import Box, BoxLike

if TYPE_CHECKING:
    from collections.abc import Callable

    import numpy as np
    from numpy.typing import ArrayLike, NDArray

    from divbandit.controllers.protocol import Policy


class FunctionController:
    """A function ``(command, step, observation) -> action`` as a controller.

    Parameters
    ----------
    f : callable
        Takes the motor command, a read-only array of shape (m,), the number of the step, from 0,
        and what was observed before it; returns the action.
    motor_space : Box or object with ``low`` and ``high``
        M, the box of all motor commands.

    Attributes
    ----------
    f
        As given.
    motor_space : Box

    Raises
    ------
    TypeError, ValueError
        If `f` cannot be called, or `motor_space` is no box.

    Examples
    --------
    A spring and a damper, whose strengths are the command.

    >>> import numpy as np
    >>> import divbandit as db
    >>> def spring(command, step, observation):
    ...     return -command[0] * observation[:1] - command[1] * observation[1:]
    >>> act = db.FunctionController(spring, db.Box([0, 0], [1, 1])).begin(np.array([1.0, 0.5]))
    >>> act(0, np.array([0.25, 1.0]))
    array([-0.75])
    """

    motor_space: Box

    def __init__(
        self,
        f: Callable[[NDArray[np.float64], int, Any], ArrayLike],
        motor_space: BoxLike,
    ) -> None:
        if not callable(f):
            raise TypeError(f"f must be callable, got {type(f).__name__}")
        self.f = f
        self.motor_space = Box.of(motor_space, name="motor_space")

    def begin(self, command: NDArray[np.float64]) -> Policy:
        """Return what acts in an episode of this command: the function, given the command.

        Parameters
        ----------
        command : numpy.ndarray of float64, shape (m,)

        Returns
        -------
        callable
            ``(step, observation) -> action``

        Examples
        --------
        >>> import numpy as np
        >>> import divbandit as db
        >>> shake = db.FunctionController(lambda x, step, _: x * (-1) ** step, db.Box([0], [1]))
        >>> shake.begin(np.array([0.5]))(1, None)
        array([-0.5])
        """
        return partial(self.f, command)

    def __repr__(self) -> str:
        return f"FunctionController({named(self.f)}, {self.motor_space!r})"
