"""EpsilonGreedy: the strategy with the best mean credit, but for a share of random choices."""

from __future__ import annotations

from typing import TYPE_CHECKING

from divbandit._checks import real
from divbandit.bandits.rules.ties import best

if TYPE_CHECKING:
    from numpy.random import Generator

    from divbandit.bandits.memories.protocol import Memory


class EpsilonGreedy:
    """With probability epsilon uniformly at random, else the best mean credit.

    Sutton and Barto (2018, "Reinforcement Learning: An Introduction", section 2.2). Of several
    best ones each is as likely. Two draws a choice, always.

    Parameters
    ----------
    epsilon : float
        In [0, 1].

    Attributes
    ----------
    epsilon : float

    Raises
    ------
    TypeError, ValueError
        If `epsilon` is no number in [0, 1].

    Examples
    --------
    >>> import numpy as np
    >>> from divbandit.bandits import EpsilonGreedy, WholePast
    >>> memory = WholePast()
    >>> memory.begin(2, 6.0)
    >>> memory.add(1, 3.0)
    >>> EpsilonGreedy(0.5).choose(memory, np.random.default_rng(0))
    (1, 0.75)
    """

    def __init__(self, epsilon: float = 0.1) -> None:
        self.epsilon = real("epsilon", epsilon, low=0.0, high=1.0)

    def begin(self, parts: int, largest: float) -> None:
        """Nothing needs to be prepared."""

    def choose(self, memory: Memory, rng: Generator) -> tuple[int, float]:
        """Draw a strategy: two ``rng.random()``."""
        means = memory.means
        uniformly = rng.random() < self.epsilon
        u = rng.random()
        ties = best(means)
        index = int(u * len(means)) if uniformly else ties[int(u * len(ties))]
        probability = self.epsilon / len(means)
        if index in ties:
            probability += (1.0 - self.epsilon) / len(ties)
        return index, min(1.0, probability)

    def __repr__(self) -> str:
        return f"EpsilonGreedy({self.epsilon!r})"
