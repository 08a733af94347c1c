"""The rows of a trajectory, checked."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from divbandit.box import Box
from divbandit.controllers.protocol import Trajectories

if TYPE_CHECKING:
    from numpy.typing import NDArray


def motor_space_of(primitives: object) -> Box:
    """Return the motor space of an object that makes trajectories, or say what it lacks."""
    if not isinstance(primitives, Trajectories):
        raise TypeError(
            "primitives must have motor_space and trajectory(command), "
            f"got {type(primitives).__name__}"
        )
    return Box.of(primitives.motor_space, name="primitives.motor_space")


def rows_of(primitives: Trajectories, command: NDArray[np.float64]) -> NDArray[np.float64]:
    """Return the trajectory of a command, shape (steps + 1, dofs), or say what is wrong with it."""
    given = primitives.trajectory(command)
    try:
        rows = np.array(given, dtype=np.float64)
    except (TypeError, ValueError):
        raise TypeError(
            f"primitives.trajectory must return an array of numbers, got {given!r}"
        ) from None
    if rows.ndim != 2 or 0 in rows.shape:
        raise ValueError(
            "primitives.trajectory must return an array of shape (steps + 1, dofs), "
            f"got {rows.shape}"
        )
    if not np.isfinite(rows).all():
        step, dof = np.argwhere(~np.isfinite(rows))[0]
        raise ValueError(
            f"primitives.trajectory must return finite numbers, got {rows[step, dof]} "
            f"in row {step}, column {dof}"
        )
    return rows
