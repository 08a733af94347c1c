"""Entropy: how evenly effects fill the cells of a grid."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

from divbandit import _core
from divbandit._value import Value
from divbandit.measures.cells import edges, per_coordinate

if TYPE_CHECKING:
    from numpy.typing import ArrayLike

    from divbandit.measures.cells import PerCoordinate
    from divbandit.measures.protocol import RunningMeasure


@dataclass(frozen=True, init=False, repr=False)
class Entropy(Value):
    """The Shannon entropy, in nats, of the histogram of effects over a grid's cells.

    Delarboulas, Schoenauer and Sebag (2010, "Open-Ended Evolutionary Robotics: An Information
    Theoretic Approach", PPSN XI, 334-343) reward the entropy of the states that a robot visits;
    they find those states by clustering, here they are the cells of a grid.

    The gain of an effect is the change of the entropy. It is negative where the effect falls into a
    cell that is fuller than most, and shrinks with the number n of effects, at most about log(n) /
    n: with `Adapt`, choose a window that is short compared with the run. Adapt counts a negative
    mean gain as 0 when it chooses. The largest gain is that of the second effect where it lies in
    another cell than the first: log 2.

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
    GridCoverage : how many cells hold an effect at all.

    Examples
    --------
    >>> from divbandit.measures import Entropy
    >>> entropy = Entropy(1.0).start(2)
    >>> entropy.extend([[0, 0], [5, 5], [0, 0]]).round(6)
    array([ 0.      ,  0.693147, -0.056633])
    >>> round(entropy.measure, 6)
    0.636514
    """

    cell: PerCoordinate
    origin: PerCoordinate

    def __init__(self, cell: ArrayLike, *, origin: ArrayLike = 0.0) -> None:
        self._set(cell=edges(cell), origin=per_coordinate("origin", origin))

    def start(self, dim: int) -> RunningMeasure:
        """Return the measure of no effects.

        Parameters
        ----------
        dim : int
            Dimension of the effects, from 1 to a million.

        Raises
        ------
        TypeError, ValueError
            If `dim` is out of range, or `cell` or `origin` has another number of coordinates.

        Examples
        --------
        >>> from divbandit.measures import Entropy
        >>> Entropy(0.5).start(3)
        <Entropy(0.5) of 0 effects in R^3, measure=0.0>
        """
        return _core.Measure(self, dim)
