"""one_by_one: evaluate one command, or many in turn."""

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

    Raises a TypeError or a ValueError if a command is not a point of the motor space, or an effect
    is not a finite point of the sensory space or of the dimension of the effects before it.
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
