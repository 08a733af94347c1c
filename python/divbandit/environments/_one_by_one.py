"""one_by_one: one effect of one command, many of many."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from divbandit._core import as_point

if TYPE_CHECKING:
    from collections.abc import Callable

    from numpy.typing import ArrayLike, NDArray

    from divbandit.box import Box


def one_by_one(
    evaluate: Callable[[NDArray[np.float64]], ArrayLike],
    command: ArrayLike,
    motor_space: Box,
    sensory_space: Box | None,
) -> NDArray[np.float64]:
    """Return the effect of one command, shape (s,), or the effects of many, shape (n, s).

    Raises
    ------
    TypeError, ValueError
        If a command is no point of the motor space, or an effect no finite point of the sensory
        space, or of another dimension than those before.

    Examples
    --------
    >>> import divbandit as db
    >>> one_by_one(lambda x: 2 * x, [[0.5], [1.0]], db.Box([0], [1]), None)
    array([[1.],
           [2.]])
    """
    commands = motor_space.bounds.commands(command)
    length = None if sensory_space is None else sensory_space.dim
    if commands.ndim == 1:
        return as_point("effect", evaluate(commands), length)
    effects = []
    for row in commands:
        effect = as_point("effect", evaluate(row), length)
        length = len(effect)
        effects.append(effect)
    return np.stack(effects) if effects else np.empty((0, length or 0))
