"""Exp3S: Exp3 that follows when another strategy becomes the best."""

from __future__ import annotations

from math import e
from typing import TYPE_CHECKING

from divbandit._checks import positive, real
from divbandit._core import exp
from divbandit.bandits.rules.rewards import Rewards
from divbandit.strategies.composite import proportionally, total_of

if TYPE_CHECKING:
    from numpy.random import Generator

    from divbandit.bandits.memories.protocol import Memory


class Exp3S:
    """Exp3.S: as Exp3, but no weight falls far behind.

    Auer, Cesa-Bianchi, Freund and Schapire (2002, "The Nonstochastic Multiarmed Bandit Problem",
    SIAM Journal on Computing 32(1), 48-77, figure 4). With K strategies, strategy j is chosen with
    probability p_j = (1 - gamma) w_j / (sum of w) + gamma / K. Whenever one that had been chosen
    with probability p has earned x, its weight is multiplied by exp(gamma (x / p) / K), and then
    all weights grow by e alpha / K times the sum of those before. x is the credit as a share of
    the largest, within [0, 1]; where credits have no bound, of the largest absolute one so far.
    One draw a choice.

    Parameters
    ----------
    gamma : float
        In (0, 1].
    alpha : float
        How fast the past is forgotten, in (0, 1]; about one over the number of choices.

    Attributes
    ----------
    gamma, alpha
        As given.

    Raises
    ------
    TypeError, ValueError
        If `gamma` or `alpha` is no number in (0, 1].

    Examples
    --------
    >>> from divbandit.bandits import Exp3S
    >>> rule = Exp3S(0.5, 0.01)
    >>> rule.begin(2, 6.0)
    >>> rule.learn(1, 3.0, 0.5)
    >>> [round(p, 6) for p in rule.probabilities()]
    [0.469635, 0.530365]
    """

    def __init__(self, gamma: float = 0.1, alpha: float = 0.001) -> None:
        for name, value in (("gamma", gamma), ("alpha", alpha)):
            positive(name, value)
        self.gamma = real("gamma", gamma, low=0.0, high=1.0)
        self.alpha = real("alpha", alpha, low=0.0, high=1.0)
        self._rewards = Rewards(0.0)
        # Their sum is 1 but for rounding: none overflows, and the share alpha keeps all above 0.
        self._weights: list[float] = []

    def begin(self, parts: int, largest: float) -> None:
        """Give all strategies equal weights."""
        self._rewards = Rewards(largest)
        self._weights = [1.0 / parts] * parts

    def probabilities(self) -> list[float]:
        """Return the probability of each strategy to be chosen next.

        Examples
        --------
        >>> from divbandit.bandits import Exp3S
        >>> rule = Exp3S(0.5, 0.01)
        >>> rule.begin(4, 1.0)
        >>> rule.probabilities()
        [0.25, 0.25, 0.25, 0.25]
        """
        weights = self._weights
        total, equal = total_of(weights), self.gamma / len(weights)
        return [(1.0 - self.gamma) * weight / total + equal for weight in weights]

    def choose(self, memory: Memory, rng: Generator) -> tuple[int, float]:
        """Draw a strategy: one ``rng.random()``."""
        del memory
        probabilities = self.probabilities()
        index = proportionally(probabilities, rng.random())
        return index, min(1.0, probabilities[index])

    def learn(self, part: int, credit: float, probability: float | None) -> None:
        """Let the weight of a strategy grow by what it earned, and all by a share of the sum.

        Examples
        --------
        >>> from divbandit.bandits import Exp3S
        >>> rule = Exp3S(1.0, 0.1)
        >>> rule.begin(2, 1.0)
        >>> rule.learn(0, 1.0, None)
        >>> rule.probabilities()
        [0.5, 0.5]
        """
        chosen = self.probabilities()[part] if probability is None else probability
        weights, reward = self._weights, self._rewards.of(credit)
        share = e * self.alpha / len(weights) * total_of(weights)
        weights[part] *= exp(min(700.0, self.gamma * (reward / chosen) / len(weights)))
        grown = [weight + share for weight in weights]
        total = total_of(grown)
        self._weights = [weight / total for weight in grown]

    def __repr__(self) -> str:
        return f"Exp3S({self.gamma!r}, {self.alpha!r})"
