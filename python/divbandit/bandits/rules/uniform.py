"""Uniform: any strategy, each as likely."""

from __future__ import annotations

from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from numpy.random import Generator

    from divbandit.bandits.memories.protocol import Memory


class Uniform:
    """A strategy uniformly at random, whatever it earned. One draw a choice.

    Examples
    --------
    >>> import numpy as np
    >>> from divbandit.bandits import Uniform, WholePast
    >>> memory, rule, rng = WholePast(), Uniform(), np.random.default_rng(0)
    >>> rule.begin(2, 6.0)
    >>> rule.choose(memory, rng)
    (1, 0.5)
    """

    def __init__(self) -> None:
        self._parts = 1

    def begin(self, parts: int, largest: float) -> None:
        """Take note of how many there are."""
        del largest
        self._parts = parts

    def choose(self, memory: Memory, rng: Generator) -> tuple[int, float]:
        """Draw a strategy: one ``rng.random()``."""
        del memory
        return int(rng.random() * self._parts), 1.0 / self._parts

    def __repr__(self) -> str:
        return "Uniform()"
