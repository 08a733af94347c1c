"""GridCoverage: how many cells of a grid are occupied."""

from __future__ import annotations

from typing import TYPE_CHECKING

from divbandit.measures.cells import Gridded

if TYPE_CHECKING:
    from numpy.typing import ArrayLike

    from divbandit.measures.cells import Cell


class GridCoverage(Gridded):
    """The number of cells of a grid in which effects lie.

    The coverage that the literature on quality diversity reports: the behaviour space is divided
    into bins, and filled ones are counted (Pugh, Soros and Stanley 2016, "Quality Diversity: A
    New Frontier for Evolutionary Computation", Frontiers in Robotics and AI 3:40). An effect in
    a new cell gains 1, another 0. Coarser than `Coverage`, which does not depend on where the
    borders lie, but as fast in many dimensions as in one.

    Parameters
    ----------
    cell : float or array_like, shape (dim,)
        Edge of the cells in the units of the effects, or one for each coordinate; positive.
    dim : int
        Dimension of the effects, from 1 to a million.
    origin : float or array_like, shape (dim,)
        A corner of the grid. Cells are closed below and open above, up to the rounding of
        ``(effect - origin) / cell``.

    Raises
    ------
    TypeError, ValueError
        If `cell` is not positive, or an argument is no number or of the wrong shape. Later, if
        an effect lies so many cells away that no float can count them.

    See Also
    --------
    Coverage : the exact area, or volume, around the effects.
    Entropy : how evenly the effects fill the cells.

    Examples
    --------
    >>> import divbandit as db
    >>> grid = db.GridCoverage(0.1)
    >>> grid.extend([[0.01, 0.02], [0.09, 0.08], [0.11, 0.08]])
    array([1., 0., 1.])
    >>> grid.measure, len(grid)
    (2.0, 3)
    """

    def __init__(self, cell: ArrayLike, *, dim: int = 2, origin: ArrayLike = 0.0) -> None:
        super().__init__(cell, dim=dim, origin=origin)
        self._occupied: set[Cell] = set()

    @property
    def measure(self) -> float:
        """The number of occupied cells."""
        return float(len(self._occupied))

    @property
    def largest_gain(self) -> float:
        """The gain of an effect in a new cell: 1."""
        return 1.0

    def _gain(self, place: Cell) -> float:
        return 0.0 if place in self._occupied else 1.0

    def _record(self, place: Cell, gain: float) -> None:
        if gain:
            self._occupied.add(place)

    def __repr__(self) -> str:
        return f"<GridCoverage of {len(self)} effects, cell={self.cell}, measure={self.measure}>"
