"""Discounted: all credits, of which older ones weigh less."""

from __future__ import annotations

from divbandit._checks import positive, real
from divbandit.bandits.memories.base import Remembering


class Discounted(Remembering):
    """The mean of each strategy's credits, one that is k credits old weighing gamma^k.

    The memory of D-UCB (Kocsis and Szepesvari 2006, "Discounted UCB"; Garivier and Moulines 2008,
    "On Upper-Confidence Bound Policies for Non-Stationary Bandit Problems"). Time is counted in
    credits of all strategies together, so a strategy that is not chosen loses weight; its mean
    stays.

    Parameters
    ----------
    gamma : float
        In (0, 1]; with 1 nothing is forgotten. About 1 / (1 - gamma) credits count.

    Attributes
    ----------
    gamma : float
    means : list of float
        The weighted mean of each strategy's credits; 0.0 if there is none.
    counts : list of float
        The sum of their weights.
    largest : float
        What no credit exceeds, or has exceeded so far.

    Raises
    ------
    TypeError, ValueError
        If `gamma` is no number in (0, 1].

    Examples
    --------
    >>> from divbandit.bandits import Discounted
    >>> discounted = Discounted(0.5)
    >>> discounted.begin(2, 6.0)
    >>> for part, credit in ((0, 6.0), (0, 3.0), (1, 5.0)):
    ...     discounted.add(part, credit)
    >>> discounted.means, discounted.counts
    ([4.0, 5.0], [0.75, 1.0])
    """

    def __init__(self, gamma: float) -> None:
        super().__init__()
        positive("gamma", gamma)
        self.gamma = real("gamma", gamma, low=0.0, high=1.0)
        self.means: list[float] = []
        self.counts: list[float] = []

    def begin(self, parts: int, largest: float) -> None:
        """Forget all."""
        super().begin(parts, largest)
        self.means = [0.0] * parts
        self.counts = [0.0] * parts

    def add(self, part: int, credit: float) -> None:
        """Let all weights fade, then add the newest credit with weight 1."""
        gamma = self.gamma
        counts = self.counts = [gamma * count for count in self.counts]
        # In this form a mean stays as it is while its weight fades, down to nothing at all.
        count = counts[part] + 1.0
        self.means[part] += (credit - self.means[part]) / count
        counts[part] = count
        if self._unbounded:
            self._widen(credit)

    def __repr__(self) -> str:
        return f"Discounted({self.gamma!r})"
