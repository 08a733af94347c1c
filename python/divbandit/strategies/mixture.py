"""Mixture: strategies chosen with fixed probabilities."""

from __future__ import annotations

from dataclasses import dataclass
from math import inf
from typing import TYPE_CHECKING

from divbandit._core import as_point, proportionally
from divbandit.strategies.composite import Composite, CompositeValue, strategies_of

if TYPE_CHECKING:
    from collections.abc import Iterable

    from numpy.random import Generator
    from numpy.typing import ArrayLike

    from divbandit.history import History
    from divbandit.strategies.base import Starter, Strategy


@dataclass(frozen=True, init=False, repr=False)
class Mixture(CompositeValue):
    """Strategy j with probability p_j, always (Benureau and Oudeyer 2015, figure 4).

    Parameters
    ----------
    strategies : iterable of Strategy
    weights : array_like, shape (number of strategies,), optional
        Not negative, at least one positive; the probabilities are proportional to them. Equal
        by default.

    Attributes
    ----------
    strategies : tuple of Strategy
    weights : tuple of float

    Raises
    ------
    TypeError, ValueError
        If a strategy is not one, or the weights do not fit.

    Examples
    --------
    >>> import divbandit as db
    >>> mixture = db.Mixture([db.MotorBabbling(), db.GoalBabbling(0.05)], weights=[0.3, 0.7])
    >>> mixture.weights
    (0.3, 0.7)
    """

    strategies: tuple[Strategy, ...]
    weights: tuple[float, ...]

    def __init__(self, strategies: Iterable[Strategy], *, weights: ArrayLike | None = None) -> None:
        every = strategies_of(strategies)
        given = as_point("weights", [1.0] * len(every) if weights is None else weights, len(every))
        for index, weight in enumerate(given.tolist()):
            if weight < 0:
                raise ValueError(f"weights[{index}] must not be negative, got {weight!r}")
        if not 0 < sum(given.tolist()) < inf:
            raise ValueError(f"weights must have a positive, finite sum, got {given.tolist()}")
        self._set(strategies=every, weights=tuple(given.tolist()))

    def start(self, start: Starter) -> Strategy:
        """Return a mixture of the started parts."""
        return _Mixing(map(start, self.strategies), self.weights)


class _Mixing(Composite):
    """A mixture under way."""

    def __init__(self, strategies: Iterable[Strategy], weights: tuple[float, ...]) -> None:
        super().__init__(strategies)
        self._weights = weights

    def choose(self, history: History, rng: Generator) -> int:
        """Draw a strategy: one ``rng.random()``."""
        del history
        return proportionally(self._weights, rng.random())
