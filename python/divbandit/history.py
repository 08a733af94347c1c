"""History: the log of an exploration - commands, effects and who chose them.

The log is the state. Whatever else an exploration needs (the k-d tree here, coverage and
windows in the bandits) is derived from it and can be rebuilt by reading it again.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, Literal, NamedTuple, overload

import numpy as np

from divbandit import _core
from divbandit._checks import whole
from divbandit.box import Box, BoxLike

if TYPE_CHECKING:
    from collections.abc import Sequence

    from numpy.random import Generator
    from numpy.typing import ArrayLike, NDArray


class Failure(NamedTuple):
    """An evaluation that came to nothing: the budget is spent, there is no effect.

    Attributes
    ----------
    command : numpy.ndarray of float64, shape (m,)
    reason : str
        What went wrong.
    path : tuple of int
        Who chose the command: indices of strategies, outermost first.
    place : int
        How many effects were known by then.

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
    """All that has been tried so far, and what it led to.

    Parameters
    ----------
    motor_space : Box or object with ``low`` and ``high``
        M, the box of all motor commands.
    sensory_space : Box or object with ``low`` and ``high``, optional
        A box in S from which goals make sense.

    Attributes
    ----------
    motor_space : Box
    sensory_space : Box or None

    Raises
    ------
    TypeError, ValueError
        If a space is no box.

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
        self._commands = np.empty((0, self.motor_space.dim))
        self._effects = np.empty((0, 0 if self.sensory_space is None else self.sensory_space.dim))
        self._paths: list[tuple[int, ...]] = []
        self._failures: list[Failure] = []
        self._tree: _core.NearestNeighbors | None = None

    def __len__(self) -> int:
        return len(self._paths)

    @property
    def commands(self) -> NDArray[np.float64]:
        """The motor commands in order of observation, shape (n, m); a read-only view."""
        return _read_only(self._commands[: len(self)])

    @property
    def effects(self) -> NDArray[np.float64]:
        """The effects in order of observation, shape (n, s); a read-only view."""
        return _read_only(self._effects[: len(self)])

    @property
    def paths(self) -> Sequence[tuple[int, ...]]:
        """Who chose each command: indices of strategies, outermost first."""
        return tuple(self._paths)

    @property
    def failures(self) -> tuple[Failure, ...]:
        """The evaluations that came to nothing, in order; they are in no other place here."""
        return tuple(self._failures)

    @property
    def effect_dim(self) -> int | None:
        """The dimension of the effects; None until there is a way to know it."""
        if self.sensory_space is not None:
            return self.sensory_space.dim
        return self._effects.shape[1] if self._paths else None

    def append(self, command: ArrayLike, effect: ArrayLike, *, path: tuple[int, ...] = ()) -> None:
        """Record one evaluation.

        Parameters
        ----------
        command : array_like, shape (m,)
        effect : array_like, shape (s,)
        path : tuple of int
            Who chose the command: indices of strategies, outermost first.

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
        if not isinstance(path, tuple):
            raise TypeError(f"path must be a tuple of indices, got {type(path).__name__}")
        self.record(
            self.motor_space.bounds.command(command),
            _core.as_point("effect", effect, self.effect_dim),
            tuple(whole(f"path[{i}]", index, low=0) for i, index in enumerate(path)),
        )

    def record(
        self, command: NDArray[np.float64], effect: NDArray[np.float64], path: tuple[int, ...]
    ) -> None:
        """Do what `append` does with arrays that are known to be right.

        Examples
        --------
        >>> import numpy as np
        >>> import divbandit as db
        >>> history = db.History(db.Box([0], [1]))
        >>> history.record(np.array([0.5]), np.array([7.0]), ())
        >>> len(history)
        1
        """
        n = len(self._paths)
        if n == len(self._commands):
            self._commands = _enlarged(self._commands, len(command))
            self._effects = _enlarged(self._effects, len(effect))
        self._commands[n] = command
        self._effects[n] = effect
        self._paths.append(path)

    def record_many(
        self,
        commands: NDArray[np.float64],
        effects: NDArray[np.float64],
        paths: Sequence[tuple[int, ...]],
    ) -> None:
        """Do what as many calls of `record` do.

        Examples
        --------
        >>> import numpy as np
        >>> import divbandit as db
        >>> history = db.History(db.Box([0], [1]))
        >>> history.record_many(np.array([[0.5], [0.25]]), np.array([[7.0], [8.0]]), [(), ()])
        >>> len(history)
        2
        """
        n, end = len(self._paths), len(self._paths) + len(paths)
        while end > len(self._commands):
            self._commands = _enlarged(self._commands, commands.shape[1])
            self._effects = _enlarged(self._effects, effects.shape[1])
        self._commands[n:end] = commands
        self._effects[n:end] = effects
        self._paths.extend(paths)

    def record_failure(
        self, command: NDArray[np.float64], reason: str, path: tuple[int, ...]
    ) -> None:
        """Record an evaluation that came to nothing.

        Examples
        --------
        >>> import numpy as np
        >>> import divbandit as db
        >>> history = db.History(db.Box([0], [1]))
        >>> history.record_failure(np.array([0.5]), "power cut", ())
        >>> history.failures
        (Failure(command=array([0.5]), reason='power cut', path=(), place=0),)
        """
        self._failures.append(Failure(command, reason, path, len(self._paths)))

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
        tree = self.tree
        return tree.nearest(_core.as_point("goal", goal, tree.dim), k=k)

    def inverse(self, goal: ArrayLike, rng: Generator, *, d: float = 0.05) -> NDArray[np.float64]:
        """Inverse_d(goal): the command of the nearest effect, perturbed.

        Each coordinate is uniform within the share `d` of its motor range around that command,
        inside the motor space (Inverse_d and Perturb_d of Benureau and Oudeyer 2015).

        Parameters
        ----------
        goal : array_like, shape (s,)
        rng : numpy.random.Generator
            Advances by one ``rng.random()`` a coordinate.
        d : float
            Share of the motor range, in [0, 1].

        Returns
        -------
        numpy.ndarray of float64, shape (m,)
            Read-only.

        Raises
        ------
        TypeError, ValueError
            If nothing was observed yet, `goal` is no finite point of the sensory space, or `d`
            is not in [0, 1]; `rng` is then as it was.

        Examples
        --------
        >>> import numpy as np
        >>> import divbandit as db
        >>> history = db.History(db.Box([0], [1]))
        >>> history.append([0.25], [7.0])
        >>> history.inverse([8.0], np.random.default_rng(0), d=0.1)
        array([0.27739234])
        """
        return _core.inverse(goal, d, self.tree, self._commands, self.motor_space.bounds, rng)

    @property
    def tree(self) -> _core.NearestNeighbors:
        """All effects in a k-d tree, brought up to date: to be searched, not to be added to.

        A ValueError if nothing was observed yet.
        """
        tree = self._tree
        if tree is None:
            if not self._paths:
                raise ValueError("history must not be empty: nothing was observed yet")
            tree = self._tree = _core.NearestNeighbors(self._effects.shape[1])
        known = len(tree)
        missing = len(self._paths) - known
        if missing == 1:
            tree.add(self._effects[known])
        elif missing > 1:
            tree.extend(self._effects[known : known + missing])
        return tree

    def __getstate__(self) -> dict[str, Any]:
        """Leave out the k-d tree: it is made anew from the log."""
        return {**self.__dict__, "_tree": None}

    def __repr__(self) -> str:
        return f"<History of {len(self)} evaluations, {self.motor_space.dim} -> {self.effect_dim}>"


def _enlarged(rows: NDArray[np.float64], width: int) -> NDArray[np.float64]:
    """Return a copy of `rows` with room for twice as many."""
    larger = np.empty((max(64, 2 * len(rows)), width))
    if len(rows):
        larger[: len(rows)] = rows
    return larger


def _read_only(view: NDArray[np.float64]) -> NDArray[np.float64]:
    view.flags.writeable = False
    return view
