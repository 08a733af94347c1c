"""Sparseness: how far effects are from those observed before them."""

from __future__ import annotations

from dataclasses import dataclass

from divbandit._checks import whole
from divbandit.measures.native import NativeMeasure


@dataclass(frozen=True, init=False, repr=False)
class Sparseness(NativeMeasure):
    """The novelty of effects: their distance to the nearest of those observed before them.

    The gain of an effect is its sparseness, the mean Euclidean distance to the k nearest effects
    among all that were added before it (Lehman and Stanley 2008, "Exploiting Open-Endedness to
    Solve Problems Through the Search for Novelty", ALIFE XI; 2011, Evolutionary Computation 19(2),
    189-223). With fewer than k known it is the mean over those; the first effect gains 0.0.

    The measure is the sum of these gains. It depends on the order of the effects, and it never
    stops growing: it says how much novelty an exploration met, not how much space it covered.

    Gains have no bound, so `largest_gain` is 0.0 and a bandit gives no head start: it chooses
    uniformly until a strategy gains, and strategies not tried by then only by the share alpha.

    Parameters
    ----------
    k : int
        How many neighbours, from 1 to 2**32 - 1.

    Raises
    ------
    TypeError, ValueError
        If `k` is not a whole number in its range. Later, if a coordinate of an effect is beyond
        1e150: distances are found by their squares.

    Examples
    --------
    >>> from divbandit.measures import Sparseness
    >>> sparseness = Sparseness(k=2).start(2)
    >>> sparseness.extend([[0, 0], [3, 4], [0, 0], [0, 0]])
    array([0. , 5. , 2.5, 0. ])
    >>> sparseness.measure
    7.5
    """

    k: int

    def __init__(self, k: int = 15) -> None:
        # There are never more effects than that.
        self._set(k=whole("k", k, low=1, high=2**32 - 1))
