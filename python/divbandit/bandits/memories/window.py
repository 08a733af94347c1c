"""Window: the last credits of each strategy, as in the paper."""

from __future__ import annotations

from collections import deque
from typing import Any

from divbandit._checks import whole
from divbandit._core import ExactSum
from divbandit.bandits.memories.base import LONGEST, Remembering


class Window(Remembering):
    """The mean of the last `size` credits of each strategy, whenever it earned them.

    Benureau and Oudeyer 2015. What a strategy that is hardly ever chosen did long ago counts until
    it is chosen again; `RecentWindow` and `Discounted` forget with time.

    Parameters
    ----------
    size : int
        w, from 1 to a million.
    head_start : int
        How many fictitious credits, each the largest possible, come first in each window, from 0
        to `size`; `counts` counts them. They leave it when real ones have followed. Where credits
        have no bound they are 0.0.

    Attributes
    ----------
    size, head_start
        As given.
    means : list of float
        The mean of each window: its sum is exact before it is rounded once, depends on nothing
        but what is in the window, and never drifts. 0.0 for an empty one.
    counts : list of int
        How many credits are in each.
    largest : float
        What no credit exceeds, or has exceeded so far.

    Raises
    ------
    TypeError, ValueError
        If a number is not whole or out of range.

    Examples
    --------
    >>> from divbandit.bandits import Window
    >>> window = Window(3, head_start=1)
    >>> window.begin(2, 6.0)
    >>> for credit in (0.0, 3.0, 3.0):
    ...     window.add(0, credit)
    >>> window.means, window.counts
    ([2.0, 6.0], [3, 1])
    """

    def __init__(self, size: int = 50, *, head_start: int = 1) -> None:
        super().__init__()
        self.size = whole("size", size, low=1, high=LONGEST)
        self.head_start = whole("head_start", head_start, low=0, high=self.size)
        self._windows: list[deque[float]] = []
        self._sums: list[ExactSum] = []
        self._means: list[float] = []
        self._stale: set[int] = set()  # whose means are not those of their windows

    def begin(self, parts: int, largest: float) -> None:
        """Forget all but the head starts."""
        super().begin(parts, largest)
        first = [largest] * self.head_start
        self._windows = [deque(first, maxlen=self.size) for _ in range(parts)]
        self._sums = [ExactSum(first) for _ in range(parts)]
        self._means = [0.0] * parts
        self._stale = set(range(parts))

    def add(self, part: int, credit: float) -> None:
        """Add a strategy's newest credit; the oldest leaves a full window."""
        window = self._windows[part]
        if len(window) == self.size:
            self._sums[part].slide(credit, window[0])
        else:
            self._sums[part].add(credit)
        window.append(credit)
        self._stale.add(part)
        if self._unbounded:
            self._widen(credit)

    @property
    def means(self) -> list[float]:
        """The mean credit of each strategy."""
        if self._stale:
            for part in self._stale:
                count = len(self._windows[part])
                self._means[part] = self._sums[part].value() / count if count else 0.0
            self._stale.clear()
        return self._means

    @property
    def counts(self) -> list[int]:
        """How many credits each mean is of."""
        return [len(window) for window in self._windows]

    def __getstate__(self) -> dict[str, Any]:
        """Leave out the sums: they are made anew from the windows."""
        return {**self.__dict__, "_sums": []}

    def __setstate__(self, state: dict[str, Any]) -> None:
        self.__dict__.update(state)
        self._sums = [ExactSum(window) for window in self._windows]

    def __repr__(self) -> str:
        return f"Window({self.size!r}, head_start={self.head_start!r})"
