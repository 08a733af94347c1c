"""Softmax: each strategy in proportion to the exponential of its mean credit."""

from __future__ import annotations

from typing import TYPE_CHECKING

from divbandit._checks import positive, truth
from divbandit._core import exp
from divbandit.strategies.composite import proportionally, total_of

if TYPE_CHECKING:
    from numpy.random import Generator

    from divbandit.bandits.memories.protocol import Memory


class Softmax:
    """Strategy j with probability proportional to exp(m_j / (temperature B)), of mean credit m_j.

    Boltzmann exploration (Sutton and Barto 2018, "Reinforcement Learning: An Introduction",
    section 2.8, with means in place of preferences). B is the largest credit, or, where credits
    have no bound, the largest absolute one so far; while there is none, all are equal. One draw a
    choice.

    Parameters
    ----------
    temperature : float
        Positive. The smaller, the more often the best is chosen.
    scaled : bool
        False makes B 1: `temperature` is then in the units of the credits.

    Attributes
    ----------
    temperature, scaled
        As given.

    Raises
    ------
    TypeError, ValueError
        If `temperature` is no positive number, or `scaled` neither True nor False.

    Examples
    --------
    >>> import numpy as np
    >>> from divbandit.bandits import Softmax, WholePast
    >>> memory = WholePast()
    >>> memory.begin(2, 6.0)
    >>> memory.add(1, 3.0)
    >>> index, probability = Softmax(0.5).choose(memory, np.random.default_rng(0))
    >>> index, round(probability, 6)  # 3 is half of 6: e / (1 + e)
    (1, 0.731059)
    """

    def __init__(self, temperature: float = 0.1, *, scaled: bool = True) -> None:
        self.temperature = positive("temperature", temperature)
        self.scaled = truth("scaled", scaled)

    def begin(self, parts: int, largest: float) -> None:
        """Nothing needs to be prepared."""

    def choose(self, memory: Memory, rng: Generator) -> tuple[int, float]:
        """Draw a strategy: one ``rng.random()``."""
        means = memory.means
        unit = memory.largest if self.scaled else 1.0
        if unit <= 0.0:
            weights = [1.0] * len(means)
        else:
            # Relative to the best, whose exponential is 1; what is too far below it is 0.
            top = max(means)
            weights = [_exp((mean - top) / unit / self.temperature) for mean in means]
        index = proportionally(weights, rng.random())
        return index, weights[index] / total_of(weights)

    def __repr__(self) -> str:
        scaled = "" if self.scaled else ", scaled=False"
        return f"Softmax({self.temperature!r}{scaled})"


def _exp(x: float) -> float:
    return exp(x) if x > -1e3 else 0.0
