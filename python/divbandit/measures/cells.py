"""Cells: a grid of equal boxes, in which of them an effect lies, and what such measures share."""

from __future__ import annotations

from math import floor
from numbers import Real
from typing import TYPE_CHECKING

from divbandit._checks import real
from divbandit._core import as_point
from divbandit.measures.base import Incremental
from divbandit.measures.points import element

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import ArrayLike, NDArray

    #: The whole numbers of a cell's place in the grid, one a coordinate.
    Cell = tuple[int, ...]


class Cells:
    """The cells of a grid, closed below and open above: cell 0 reaches from the origin to `cell`.

    Which cell it is follows from the rounded quotient ``(effect - origin) / cell``, so that an
    effect within a rounding error of a border may count on either side of it, always the same.

    Parameters
    ----------
    cell : float or array_like, shape (dim,)
        Edge of the cells, or one for each coordinate; positive.
    origin : float or array_like, shape (dim,)
        A corner of the grid.
    dim : int

    Examples
    --------
    >>> import numpy as np
    >>> Cells(0.5, 0.0, dim=2).of("effect", None, np.array([0.75, -0.25]))
    (1, -1)
    """

    __slots__ = ("edges", "origin")

    def __init__(self, cell: ArrayLike, origin: ArrayLike, *, dim: int) -> None:
        self.edges = _one_a_coordinate("cell", cell, dim)
        self.origin = _one_a_coordinate("origin", origin, dim)
        if not all(edge > 0.0 for edge in self.edges):
            raise ValueError(f"cell must be positive, got {cell!r}")

    def of(self, name: str, row: int | None, effect: NDArray[np.float64]) -> Cell:
        """Return the cell in which an effect lies; an error calls it `name`, or its row `row`."""
        try:
            # Python's whole numbers have no largest: 1e300 with an edge of 1 has its cell, too.
            return tuple(
                [
                    floor((x - low) / edge)
                    for x, low, edge in zip(effect.tolist(), self.origin, self.edges, strict=True)
                ]
            )
        except OverflowError:  # the quotient was infinite
            raise ValueError(self._too_far(name, row, effect.tolist())) from None

    def _too_far(self, name: str, row: int | None, effect: list[float]) -> str:
        for column, x in enumerate(effect):
            low, edge = self.origin[column], self.edges[column]
            if abs((x - low) / edge) == float("inf"):
                where = element(name, row, column)
                return f"{where} must be within 1.7e308 cells of {low}, got {x} with cell {edge}"
        raise AssertionError("unreachable: every quotient is finite")


class Gridded(Incremental["Cell"]):
    """A measure to which all effects in one cell are the same."""

    def __init__(self, cell: ArrayLike, *, dim: int, origin: ArrayLike) -> None:
        super().__init__(dim)
        self._cells = Cells(cell, origin, dim=self.dim)

    @property
    def cell(self) -> tuple[float, ...]:
        """Edges of a cell, one a coordinate, in the units of the effects."""
        return self._cells.edges

    @property
    def origin(self) -> tuple[float, ...]:
        """A corner of the grid."""
        return self._cells.origin

    def _place(self, name: str, row: int | None, effect: NDArray[np.float64]) -> Cell:
        return self._cells.of(name, row, effect)


def _one_a_coordinate(name: str, value: ArrayLike, dim: int) -> tuple[float, ...]:
    """Return a number, or one for each coordinate, as the latter."""
    if isinstance(value, (Real, bool)):
        return (real(name, value),) * dim
    return tuple(as_point(name, value, dim).tolist())
