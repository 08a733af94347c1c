"""NativeMeasure: what the measures have in common whose running part is compiled."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

from divbandit import _core
from divbandit._checks import per_coordinate
from divbandit._value import Value

if TYPE_CHECKING:
    from numpy.typing import ArrayLike

    from divbandit._checks import PerCoordinate
    from divbandit.measures.protocol import RunningMeasure


class NativeMeasure(Value):
    """A measure whose running part is compiled."""

    __slots__ = ()

    def start(self, dim: int) -> RunningMeasure:
        """Return the measure of no effects.

        Parameters
        ----------
        dim : int
            Dimension of the effects, from 1 to a million.

        Raises
        ------
        TypeError, ValueError
            If `dim` is not a whole number in its range, or an argument of the measure has another
            number of coordinates.

        Examples
        --------
        >>> from divbandit.measures import Entropy, GridCoverage
        >>> Entropy(0.5).start(3)
        <Entropy(0.5) of 0 effects in R^3, measure=0.0>
        >>> GridCoverage([0.1, 0.2]).start(3)
        Traceback (most recent call last):
            ...
        ValueError: cell must have length 3, got 2
        """
        return _core.Measure(self, dim)


@dataclass(frozen=True, init=False, repr=False)
class CellMeasure(NativeMeasure):
    """A measure that counts in the cells of a grid."""

    cell: PerCoordinate
    origin: PerCoordinate

    def __init__(self, cell: ArrayLike, *, origin: ArrayLike = 0.0) -> None:
        edges = per_coordinate("cell", cell)
        if not all(edge > 0.0 for edge in (edges if isinstance(edges, tuple) else [edges])):
            raise ValueError(f"cell must be positive, got {cell!r}")
        self._set(cell=edges, origin=per_coordinate("origin", origin))
