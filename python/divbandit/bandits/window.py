"""GainWindow: the mean of a strategy's last gains."""

from __future__ import annotations

from collections import deque
from math import fsum


class GainWindow:
    """The gains of the last `size` effects that a strategy produced.

    A head start of `count` fictitious gains comes first. The oldest gains leave a full window, so
    that of one fictitious gain nothing is left when `size` real ones have followed.

    Examples
    --------
    >>> window = GainWindow(3, head_start=6.0, count=1)
    >>> window.mean()
    6.0
    >>> for gain in (0.0, 3.0, 3.0):
    ...     window.add(gain)
    >>> window.mean()
    2.0
    """

    __slots__ = ("_gains",)

    def __init__(self, size: int, *, head_start: float, count: int) -> None:
        self._gains = deque([head_start] * count, maxlen=size)

    def add(self, gain: float) -> None:
        """Add the newest gain; the oldest leaves a full window."""
        self._gains.append(gain)

    def mean(self) -> float:
        """Return the mean gain, the strategy's diversity; 0 for an empty window.

        The sum is exact before it is rounded once: it depends on nothing but the gains, and
        never drifts.
        """
        return fsum(self._gains) / len(self._gains) if self._gains else 0.0
