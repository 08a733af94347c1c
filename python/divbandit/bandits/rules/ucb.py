"""UCB: the strategy whose mean credit could be the best, given how little is known of it."""

from __future__ import annotations

from math import sqrt
from typing import TYPE_CHECKING

from divbandit._checks import real
from divbandit._core import log
from divbandit.bandits.rules.ties import best
from divbandit.strategies.composite import total_of

if TYPE_CHECKING:
    from numpy.random import Generator

    from divbandit.bandits.memories.protocol import Memory


class UCB:
    """The strategy j with the largest m_j + B sqrt(xi ln(n) / n_j).

    m_j is the mean credit that the memory holds of it and n_j of how many credits that is, n the
    sum of all n_j; B is the largest credit or, where credits have no bound, the largest absolute
    one so far. It depends on the memory which of the published rules this is:

    - with `WholePast`, UCB1 for xi = 2: m_j + B sqrt(2 ln t / n_j) (Auer, Cesa-Bianchi and Fischer
      2002, "Finite-time Analysis of the Multiarmed Bandit Problem", Machine Learning 47, 235-256);
    - with `RecentWindow`, SW-UCB: m_j + B sqrt(xi ln(min(t, w)) / n_j) (Garivier and Moulines 2008,
      "On Upper-Confidence Bound Policies for Non-Stationary Bandit Problems");
    - with `Discounted`, D-UCB of the same paper, m_j + 2 B sqrt(xi ln(n) / n_j), where a factor of
      2 before the root is one of 4 within: ``UCB(4 * xi)``.

    `ucb1`, `sliding_window_ucb` and `discounted_ucb` put these together. Strategies of which the
    memory holds nothing come first. Of several best ones each is as likely: one draw a choice,
    always.

    A strategy that was asked and not told of yet counts as if it had been told once more, and had
    earned its mean: so those never tried take turns also while nothing is told, and many that are
    asked at once are not all the same. A trial that will never be told should be failed.

    Parameters
    ----------
    xi : float
        How much is made of not knowing; not negative.

    Attributes
    ----------
    xi : float

    Raises
    ------
    TypeError, ValueError
        If `xi` is no number, or negative.

    Examples
    --------
    >>> import numpy as np
    >>> from divbandit.bandits import UCB, WholePast
    >>> memory, rule, rng = WholePast(), UCB(2.0), np.random.default_rng(0)
    >>> memory.begin(3, 6.0)
    >>> rule.begin(3, 6.0)
    >>> memory.add(1, 3.0)
    >>> sorted(rule.choose(memory, rng)[0] for _ in range(2))  # those never tried
    [0, 2]
    """

    def __init__(self, xi: float = 2.0) -> None:
        self.xi = real("xi", xi, low=0.0)
        self._asked: list[int] = []  # of each strategy, how often without being told

    def begin(self, parts: int, largest: float) -> None:
        """Forget what was asked."""
        del largest
        self._asked = [0] * parts

    def bounds(self, memory: Memory) -> list[float]:
        """Return the upper confidence bound of each strategy; infinite for those never tried.

        Parameters
        ----------
        memory : Memory

        Examples
        --------
        >>> from divbandit.bandits import UCB, WholePast
        >>> memory, rule = WholePast(), UCB(2.0)
        >>> memory.begin(2, 6.0)
        >>> rule.begin(2, 6.0)
        >>> memory.add(1, 3.0)
        >>> rule.bounds(memory)  # 3 + 6 sqrt(2 ln(1) / 1)
        [inf, 3.0]
        """
        counts = [n + asked for n, asked in zip(memory.counts, self._asked, strict=True)]
        known = self.xi * log(max(1.0, total_of(counts)))
        largest = memory.largest
        return [
            mean + largest * sqrt(known / count) if count > 0.0 else float("inf")
            for mean, count in zip(memory.means, counts, strict=True)
        ]

    def choose(self, memory: Memory, rng: Generator) -> tuple[int, float]:
        """Return the largest bound's strategy: one ``rng.random()``, for ties."""
        ties = best(self.bounds(memory))
        index = ties[int(rng.random() * len(ties))]
        self._asked[index] += 1
        return index, 1.0 / len(ties)

    def learn(self, part: int, credit: float, probability: float | None) -> None:
        """One that was asked has been told."""
        del credit, probability
        if self._asked[part] > 0:
            self._asked[part] -= 1

    def __repr__(self) -> str:
        return f"UCB({self.xi!r})"
