"""CellCoverage: which share of a box's cells is occupied."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

from divbandit._checks import cells_of, check_cells
from divbandit.box import Box
from divbandit.measures.native import NativeMeasure

if TYPE_CHECKING:
    from collections.abc import Sequence

    from divbandit._checks import Cells
    from divbandit.box import BoxLike


@dataclass(frozen=True, init=False, repr=False)
class CellCoverage(NativeMeasure):
    """The share of a box's cells in which effects lie: the coverage of quality-diversity archives.

    The box is cut into cells, as the grid archive of pyribs does; an effect outside of it counts in
    the nearest cell. An effect in a new cell gains 1 over their number, another 0 (Tjanaka et al.
    2023, "pyribs: A Bare-Bones Python Library for Quality Diversity Optimization", GECCO).

    Parameters
    ----------
    cells : int or sequence of int, shape (dim,)
        How many cells there are along each coordinate; at least 1, and at most ten million
        altogether.
    box : Box or object with ``low`` and ``high``
        What is cut into cells, such as the sensory space.

    Raises
    ------
    TypeError, ValueError
        If `cells` are not such numbers, are too many or of another dimension than `box`, or `box`
        is no box.

    See Also
    --------
    GridCoverage : counts cells of a given size, in an unbounded grid.
    BallCoverage : the exact area, or volume, around the effects.

    Examples
    --------
    >>> import divbandit as db
    >>> cells = db.measures.CellCoverage(10, db.Box([0, 0], [1, 1])).start(2)
    >>> cells.extend([[0.01, 0.02], [0.09, 0.08], [0.11, 0.08]])
    array([0.01, 0.  , 0.01])
    >>> cells.measure
    0.02
    """

    cells: Cells
    box: Box

    def __init__(self, cells: int | Sequence[int], box: BoxLike) -> None:
        self._set(cells=cells_of(cells), box=Box.of(box, name="box"))
        check_cells(self.cells, self.box.dim, "effects")
