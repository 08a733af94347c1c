"""RecentWindow: the last credits of all strategies together."""

from __future__ import annotations

from collections import deque
from typing import Any

from divbandit._checks import whole
from divbandit._core import ExactSum
from divbandit.bandits.memories.base import LONGEST, Remembering


class RecentWindow(Remembering):
    """The mean of each strategy's credits among the last `size` credits of all of them.

    The memory of SW-UCB (Garivier and Moulines 2008, "On Upper-Confidence Bound Policies for
    Non-Stationary Bandit Problems"; 2011, ALT, 174-188). A strategy that was not chosen for `size`
    steps is as good as never tried.

    Parameters
    ----------
    size : int
        How many credits, from 1 to a million.

    Attributes
    ----------
    size : int
    means : list of float
        The mean of each strategy's credits in the window, exact before it is rounded once; 0.0 if
        there is none.
    counts : list of int
        How many of the credits in the window are each strategy's.
    largest : float
        What no credit exceeds, or has exceeded so far.

    Raises
    ------
    TypeError, ValueError
        If `size` is not whole or out of range.

    Examples
    --------
    >>> from divbandit.bandits import RecentWindow
    >>> recent = RecentWindow(3)
    >>> recent.begin(2, 6.0)
    >>> for part, credit in ((0, 6.0), (0, 2.0), (1, 5.0), (0, 3.0)):
    ...     recent.add(part, credit)
    >>> recent.means, recent.counts
    ([2.5, 5.0], [2, 1])
    """

    def __init__(self, size: int) -> None:
        super().__init__()
        self.size = whole("size", size, low=1, high=LONGEST)
        self._owners: deque[int] = deque()
        self._credits: list[deque[float]] = []
        self._sums: list[ExactSum] = []
        self._means: list[float] = []
        self._stale: set[int] = set()

    def begin(self, parts: int, largest: float) -> None:
        """Forget all."""
        super().begin(parts, largest)
        self._owners = deque()
        self._credits = [deque() for _ in range(parts)]
        self._sums = [ExactSum([]) for _ in range(parts)]
        self._means = [0.0] * parts
        self._stale = set()

    def add(self, part: int, credit: float) -> None:
        """Add the newest credit; the oldest of all leaves a full window."""
        if len(self._owners) == self.size:
            oldest = self._owners.popleft()
            self._sums[oldest].subtract(self._credits[oldest].popleft())
            self._stale.add(oldest)
        self._owners.append(part)
        self._credits[part].append(credit)
        self._sums[part].add(credit)
        self._stale.add(part)
        if self._unbounded:
            self._widen(credit)

    @property
    def means(self) -> list[float]:
        """The mean credit of each strategy."""
        for part in self._stale:
            count = len(self._credits[part])
            self._means[part] = self._sums[part].value() / count if count else 0.0
        self._stale.clear()
        return self._means

    @property
    def counts(self) -> list[int]:
        """How many credits each mean is of."""
        return [len(own) for own in self._credits]

    def __getstate__(self) -> dict[str, Any]:
        """Leave out the sums: they are made anew from the credits."""
        return {**self.__dict__, "_sums": []}

    def __setstate__(self, state: dict[str, Any]) -> None:
        self.__dict__.update(state)
        self._sums = [ExactSum(own) for own in self._credits]

    def __repr__(self) -> str:
        return f"RecentWindow({self.size!r})"
