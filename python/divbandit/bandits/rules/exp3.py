"""Exp3: weights that grow exponentially with credits, whatever these come from."""

from __future__ import annotations

from typing import TYPE_CHECKING

from divbandit._checks import positive, real
from divbandit._core import exp
from divbandit.bandits.rules.rewards import Rewards
from divbandit.strategies.composite import proportionally, total_of

if TYPE_CHECKING:
    from numpy.random import Generator

    from divbandit.bandits.memories.protocol import Memory


class Exp3:
    """Strategy j of K with probability p_j = (1 - gamma) w_j / (sum of w) + gamma / K.

    Auer, Cesa-Bianchi, Freund and Schapire (2002, "The Nonstochastic Multiarmed Bandit Problem",
    SIAM Journal on Computing 32(1), 48-77, figure 1). A strategy that earned x, when it had been
    chosen with probability p, has its weight multiplied by exp(gamma (x / p) / K). x is the credit
    as a share of the largest, within [0, 1]; where credits have no bound, of the largest absolute
    one so far. The bandit's memory is for others to look at: this rule keeps weights of its own,
    and no head start counts. One draw a choice.

    Parameters
    ----------
    gamma : float
        In (0, 1].

    Attributes
    ----------
    gamma : float

    Raises
    ------
    TypeError, ValueError
        If `gamma` is no number in (0, 1].

    Examples
    --------
    >>> from divbandit.bandits import Exp3
    >>> rule = Exp3(0.5)
    >>> rule.begin(2, 6.0)
    >>> rule.probabilities()
    [0.5, 0.5]
    >>> rule.learn(1, 3.0, 0.5)  # exp(0.5 (0.5 / 0.5) / 2) = 1.284
    >>> [round(p, 6) for p in rule.probabilities()]
    [0.468912, 0.531088]
    """

    def __init__(self, gamma: float = 0.1) -> None:
        positive("gamma", gamma)
        self.gamma = real("gamma", gamma, low=0.0, high=1.0)
        self._rewards = Rewards(0.0)
        # Logarithms of the weights, the largest 0: nothing overflows, and what has become too small
        # to be drawn can still come back.
        self._logs: list[float] = []
        self._probabilities: list[float] | None = None

    def begin(self, parts: int, largest: float) -> None:
        """Give all strategies equal weights."""
        self._rewards = Rewards(largest)
        self._logs = [0.0] * parts
        self._probabilities = None

    def probabilities(self) -> list[float]:
        """Return the probability of each strategy to be chosen next.

        Examples
        --------
        >>> from divbandit.bandits import Exp3
        >>> rule = Exp3(0.5)
        >>> rule.begin(4, 1.0)
        >>> rule.probabilities()
        [0.25, 0.25, 0.25, 0.25]
        """
        if self._probabilities is None:
            weights = [exp(x) for x in self._logs]
            total, equal = total_of(weights), self.gamma / len(weights)
            self._probabilities = [(1.0 - self.gamma) * w / total + equal for w in weights]
        return list(self._probabilities)

    def choose(self, memory: Memory, rng: Generator) -> tuple[int, float]:
        """Draw a strategy: one ``rng.random()``."""
        del memory
        probabilities = self.probabilities()
        index = proportionally(probabilities, rng.random())
        return index, min(1.0, probabilities[index])

    def learn(self, part: int, credit: float, probability: float | None) -> None:
        """Let the weight of a strategy grow by what it earned, for how seldom it was chosen.

        Examples
        --------
        >>> from divbandit.bandits import Exp3
        >>> rule = Exp3(1.0)
        >>> rule.begin(2, 1.0)
        >>> rule.learn(0, 1.0, None)
        >>> rule.probabilities()
        [0.5, 0.5]
        """
        chosen = self.probabilities()[part] if probability is None else probability
        logs, reward = self._logs, self._rewards.of(credit)
        logs[part] += self.gamma * (reward / chosen) / len(logs)
        top = max(logs)
        self._logs = [x - top for x in logs]
        self._probabilities = None

    def __repr__(self) -> str:
        return f"Exp3({self.gamma!r})"
