"""Thompson: each strategy as often as it is likely to be the best."""

from __future__ import annotations

from math import sqrt
from typing import TYPE_CHECKING

from divbandit._core import normal_quantile
from divbandit.bandits.rules.ties import best

if TYPE_CHECKING:
    from numpy.random import Generator

    from divbandit.bandits.memories.protocol import Memory

#: What stands for a draw of 0, half of the least other one: the quantile of 0 is no number.
_LEAST = 2.0**-54


class Thompson:
    """The strategy with the largest of numbers drawn from N(m_j, B^2 / (n_j + 1)), one for each.

    Thompson sampling with Gaussian posteriors (Agrawal and Goyal 2013, "Further Optimal Regret
    Bounds for Thompson Sampling", AISTATS, 99-107), where m_j is the mean credit of strategy j and
    n_j of how many credits; theirs divides the sum of credits by n_j + 1. B is the largest credit
    or, where credits have no bound, the largest absolute one so far; 1 while there is none. As many
    draws a choice as there are strategies, in order.

    Examples
    --------
    >>> import numpy as np
    >>> from divbandit.bandits import Thompson, WholePast
    >>> memory = WholePast()
    >>> memory.begin(2, 6.0)
    >>> memory.add(1, 3.0)
    >>> rng = np.random.default_rng(0)
    >>> [Thompson().choose(memory, rng) for _ in range(6)]
    [0, 1, 1, 1, 1, 0]
    """

    def begin(self, parts: int, largest: float) -> None:
        """Nothing needs to be prepared."""

    def choose(self, memory: Memory, rng: Generator) -> int:
        """Draw a strategy: one ``rng.random()`` for each."""
        scale = memory.largest or 1.0
        sampled = [
            mean + scale / sqrt(count + 1.0) * normal_quantile(rng.random() or _LEAST)
            for mean, count in zip(memory.means, memory.counts, strict=True)
        ]
        return best(sampled)[0]

    def __repr__(self) -> str:
        return "Thompson()"
