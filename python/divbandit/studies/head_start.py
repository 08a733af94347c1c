"""HeadStart: a memory that begins with the largest credit for each strategy."""

from __future__ import annotations

from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from collections.abc import Sequence

    from divbandit.bandits import Memory


class HeadStart:
    """Another memory, told of one credit for each strategy before all others: the largest.

    So every strategy is tried soon, as with the head start of `Window`; real credits then take the
    fictitious one's place, as fast as the memory forgets.

    Parameters
    ----------
    memory : Memory
        For instance ``Discounted(0.99)``.

    Attributes
    ----------
    memory : Memory
    means, counts, largest
        Those of the memory.

    Examples
    --------
    >>> from divbandit.bandits import Discounted
    >>> memory = HeadStart(Discounted(0.5))
    >>> memory.begin(2, 4.0)
    >>> memory.add(1, 1.0)
    >>> memory.means, memory.counts
    ([4.0, 2.0], [0.25, 1.5])
    """

    def __init__(self, memory: Memory) -> None:
        self.memory = memory

    def begin(self, parts: int, largest: float) -> None:
        """Forget all but the head starts."""
        self.memory.begin(parts, largest)
        for part in range(parts):
            self.memory.add(part, largest)

    def add(self, part: int, credit: float) -> None:
        """Add a strategy's newest credit."""
        self.memory.add(part, credit)

    @property
    def means(self) -> Sequence[float]:
        """The mean credit of each strategy."""
        return self.memory.means

    @property
    def counts(self) -> Sequence[float]:
        """How many credits each mean is of."""
        return self.memory.counts

    @property
    def largest(self) -> float:
        """What no credit exceeds."""
        return self.memory.largest

    def __repr__(self) -> str:
        return f"HeadStart({self.memory!r})"
