"""FunctionEnvironment: any function of a motor command as a black box."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from divbandit._checks import truth
from divbandit._core import as_point
from divbandit._value import Value
from divbandit.box import Box, BoxLike, box_or_none
from divbandit.environments._one_by_one import one_by_one

if TYPE_CHECKING:
    from collections.abc import Callable

    from numpy.typing import ArrayLike, NDArray


@dataclass(frozen=True, init=False, repr=False)
class FunctionEnvironment(Value):
    """A function f: M -> S and the spaces that it connects.

    Parameters
    ----------
    f : callable
        Takes a motor command, a read-only array of shape (m,), and returns the effect, an
        array of shape (s,), or a single number for one of shape (1,).
    motor_space : Box or object with ``low`` and ``high``
        M, the box of all motor commands.
    sensory_space : Box or object with ``low`` and ``high``, optional
        A box in S to draw goals from. Without it, goal babbling needs its own goals;
        `default_strategy` does not need it.
    scalars : bool
        Whether `f` takes the m numbers of a command as m arguments, each a float.
    vectorized : bool
        Whether `f` takes many commands at once, an array of shape (n, m), and returns their
        effects, one of shape (n, s), or (n,) where s is 1. `explore` calls it so with ``batch=``.

    Raises
    ------
    TypeError, ValueError
        If `f` is not callable, or a space is not a box, or `scalars` and `vectorized` are both
        true.

    Examples
    --------
    >>> import divbandit as db
    >>> wave = db.FunctionEnvironment(lambda x: [x[0], x[0] * x[1]], db.Box([-1, -1], [1, 1]))
    >>> wave([0.5, 0.5])
    array([0.5 , 0.25])
    >>> hill = db.FunctionEnvironment(lambda x, y: x * y, db.Box([-1, -1], [1, 1]), scalars=True)
    >>> hill([0.5, 0.5])
    array([0.25])
    >>> norms = db.FunctionEnvironment(
    ...     lambda x: (x**2).sum(axis=1), db.Box([-1, -1], [1, 1]), vectorized=True
    ... )
    >>> run = db.explore(norms, db.MotorBabbling(), 100, rng=0, batch=20)  # calls it 5 times
    """

    f: Callable[..., ArrayLike]
    motor_space: Box
    sensory_space: Box | None
    scalars: bool
    vectorized: bool

    def __init__(
        self,
        f: Callable[..., ArrayLike],
        motor_space: BoxLike,
        sensory_space: BoxLike | None = None,
        *,
        scalars: bool = False,
        vectorized: bool = False,
    ) -> None:
        if not callable(f):
            raise TypeError(f"f must be callable, got {type(f).__name__}")
        self._set(
            f=f,
            motor_space=Box.of(motor_space, name="motor_space"),
            sensory_space=box_or_none("sensory_space", sensory_space),
            scalars=truth("scalars", scalars),
            vectorized=truth("vectorized", vectorized),
        )
        if scalars and vectorized:
            raise ValueError("scalars and vectorized must not both be True")

    def __call__(self, command: ArrayLike) -> NDArray[np.float64]:
        """Return the effect of one command, or the effects of many.

        Parameters
        ----------
        command : array_like, shape (m,) or (n, m)

        Returns
        -------
        numpy.ndarray of float64, shape (s,) or (n, s)

        Raises
        ------
        TypeError, ValueError
            If a command is not a point of the motor space, or `f` does not return a finite point of
            the sensory space.

        Examples
        --------
        >>> import divbandit as db
        >>> double = db.FunctionEnvironment(lambda x: 2 * x, db.Box([0], [1]))
        >>> double([[0.5], [1.0]])
        array([[1.],
               [2.]])
        """
        if self.vectorized:
            return self._at_once(command)
        return one_by_one(self._effect, command, self.motor_space, self.sensory_space)

    def _at_once(self, command: ArrayLike) -> NDArray[np.float64]:
        commands = self.motor_space.bounds.commands(command)
        rows = commands.reshape(-1, self.motor_space.dim)
        effects = self.f(rows)
        if np.shape(effects)[:1] != (len(rows),):
            raise ValueError(
                f"f must return an effect for each of the {len(rows)} commands, "
                f"got an array of shape {np.shape(effects)}"
            )
        if np.ndim(effects) == 1:
            effects = np.reshape(effects, (-1, 1))
        length = None if self.sensory_space is None else self.sensory_space.dim
        checked = [as_point("effect", effect, length) for effect in effects]  # type: ignore[union-attr]
        found = np.array(checked).reshape(len(rows), -1)
        return found[0] if commands.ndim == 1 else found

    def _effect(self, command: NDArray[np.float64]) -> ArrayLike:
        effect = self.f(*command.tolist()) if self.scalars else self.f(command)
        is_number = isinstance(effect, (int, float, np.number)) and not isinstance(effect, bool)
        return np.array([effect]) if is_number else effect
