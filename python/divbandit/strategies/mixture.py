"""Mixture: strategies chosen with fixed probabilities."""

from __future__ import annotations

from math import inf
from typing import TYPE_CHECKING

from divbandit._core import as_point
from divbandit.strategies.composite import Composite, proportionally, total_of

if TYPE_CHECKING:
    from collections.abc import Iterable

    from numpy.random import Generator
    from numpy.typing import ArrayLike

    from divbandit._engine import Description
    from divbandit.history import History
    from divbandit.strategies.base import Strategy


class Mixture(Composite):
    """Strategy j with probability p_j, always (Benureau and Oudeyer 2015, figure 4).

    Parameters
    ----------
    strategies : iterable of Strategy
    weights : array_like, shape (number of strategies,), optional
        Not negative, at least one positive; the probabilities are proportional to them. Equal
        by default.

    Raises
    ------
    TypeError, ValueError
        If a strategy is none, or the weights do not fit.

    Examples
    --------
    >>> import divbandit as db
    >>> mixture = db.Mixture([db.MotorBabbling(), db.GoalBabbling(0.05)], weights=[0.3, 0.7])
    >>> mixture.weights
    (0.3, 0.7)
    """

    def __init__(self, strategies: Iterable[Strategy], *, weights: ArrayLike | None = None) -> None:
        super().__init__(strategies)
        count = len(self.strategies)
        given = as_point("weights", [1.0] * count if weights is None else weights, count)
        self.weights: tuple[float, ...] = tuple(given.tolist())
        for index, weight in enumerate(self.weights):
            if weight < 0:
                raise ValueError(f"weights[{index}] must not be negative, got {weight!r}")
        if not 0 < total_of(self.weights) < inf:
            raise ValueError(f"weights must have a positive, finite sum, got {list(self.weights)}")

    def choose(self, history: History, rng: Generator) -> int:
        """Draw a strategy: one ``rng.random()``."""
        del history
        return proportionally(self.weights, rng.random())

    def _describe(self, description: Description) -> int:
        parts = description.add_all(self.strategies)
        return description.engine.mixture(parts, self.weights)

    def __repr__(self) -> str:
        return f"Mixture({list(self.strategies)!r}, weights={list(self.weights)!r})"
