"""Cells: the edges and the origin of a grid, as arguments of its measures."""

from __future__ import annotations

from numbers import Real
from typing import TYPE_CHECKING

from divbandit._checks import real
from divbandit._core import as_point

if TYPE_CHECKING:
    from numpy.typing import ArrayLike

    #: A number for all coordinates, or one for each.
    PerCoordinate = float | tuple[float, ...]


def edges(cell: ArrayLike) -> PerCoordinate:
    """Return the edge of a grid's cells, or one for each coordinate; all are positive.

    Examples
    --------
    >>> edges(1), edges([0.1, 0.2])
    (1.0, (0.1, 0.2))
    """
    found = per_coordinate("cell", cell)
    if not all(edge > 0.0 for edge in (found if isinstance(found, tuple) else [found])):
        raise ValueError(f"cell must be positive, got {cell!r}")
    return found


def per_coordinate(name: str, value: ArrayLike) -> PerCoordinate:
    """Return a finite number, or a tuple of one for each coordinate.

    Examples
    --------
    >>> per_coordinate("origin", 0), per_coordinate("origin", [0, -3])
    (0.0, (0.0, -3.0))
    """
    if isinstance(value, (Real, bool)):
        return real(name, value)
    return tuple(as_point(name, value).tolist())
