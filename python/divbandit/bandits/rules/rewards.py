"""Rewards: credits as shares of the largest."""

from __future__ import annotations


class Rewards:
    """Turns credits into numbers in [0, 1].

    Examples
    --------
    >>> rewards = Rewards(4.0)
    >>> rewards.of(1.0), rewards.of(5.0), rewards.of(-1.0)
    (0.25, 1.0, 0.0)
    >>> rewards = Rewards(0.0)
    >>> rewards.of(0.0), rewards.of(1.0), rewards.of(0.5)
    (0.0, 1.0, 0.5)
    """

    __slots__ = ("_largest", "_unbounded")

    def __init__(self, largest: float) -> None:
        self._largest = largest
        self._unbounded = largest <= 0.0

    def of(self, credit: float) -> float:
        """Return a credit's share of the largest; if that is not known, of the largest so far."""
        if self._unbounded:
            self._largest = max(self._largest, abs(credit))
        if credit <= 0.0:
            return 0.0
        return min(1.0, credit / self._largest)
