"""History: the log of an exploration - commands, effects and who proposed them.

The log is the state. Whatever else an exploration needs (the k-d tree here, coverage and
estimates in the bandits) follows from it.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, Literal, NamedTuple, overload

import numpy as np

from divbandit import _core
from divbandit._checks import whole
from divbandit.box import Box, BoxLike

if TYPE_CHECKING:
    from collections.abc import Sequence

    from numpy.typing import ArrayLike, NDArray

    from divbandit.exploration import Exploration
    from divbandit.measures import Measure


class Failure(NamedTuple):
    """A failed evaluation: the budget is spent, and there is no effect.

    Attributes
    ----------
    command : numpy.ndarray of float64, shape (m,)
    reason : str
        What went wrong.
    path : tuple of int
        Who proposed the command: indices of strategies, outermost first.
    place : int
        How many effects had been observed by then.

    Examples
    --------
    >>> import divbandit as db
    >>> explorer = db.Explorer(db.MotorBabbling(), db.Box([0], [1]), rng=0)
    >>> explorer.fail(explorer.ask(), "the robot fell over")
    >>> explorer.history.failures[0].reason
    'the robot fell over'
    """

    command: NDArray[np.float64]
    reason: str
    path: tuple[int, ...]
    place: int


class History:
    """All commands tried so far, and their effects.

    Parameters
    ----------
    motor_space : Box or object with ``low`` and ``high``
        M, the box of all motor commands.
    sensory_space : Box or object with ``low`` and ``high``, optional
        A box in S to draw goals from.

    Attributes
    ----------
    motor_space : Box
    sensory_space : Box or None

    Raises
    ------
    TypeError, ValueError
        If a space is not a box.

    Examples
    --------
    >>> import divbandit as db
    >>> history = db.History(db.Box([0], [1]), db.Box([0, 0], [1, 1]))
    >>> history.append([0.5], [0.1, 0.2])
    >>> len(history), history.effects
    (1, array([[0.1, 0.2]]))
    """

    def __init__(self, motor_space: BoxLike, sensory_space: BoxLike | None = None) -> None:
        self.motor_space = Box.of(motor_space, name="motor_space")
        self.sensory_space = (
            None if sensory_space is None else Box.of(sensory_space, name="sensory_space")
        )
        #: That of the explorer whose history this is.
        self._journal: _core.Journal | None = None
        #: The names of its strategies, and what they were rewarded by.
        self._explored_by: tuple[tuple[str, ...], Measure | None] = ((), None)
        goals = self.sensory_space
        self._log = _core.History(self.motor_space.bounds, None if goals is None else goals.bounds)
        # Copies of the log in NumPy's memory, as far as it has been read.
        self._commands = np.empty((0, self.motor_space.dim))
        self._effects = np.empty((0, 0 if goals is None else goals.dim))
        self._looked_at = [0, 0]
        self._paths: list[tuple[int, ...]] = []

    def __len__(self) -> int:
        return len(self._log)

    @property
    def commands(self) -> NDArray[np.float64]:
        """The motor commands in order of observation, shape (n, m); a read-only view."""
        if not self._log.keeps_commands:
            raise AttributeError("commands were not kept: explore(..., keep_commands=True) does")
        self._commands = _extended(
            self._commands, self._log.commands_from(self._looked_at[0]), len(self)
        )
        self._looked_at[0] = len(self)
        return _read_only(self._commands[: len(self)])

    @property
    def effects(self) -> NDArray[np.float64]:
        """The effects in order of observation, shape (n, s); a read-only view."""
        self._effects = _extended(
            self._effects, self._log.effects_from(self._looked_at[1]), len(self)
        )
        self._looked_at[1] = len(self)
        return _read_only(self._effects[: len(self)])

    @property
    def paths(self) -> Sequence[tuple[int, ...]]:
        """Who proposed each command: indices of strategies, outermost first."""
        self._paths += self._log.paths_from(len(self._paths))
        return tuple(self._paths)

    @property
    def failures(self) -> tuple[Failure, ...]:
        """The failed evaluations, in order; `commands` and `effects` do not include them."""
        if self._journal is None:
            return ()
        return tuple(Failure(*failed[1:]) for failed in self._journal.failures(0))

    @property
    def effect_dim(self) -> int | None:
        """The dimension of the effects; None until there is one."""
        return self._log.effect_dim

    def append(self, command: ArrayLike, effect: ArrayLike, *, path: tuple[int, ...] = ()) -> None:
        """Record one evaluation; an explorer's history takes none (see `Explorer.add_past`).

        Parameters
        ----------
        command : array_like, shape (m,)
        effect : array_like, shape (s,)
        path : tuple of int
            Who proposed the command: indices of strategies, outermost first.

        Raises
        ------
        TypeError, ValueError
            If `command` is no point of the motor space, or `effect` is not finite or of another
            dimension than those before; nothing is recorded then.

        Examples
        --------
        >>> import divbandit as db
        >>> history = db.History(db.Box([0], [1]))
        >>> history.append([0.5], [7.0])
        >>> history.append([0.5], [7.0, 8.0])
        Traceback (most recent call last):
            ...
        ValueError: effect must have shape (1,), got (2,)
        """
        if self._journal is not None:
            raise ValueError(
                "history must be written by its explorer: "
                "use explorer.tell, or explorer.add_past for earlier evaluations"
            )
        if not isinstance(path, tuple):
            raise TypeError(f"path must be a tuple of indices, got {type(path).__name__}")
        for i, index in enumerate(path):
            whole(f"path[{i}]", index, low=0, high=2**32 - 1)
        self._log.record(command, effect, path, None)

    @overload
    def nearest(self, goal: ArrayLike) -> tuple[float, int]: ...
    @overload
    def nearest(self, goal: ArrayLike, *, k: Literal[1]) -> tuple[float, int]: ...
    @overload
    def nearest(self, goal: ArrayLike, *, k: int) -> tuple[Any, Any]: ...
    def nearest(self, goal: ArrayLike, *, k: int = 1) -> tuple[Any, Any]:
        """Find the observed effects nearest to `goal`.

        Parameters
        ----------
        goal : array_like, shape (s,)
        k : int
            How many effects to find.

        Returns
        -------
        distance, index : float, int
            If `k` is 1; of several at the same distance, the earliest.
        distances, indices : arrays of shape (k,)
            If `k` is more, nearest first.

        Raises
        ------
        TypeError, ValueError
            If nothing was observed yet, `goal` is no finite point of the sensory space, or
            fewer than `k` effects were observed.

        Examples
        --------
        >>> import divbandit as db
        >>> history = db.History(db.Box([0], [1]))
        >>> history.append([0.25], [7.0])
        >>> history.append([0.75], [9.0])
        >>> history.nearest([8.5])
        (0.5, 1)
        """
        return self._log.nearest(goal, k)

    def __repr__(self) -> str:
        return f"<History of {counted(self)}, {self.motor_space.dim} -> {self.effect_dim}>"


def counted(log: History | Exploration) -> str:
    """Return how many evaluations there are, and how many of them failed.

    Examples
    --------
    >>> import divbandit as db
    >>> explorer = db.Explorer(db.MotorBabbling(), db.Box([0], [1]), rng=0)
    >>> explorer.fail(explorer.ask(), "the robot fell over")
    >>> counted(explorer.history)
    '1 evaluation, 1 of them failed'
    """
    failed = len(log.failures)
    n = len(log) + failed
    text = f"{n} evaluation{'' if n == 1 else 's'}"
    return f"{text}, {failed} of them failed" if failed else text


def _extended(rows: NDArray[np.float64], new: NDArray[np.float64], n: int) -> NDArray[np.float64]:
    """Return rows whose last of `n` are the new ones, with room for more."""
    if len(new) == 0:
        return rows
    if n > len(rows):
        larger = np.empty((max(64, 2 * n), new.shape[1]))
        if len(rows):
            larger[: n - len(new)] = rows[: n - len(new)]
        rows = larger
    rows[n - len(new) : n] = new
    return rows


def _read_only(view: NDArray[np.float64]) -> NDArray[np.float64]:
    view.flags.writeable = False
    return view
