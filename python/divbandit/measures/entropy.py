"""Entropy: how evenly effects fill the cells of a grid."""

from __future__ import annotations

from dataclasses import dataclass

from divbandit.measures.native import CellMeasure


@dataclass(frozen=True, init=False, repr=False)
class Entropy(CellMeasure):
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
