"""FunctionEnvironment: any function of a motor command as a black box."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from divbandit._checks import truth
from divbandit.box import Box, BoxLike
from divbandit.environments._one_by_one import one_by_one

if TYPE_CHECKING:
    from collections.abc import Callable

    from numpy.typing import ArrayLike, NDArray


class FunctionEnvironment:
    """A function f: M -> S and the spaces that it connects.

    Parameters
    ----------
    f : callable
        Takes a motor command, a read-only array of shape (m,), and returns the effect, an
        array of shape (s,), or a single number for one of shape (1,).
    motor_space : Box or object with ``low`` and ``high``
        M, the box of all motor commands.
    sensory_space : Box or object with ``low`` and ``high``, optional
        A box in S from which goals make sense. Without one, goal babbling must be given goals.
    scalars : bool
        Whether `f` takes the m numbers of a command as so many arguments, each a float.

    Raises
    ------
    TypeError, ValueError
        If `f` cannot be called, or a space is no box.

    Examples
    --------
    >>> import divbandit as db
    >>> wave = db.FunctionEnvironment(lambda x: [x[0], x[0] * x[1]], db.Box([-1, -1], [1, 1]))
    >>> wave([0.5, 0.5])
    array([0.5 , 0.25])
    >>> hill = db.FunctionEnvironment(lambda x, y: x * y, db.Box([-1, -1], [1, 1]), scalars=True)
    >>> hill([0.5, 0.5])
    array([0.25])
    """

    motor_space: Box
    sensory_space: Box | None

    def __init__(
        self,
        f: Callable[..., ArrayLike],
        motor_space: BoxLike,
        sensory_space: BoxLike | None = None,
        *,
        scalars: bool = False,
    ) -> None:
        if not callable(f):
            raise TypeError(f"f must be callable, got {type(f).__name__}")
        self._f = f
        self._scalars = truth("scalars", scalars)
        self.motor_space = Box.of(motor_space, name="motor_space")
        self.sensory_space = (
            None if sensory_space is None else Box.of(sensory_space, name="sensory_space")
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
            If a command is no point of the motor space, or `f` returns no finite point of the
            sensory space.

        Examples
        --------
        >>> import divbandit as db
        >>> double = db.FunctionEnvironment(lambda x: 2 * x, db.Box([0], [1]))
        >>> double([[0.5], [1.0]])
        array([[1.],
               [2.]])
        """
        return one_by_one(self._effect, command, self.motor_space, self.sensory_space)

    def _effect(self, command: NDArray[np.float64]) -> ArrayLike:
        effect = self._f(*command.tolist()) if self._scalars else self._f(command)
        is_number = isinstance(effect, (int, float, np.number)) and not isinstance(effect, bool)
        return np.array([effect]) if is_number else effect

    def __repr__(self) -> str:
        name = getattr(self._f, "__name__", repr(self._f))
        scalars = ", scalars=True" if self._scalars else ""
        return f"FunctionEnvironment({name}, {self.motor_space!r}, {self.sensory_space!r}{scalars})"
