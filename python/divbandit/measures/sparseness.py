"""Sparseness: how far effects are from those observed before them."""

from __future__ import annotations

from array import array
from math import fsum
from typing import TYPE_CHECKING, Any

import numpy as np

from divbandit._checks import whole
from divbandit._core import NearestNeighbors
from divbandit.measures.base import Incremental
from divbandit.measures.points import element

if TYPE_CHECKING:
    from numpy.typing import NDArray

#: Distances are computed by their squares, which must not overflow.
_FARTHEST = 1e150


class Sparseness(Incremental["NDArray[np.float64]"]):
    """The novelty of effects: their distance to the nearest of those observed before them.

    The gain of an effect is its sparseness, the mean Euclidean distance to the k nearest effects
    among all that were added before it (Lehman and Stanley 2008, "Exploiting Open-Endedness to
    Solve Problems Through the Search for Novelty", ALIFE XI; 2011, Evolutionary Computation
    19(2), 189-223). With fewer than k known it is the mean over those; the first effect of all
    gains 0.0, as there is nothing that it could be far from.

    The measure is the sum of these gains. It depends on the order of the effects, and it never
    stops growing: it says how much novelty an exploration went through, not how much space it
    covered.

    Gains have no bound, so `largest_gain` is 0.0, and `Adapt` has no head start to give: it
    chooses uniformly until a strategy gains, from then on a strategy that was not tried yet
    by the share alpha alone. Derive a class that says what gain to begin with, as below, where
    that is too little.

    Parameters
    ----------
    k : int
        How many neighbours, at least 1.
    dim : int
        Dimension of the effects, from 1 to a million.

    Raises
    ------
    TypeError, ValueError
        If `k` or `dim` is no whole number in its range. Later, if a coordinate of an effect is
        beyond 1e150: distances are computed by their squares.

    Examples
    --------
    >>> import divbandit as db
    >>> sparseness = db.Sparseness(k=2)
    >>> sparseness.extend([[0, 0], [3, 4], [0, 0], [0, 0]])
    array([0. , 5. , 2.5, 0. ])
    >>> sparseness.measure
    7.5
    >>> class Eager(db.Sparseness):
    ...     largest_gain = 1.0
    >>> db.Adapt([db.MotorBabbling()], measure=Eager()).diversities
    (1.0,)
    """

    def __init__(self, k: int = 15, *, dim: int = 2) -> None:
        super().__init__(dim)
        self._k = whole("k", k, low=1)
        self._tree = NearestNeighbors(self.dim)
        self._known = array("d")  # all effects, number by number: what the tree is made of
        # The sum and what its rounding lost (Neumaier), so that a million gains do not drift.
        self._sum = self._lost = 0.0

    @property
    def k(self) -> int:
        """How many neighbours the distance is averaged over."""
        return self._k

    @property
    def measure(self) -> float:
        """The sum of all gains, in the units of the effects."""
        return self._sum + self._lost

    @property
    def largest_gain(self) -> float:
        """No gain is the largest: 0.0, no head start."""
        return 0.0

    def _place(
        self, name: str, row: int | None, effect: NDArray[np.float64]
    ) -> NDArray[np.float64]:
        for column, x in enumerate(effect.tolist()):
            if abs(x) > _FARTHEST:
                where = element(name, row, column)
                raise ValueError(f"{where} must be within {_FARTHEST} of 0, got {x}")
        return effect

    def _gain(self, place: NDArray[np.float64]) -> float:
        k = min(self._k, len(self._tree))
        if k == 0:
            return 0.0
        distances, _ = self._tree.nearest(place, k=k)
        # An exact sum: it depends on nothing but the distances.
        return float(distances) if k == 1 else fsum(distances.tolist()) / k

    def _record(self, place: NDArray[np.float64], gain: float) -> None:
        self._tree.add(place)
        self._known.extend(place.tolist())
        total = self._sum + gain
        larger, smaller = max(self._sum, gain), min(self._sum, gain)
        self._lost += (larger - total) + smaller
        self._sum = total

    def __getstate__(self) -> dict[str, Any]:
        """Leave out the tree: it is made anew from the effects."""
        return {name: value for name, value in self.__dict__.items() if name != "_tree"}

    def __setstate__(self, state: dict[str, Any]) -> None:
        self.__dict__.update(state)
        self._tree = NearestNeighbors(self.dim)
        self._tree.extend(np.array(self._known).reshape(-1, self.dim))

    def __repr__(self) -> str:
        return f"<Sparseness of {len(self)} effects, k={self.k}, measure={self.measure}>"
