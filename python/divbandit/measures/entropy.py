"""Entropy: how evenly effects fill the cells of a grid."""

from __future__ import annotations

from typing import TYPE_CHECKING

from divbandit.measures.cells import Gridded
from divbandit.measures.logarithm import PLACES, fixed_log

if TYPE_CHECKING:
    from numpy.typing import ArrayLike

    from divbandit.measures.cells import Cell


class Entropy(Gridded):
    """The Shannon entropy, in nats, of the histogram of effects over a grid's cells.

    Delarboulas, Schoenauer and Sebag (2010, "Open-Ended Evolutionary Robotics: An Information
    Theoretic Approach", PPSN XI, 334-343) reward the entropy of the states that a robot visits;
    they find those states by clustering, here they are the cells of a grid.

    The gain of an effect is the change of the entropy. It is negative where the effect falls
    into a cell that is fuller than most, and shrinks with the number n of effects, at most
    about log(n) / n: with `Adapt` take a window short beside the length of a run. Adapt counts
    a negative mean gain as 0 when it chooses.

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
    GridCoverage : how many cells hold an effect at all.

    Examples
    --------
    >>> import divbandit as db
    >>> entropy = db.Entropy(1.0)
    >>> entropy.extend([[0, 0], [5, 5], [0, 0]]).round(6)
    array([ 0.      ,  0.693147, -0.056633])
    >>> round(entropy.measure, 6)
    0.636514
    """

    def __init__(self, cell: ArrayLike, *, dim: int = 2, origin: ArrayLike = 0.0) -> None:
        super().__init__(cell, dim=dim, origin=origin)
        self._counts: dict[Cell, int] = {}
        # The sum of c log c over the counts c, in units of 2**-64: a whole number, so that it
        # never drifts, and does not depend on the order of the effects.
        self._sum = 0
        self._measure = 0.0

    @property
    def measure(self) -> float:
        """The entropy in nats, from 0 to the logarithm of the number of occupied cells."""
        return self._measure

    @property
    def largest_gain(self) -> float:
        """The gain of the second effect where it lies in another cell than the first: log 2.

        An effect that comes after n others gains at most the entropy of one part in n + 1
        against the rest, which is greatest for n = 1.
        """
        return fixed_log(2) / (1 << PLACES)

    def _with(self, place: Cell) -> tuple[int, float]:
        """Return the sum and the entropy that one more effect leads to.

        H = log n - (sum of c log c) / n, rounded once: a whole number divided by another.
        """
        count, n = self._counts.get(place, 0), len(self) + 1
        total = self._sum + (count + 1) * fixed_log(count + 1)
        if count:
            total -= count * fixed_log(count)
        return total, (n * fixed_log(n) - total) / (n << PLACES)

    def _gain(self, place: Cell) -> float:
        return self._with(place)[1] - self._measure

    def _record(self, place: Cell, gain: float) -> None:
        del gain
        self._sum, self._measure = self._with(place)
        self._counts[place] = self._counts.get(place, 0) + 1

    def __repr__(self) -> str:
        return f"<Entropy of {len(self)} effects, cell={self.cell}, measure={self.measure}>"
