"""Checks of plain arguments; those of arrays are made where the arrays are read, in Rust."""

from __future__ import annotations

import math
import operator
from numbers import Integral, Real
from typing import TYPE_CHECKING

import numpy as np

from divbandit._core import as_point

if TYPE_CHECKING:
    from collections.abc import Sequence

    from numpy.random import Generator, SeedSequence
    from numpy.typing import ArrayLike

    Rng = Generator | SeedSequence | int | None
    #: A number for all coordinates, or one for each.
    PerCoordinate = float | tuple[float, ...]
    #: How many cells there are along each coordinate, or one number for all.
    Cells = int | tuple[int, ...]

#: Upper limit on the cells of a grid, which are stored one by one.
_MOST_CELLS = 10_000_000


def real(name: str, value: object, *, low: float = -math.inf, high: float = math.inf) -> float:
    """Return `value` as a finite float in [low, high], or say what is wrong with it."""
    if isinstance(value, bool) or not isinstance(value, Real):
        raise TypeError(f"{name} must be a number, got {type(value).__name__}")
    try:
        number = float(value)
    except OverflowError:
        number = math.inf
    if not (math.isfinite(number) and low <= number <= high):
        raise ValueError(f"{name} must be a finite number in [{low}, {high}], got {value!r}")
    return number


def positive(name: str, value: object) -> float:
    """Return `value` as a finite float above 0, or say what is wrong with it."""
    number = real(name, value)
    if number <= 0.0:
        raise ValueError(f"{name} must be a positive, finite number, got {value!r}")
    return number


def whole(name: str, value: object, *, low: int, high: int | None = None) -> int:
    """Return `value` as an int in [low, high], or say what is wrong with it."""
    # A plain int, the most common case, needs no check against the abstract class.
    if type(value) is not int and (isinstance(value, bool) or not isinstance(value, Integral)):
        raise TypeError(f"{name} must be a whole number, got {type(value).__name__}")
    number = operator.index(value)
    if number < low or (high is not None and number > high):
        bounds = f"at least {low}" if high is None else f"from {low} to {high}"
        raise ValueError(f"{name} must be {bounds}, got {number}")
    return number


def floats(name: str, value: ArrayLike, dim: int | None = None) -> tuple[float, ...]:
    """Return a finite point of `dim` coordinates as a tuple, or say what is wrong with it."""
    return tuple(as_point(name, value, dim).tolist())


def per_coordinate(name: str, value: ArrayLike) -> PerCoordinate:
    """Return a finite number, or a tuple of one for each coordinate."""
    if isinstance(value, (Real, bool)):
        return real(name, value)
    return floats(name, value)


def cells_of(cells: int | Sequence[int]) -> Cells:
    """Return how many cells a grid has along each coordinate, or say what is wrong with it."""
    if not isinstance(cells, (list, tuple, np.ndarray)):
        return whole("cells", cells, low=1, high=_MOST_CELLS)
    if len(cells) == 0:
        raise ValueError("cells must not be empty")
    return tuple(
        whole(f"cells[{j}]", count, low=1, high=_MOST_CELLS) for j, count in enumerate(cells)
    )


def check_cells(cells: Cells, dim: int, of: str) -> None:
    """Raise a ValueError if a grid of `dim` dimensions does not have these cells, or too many."""
    shape = (cells,) * dim if isinstance(cells, int) else cells
    if len(shape) != dim:
        raise ValueError(
            f"cells must be one number or {dim}, one for each coordinate of the {of}, "
            f"got {len(shape)}"
        )
    if math.prod(shape) > _MOST_CELLS:
        raise ValueError(f"cells must be at most {_MOST_CELLS} altogether, got {cells!r}")


def truth(name: str, value: object) -> bool:
    """Return `value` if it is True or False, or say what is wrong with it."""
    if not isinstance(value, (bool, np.bool_)):
        raise TypeError(f"{name} must be True or False, got {type(value).__name__}")
    return bool(value)


def one_of(name: str, value: object, names: Sequence[str]) -> str:
    """Return `value` if it is one of these names, or say what is wrong with it."""
    if not isinstance(value, str):
        raise TypeError(f"{name} must be a name, got {type(value).__name__}")
    if value not in names:
        known = ", ".join(map(repr, names))
        raise ValueError(f"{name} must be one of {known}, got {value!r}")
    return value


def generator(rng: Rng) -> Generator:
    """Return the generator that `rng` is or seeds; a Generator itself is shared, not copied."""
    allowed = (type(None), Integral, np.random.SeedSequence, np.random.Generator)
    if isinstance(rng, bool) or not isinstance(rng, allowed):
        raise TypeError(
            f"rng must be None, an int, a SeedSequence or a Generator, got {type(rng).__name__}"
        )
    if isinstance(rng, Integral) and rng < 0:
        raise ValueError(f"rng must be a seed of at least 0, got {rng!r}")
    return np.random.default_rng(rng)
