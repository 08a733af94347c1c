"""OpenLoop: the rows of a trajectory are the actions, whatever is observed."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from divbandit.controllers._rows import motor_space_of, rows_of

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

    from divbandit.box import Box
    from divbandit.controllers.protocol import Policy, Trajectories


class OpenLoop:
    """A controller that plays a trajectory back: the action of step k is its row k.

    After the last row it repeats the last row.

    Parameters
    ----------
    primitives : object with ``motor_space`` and ``trajectory(command)``
        Such as `MovementPrimitives`; its rows are in the units of the actions.

    Attributes
    ----------
    primitives
        As given.
    motor_space : Box
        That of `primitives`.

    Raises
    ------
    TypeError, ValueError
        If `primitives` makes no trajectories, or its motor space is no box.

    Examples
    --------
    >>> from types import SimpleNamespace
    >>> import numpy as np
    >>> import divbandit as db
    >>> ramp = SimpleNamespace(
    ...     motor_space=db.Box([-1], [1]),
    ...     trajectory=lambda command: np.linspace([0.0], command, 3),
    ... )
    >>> act = db.OpenLoop(ramp).begin(np.array([1.0]))
    >>> [float(act(step, None)[0]) for step in range(4)]
    [0.0, 0.5, 1.0, 1.0]
    """

    motor_space: Box

    def __init__(self, primitives: Trajectories) -> None:
        self.motor_space = motor_space_of(primitives)
        self.primitives = primitives

    def begin(self, command: NDArray[np.float64]) -> Policy:
        """Return what acts in an episode of this command.

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
            If `primitives` returns no trajectory.

        Examples
        --------
        >>> import numpy as np
        >>> import divbandit as db
        >>> class Stay:
        ...     motor_space = db.Box([-1, -1], [1, 1])
        ...     def trajectory(self, command):
        ...         return [command]
        >>> db.OpenLoop(Stay()).begin(np.array([0.5, 0.0]))(7, None)
        array([0.5, 0. ])
        """
        rows = rows_of(self.primitives, command)
        last = len(rows) - 1

        def act(step: int, observation: Any) -> NDArray[np.float64]:  # noqa: ANN401, ARG001 - blind
            row: NDArray[np.float64] = rows[min(step, last)]
            return row

        return act

    def __repr__(self) -> str:
        return f"OpenLoop({self.primitives!r})"
