"""OpenLoop: the rows of a trajectory are the actions; observations are ignored."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

from divbandit._value import Value
from divbandit.controllers._rows import motor_space_of, rows_of

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

    from divbandit.box import Box
    from divbandit.controllers.protocol import Policy, Trajectories


@dataclass(frozen=True, init=False, repr=False)
class OpenLoop(Value):
    """A controller that plays a trajectory back: the action of step k is its row k.

    After the last row it repeats the last row.

    Parameters
    ----------
    primitives : object with ``motor_space`` and ``trajectory(command)``
        Such as `MovementPrimitives`; its rows are in the units of the actions.

    Attributes
    ----------
    motor_space : Box
        That of `primitives`.

    Raises
    ------
    TypeError, ValueError
        If `primitives` does not make trajectories, or its motor space is not a box.

    Examples
    --------
    >>> from types import SimpleNamespace
    >>> import numpy as np
    >>> import divbandit as db
    >>> from divbandit.controllers import OpenLoop
    >>> ramp = SimpleNamespace(
    ...     motor_space=db.Box([-1], [1]),
    ...     trajectory=lambda command: np.linspace([0.0], command, 3),
    ... )
    >>> act = OpenLoop(ramp).begin(np.array([1.0]))
    >>> [float(act(step, None)[0]) for step in range(4)]
    [0.0, 0.5, 1.0, 1.0]
    """

    primitives: Trajectories

    if TYPE_CHECKING:
        motor_space: Box

    def __init__(self, primitives: Trajectories) -> None:
        self._set(primitives=primitives, motor_space=motor_space_of(primitives))

    def begin(self, command: NDArray[np.float64]) -> Policy:
        """Return the policy of an episode.

        Parameters
        ----------
        command : numpy.ndarray of float64, shape (m,)

        Returns
        -------
        callable
            ``(step, observation) -> action``, of shape (dofs,).

        Raises
        ------
        ValueError
            If `primitives` does not return a trajectory.

        Examples
        --------
        >>> import numpy as np
        >>> import divbandit as db
        >>> class Stay:
        ...     motor_space = db.Box([-1, -1], [1, 1])
        ...     def trajectory(self, command):
        ...         return [command]
        >>> db.controllers.OpenLoop(Stay()).begin(np.array([0.5, 0.0]))(7, None)
        array([0.5, 0. ])
        """
        rows = rows_of(self.primitives, command)
        last = len(rows) - 1

        def act(step: int, observation: Any) -> NDArray[np.float64]:  # noqa: ANN401, ARG001 - ignored
            row: NDArray[np.float64] = rows[min(step, last)]
            return row

        return act
