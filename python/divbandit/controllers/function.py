"""FunctionController: any function of command, step and observation drives the body."""

from __future__ import annotations

from dataclasses import dataclass
from functools import partial
from typing import TYPE_CHECKING, Any

from divbandit._value import Value
from divbandit.box import Box, BoxLike

if TYPE_CHECKING:
    from collections.abc import Callable

    import numpy as np
    from numpy.typing import ArrayLike, NDArray

    from divbandit.controllers.protocol import Policy


@dataclass(frozen=True, init=False, repr=False)
class FunctionController(Value):
    """A function ``(command, step, observation) -> action`` as a controller.

    Parameters
    ----------
    f : callable
        Takes the motor command, a read-only array of shape (m,), the number of the step, from 0,
        and the observation before it; returns the action.
    motor_space : Box or object with ``low`` and ``high``
        M, the box of all motor commands.

    Raises
    ------
    TypeError, ValueError
        If `f` is not callable, or `motor_space` is not a box.

    Examples
    --------
    A spring and a damper whose strengths are the command.

    >>> import numpy as np
    >>> import divbandit as db
    >>> from divbandit.controllers import FunctionController
    >>> def spring(command, step, observation):
    ...     return -command[0] * observation[:1] - command[1] * observation[1:]
    >>> act = FunctionController(spring, db.Box([0, 0], [1, 1])).begin(np.array([1.0, 0.5]))
    >>> act(0, np.array([0.25, 1.0]))
    array([-0.75])
    """

    f: Callable[[NDArray[np.float64], int, Any], ArrayLike]
    motor_space: Box

    def __init__(
        self,
        f: Callable[[NDArray[np.float64], int, Any], ArrayLike],
        motor_space: BoxLike,
    ) -> None:
        if not callable(f):
            raise TypeError(f"f must be callable, got {type(f).__name__}")
        self._set(f=f, motor_space=Box.of(motor_space, name="motor_space"))

    def begin(self, command: NDArray[np.float64]) -> Policy:
        """Return the policy of an episode: the function with its first argument fixed.

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
        >>> from divbandit.controllers import FunctionController
        >>> shake = FunctionController(lambda x, step, _: x * (-1) ** step, db.Box([0], [1]))
        >>> shake.begin(np.array([0.5]))(1, None)
        array([-0.5])
        """
        return partial(self.f, command)
