"""GridCoverage: how many cells of a grid are occupied."""

from __future__ import annotations

from dataclasses import dataclass

from divbandit.measures.native import CellMeasure


@dataclass(frozen=True, init=False, repr=False)
class GridCoverage(CellMeasure):
    """The number of cells of a grid in which effects lie.

    The coverage that the literature on quality diversity reports: the behaviour space is divided
    into bins, and filled ones are counted (Pugh, Soros and Stanley 2016, "Quality Diversity: A
    New Frontier for Evolutionary Computation", Frontiers in Robotics and AI 3:40). An effect in
    a new cell gains 1, another 0. Coarser than `BallCoverage`, which does not depend on where the
    borders lie, but as fast in many dimensions as in one.

    Parameters
    ----------
    cell : float or array_like, shape (dim,)
        Edge of the cells in the units of the effects, or one for each coordinate; positive.
    origin : float or array_like, shape (dim,)
        A corner of the grid. Cells are closed below and open above, up to the rounding of
        ``(effect - origin) / cell``.

    Raises
    ------
    TypeError, ValueError
        If `cell` is not positive, or an argument is neither a number nor a sequence of numbers.
        Later, if an effect lies too many cells away for a float to count.

    See Also
    --------
    BallCoverage : the exact area, or volume, around the effects.
    Entropy : how evenly the effects fill the cells.

    Examples
    --------
    >>> from divbandit.measures import GridCoverage
    >>> grid = GridCoverage(0.1).start(2)
    >>> grid.extend([[0.01, 0.02], [0.09, 0.08], [0.11, 0.08]])
    array([1., 0., 1.])
    >>> grid.measure, len(grid)
    (2.0, 3)
    """
