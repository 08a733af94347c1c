"""Proportional: each strategy in proportion to its mean credit, as in the paper."""

from __future__ import annotations

from typing import TYPE_CHECKING

from divbandit._checks import real
from divbandit._core import power as power_of

if TYPE_CHECKING:
    from collections.abc import Sequence

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
        # What the last choice was made by; while nothing is told, the next ones are as well.
        self._means: list[float] = []
        self._weights: list[float] = []
        self._total = 0.0

    def begin(self, parts: int, largest: float) -> None:
        """Forget the last choice."""
        del parts, largest
        self._means = []

    def choose(self, memory: Memory, rng: Generator) -> tuple[int, float]:
        """Draw a strategy: two ``rng.random()``."""
        alpha = self.alpha
        uniformly = rng.random() < alpha
        u = rng.random()
        means = memory.means
        if means != self._means:
            self._weigh(means)
        weights, total = self._weights, self._total
        count = len(weights)
        if total <= 0.0:
            return int(u * count), 1.0 / count
        if uniformly:
            index = int(u * count)
        else:
            left = u * total
            index = last = 0
            for weight in weights:
                if left < weight:
                    break
                left -= weight
                if weight > 0.0:
                    last = index
                index += 1
            else:
                index = last  # rounding carried u past the end
        probability = alpha / count + (1.0 - alpha) * weights[index] / total
        return index, probability if probability < 1.0 else 1.0  # noqa: FURB136 - a step's time

    def _weigh(self, means: Sequence[float]) -> None:
        """Take note of what each strategy weighs."""
        self._means = [*means]
        weights = [mean if mean > 0.0 else 0.0 for mean in means]  # noqa: FURB136 - a step's time
        if self.power != 1.0:
            # Powers of shares of the largest: none overflows, and not all vanish.
            top = max(weights)
            weights = [power_of(w / top, self.power) if w > 0.0 else 0.0 for w in weights]
        total = 0.0
        for weight in weights:
            total += weight
        self._weights, self._total = weights, total

    def __repr__(self) -> str:
        power = "" if self.power == 1.0 else f", power={self.power!r}"
        return f"Proportional({self.alpha!r}{power})"
