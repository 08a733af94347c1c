"""WholePast: all credits alike."""

from __future__ import annotations

from divbandit.bandits.memories.base import Remembering


class WholePast(Remembering):
    """The mean of all credits that each strategy ever earned.

    For where strategies stay as good as they are. Gains of new effects shrink as an exploration
    goes on; there the other memories do better.

    Attributes
    ----------
    means : list of float
        The mean of each strategy's credits; 0.0 if there is none.
    counts : list of int
        How many there are.
    largest : float
        What no credit exceeds, or has exceeded so far.

    Examples
    --------
    >>> from divbandit.bandits import WholePast
    >>> past = WholePast()
    >>> past.begin(2, 6.0)
    >>> for credit in (0.0, 3.0, 3.0):
    ...     past.add(0, credit)
    >>> past.means, past.counts
    ([2.0, 0.0], [3, 0])
    """

    def __init__(self) -> None:
        super().__init__()
        self.means: list[float] = []
        self.counts: list[int] = []
        # Sums and what their rounding lost (Neumaier), so that a million credits do not drift.
        self._sums: list[tuple[float, float]] = []

    def begin(self, parts: int, largest: float) -> None:
        """Forget all."""
        super().begin(parts, largest)
        self.means = [0.0] * parts
        self.counts = [0] * parts
        self._sums = [(0.0, 0.0)] * parts

    def add(self, part: int, credit: float) -> None:
        """Add a credit."""
        before, lost = self._sums[part]
        total = before + credit
        if abs(before) >= abs(credit):
            lost += (before - total) + credit
        else:
            lost += (credit - total) + before
        self._sums[part] = total, lost
        self.counts[part] += 1
        self.means[part] = (total + lost) / self.counts[part]
        if self._unbounded:
            self._widen(credit)

    def __repr__(self) -> str:
        return "WholePast()"
