"""RoundRobin: one strategy after another."""

from __future__ import annotations

from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from numpy.random import Generator

    from divbandit.bandits.memories.protocol import Memory


class RoundRobin:
    """Each strategy in turn, whatever it earned: what the other rules must beat. No draws.

    Examples
    --------
    >>> import numpy as np
    >>> from divbandit.bandits import RoundRobin, WholePast
    >>> memory, rule, rng = WholePast(), RoundRobin(), np.random.default_rng(0)
    >>> rule.begin(2, 6.0)
    >>> [rule.choose(memory, rng)[0] for _ in range(5)]
    [0, 1, 0, 1, 0]
    """

    def __init__(self) -> None:
        self._parts = 1
        self._next = 0

    def begin(self, parts: int, largest: float) -> None:
        """Begin with the first."""
        del largest
        self._parts = parts
        self._next = 0

    def choose(self, memory: Memory, rng: Generator) -> tuple[int, float]:
        """Return whose turn it is; nothing is drawn."""
        del memory, rng
        index = self._next
        self._next = (index + 1) % self._parts
        return index, 1.0

    def __repr__(self) -> str:
        return "RoundRobin()"
