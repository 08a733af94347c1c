"""Proportional: each strategy in proportion to its mean credit, as in the paper."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from divbandit import _core
from divbandit._checks import real
from divbandit.strategies.composite import share_of, total_of

if TYPE_CHECKING:
    from numpy.random import Generator

    from divbandit.bandits.memories.protocol import Memory


class Proportional:
    """With probability alpha uniformly at random, else in proportion to the mean credit.

    Benureau and Oudeyer 2015. With K strategies of mean credits m_j (a negative one counts as 0)
    strategy j is chosen with probability alpha / K + (1 - alpha) m_j^power / (sum of m_i^power);
    with 1 / K where no mean is positive. Two draws a choice, always.

    Parameters
    ----------
    alpha : float
        Share of choices made uniformly at random, in [0, 1].
    power : float
        The larger, the more often the best is chosen. Not negative; 1 is the paper's, with 0
        all whose mean is positive are equal.

    Attributes
    ----------
    alpha, power
        As given.

    Raises
    ------
    TypeError, ValueError
        If a number is out of range.

    Examples
    --------
    >>> import numpy as np
    >>> from divbandit.bandits import Proportional, WholePast
    >>> memory = WholePast()
    >>> memory.begin(2, 6.0)
    >>> memory.add(0, 1.0)
    >>> memory.add(1, 3.0)
    >>> rule = Proportional(alpha=0.0)
    >>> rule.choose(memory, np.random.default_rng(0))
    (1, 0.75)
    """

    def __init__(self, alpha: float = 0.1, *, power: float = 1.0) -> None:
        self.alpha = real("alpha", alpha, low=0.0, high=1.0)
        self.power = real("power", power, low=0.0)

    def begin(self, parts: int, largest: float) -> None:
        """Nothing needs to be prepared."""

    def choose(self, memory: Memory, rng: Generator) -> tuple[int, float]:
        """Draw a strategy: two ``rng.random()``."""
        weights = self._weights(memory)
        total = total_of(weights)
        uniformly, u = rng.random() < self.alpha, rng.random()
        index = int(u * len(weights)) if uniformly else share_of(weights, total, u)
        return index, self._probability(weights[index], total, len(weights))

    def choose_many(self, memory: Memory, n: int, rng: Generator) -> list[tuple[int, float]]:
        """Return what `n` calls of `choose` return: two ``rng.random()`` each."""
        weights = self._weights(memory)
        total, count = total_of(weights), len(weights)
        choices = [(j, self._probability(weight, total, count)) for j, weight in enumerate(weights)]
        first, u = rng.random((n, 2)).T
        uniformly = (u * count).astype(np.int64)
        if total <= 0.0:
            return [choices[index] for index in uniformly.tolist()]
        # As `share_of`, but for all at once: the same subtractions, and so the same choices.
        left = u * total
        indices = np.full(n, max(j for j, weight in enumerate(weights) if weight > 0.0))
        undecided = first >= self.alpha
        for index, weight in enumerate(weights):
            here = undecided & (left < weight)
            indices[here] = index
            undecided &= ~here
            left -= weight
        indices = np.where(first < self.alpha, uniformly, indices)
        return [choices[index] for index in indices.tolist()]

    def _weights(self, memory: Memory) -> list[float]:
        """Return what strategies are chosen in proportion to."""
        weights = [max(0.0, mean) for mean in memory.means]
        return weights if self.power == 1.0 else self._powers(weights)

    def _probability(self, weight: float, total: float, count: int) -> float:
        """Return with which probability a strategy of this weight is chosen."""
        if total <= 0.0:
            return 1.0 / count
        # Rounding may carry the sum one unit beyond 1.
        return min(1.0, self.alpha / count + (1.0 - self.alpha) * weight / total)

    def _powers(self, weights: list[float]) -> list[float]:
        """Return powers of the weights' shares of the largest: none overflows, not all vanish."""
        top = max(weights)
        return [
            _core.power(weight / top, self.power) if weight > 0.0 else 0.0 for weight in weights
        ]

    def __repr__(self) -> str:
        power = "" if self.power == 1.0 else f", power={self.power!r}"
        return f"Proportional({self.alpha!r}{power})"
