"""Remembering: what the memories share, the size of credits."""

from __future__ import annotations

#: The longest window: its credits are kept one by one.
LONGEST = 1_000_000


class Remembering:
    """A memory that knows how large credits can be, or have been.

    Examples
    --------
    >>> memory = Remembering()
    >>> memory.begin(2, 0.0)
    >>> memory.largest
    0.0
    """

    def __init__(self) -> None:
        self.largest = 0.0
        self._unbounded = True
        self._parts = 0

    def begin(self, parts: int, largest: float) -> None:
        """Forget all; there are so many strategies, and no credit exceeds `largest`, if not 0.

        Examples
        --------
        >>> from divbandit.bandits.memories.base import Remembering
        >>> memory = Remembering()
        >>> memory.begin(2, 6.0)
        >>> memory.largest
        6.0
        """
        self.largest = largest
        self._unbounded = largest <= 0.0
        self._parts = parts

    def _widen(self, credit: float) -> None:
        """Take note of an unbounded credit's size."""
        self.largest = max(self.largest, abs(credit))
