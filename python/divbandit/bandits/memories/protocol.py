"""Memory: what a bandit needs to know of that which it remembers credits by."""

from __future__ import annotations

from typing import TYPE_CHECKING, Protocol, runtime_checkable

if TYPE_CHECKING:
    from collections.abc import Sequence


@runtime_checkable
class Memory(Protocol):
    """The mean credit of each strategy, and how much experience it is of.

    Anything with these members is one; no base class is needed. A bandit is given one as a
    template; each exploration takes a deep copy, and begins it.

    Attributes
    ----------
    means : sequence of float
        The mean credit of each strategy, in order; 0.0 where none is remembered.
    counts : sequence of float
        Of how many credits each mean is, or of what weight all together. 0 for a strategy that is
        as good as never tried.
    largest : float
        What no credit exceeds. Where there is no such bound, the largest absolute credit so far.

    See Also
    --------
    Window, RecentWindow, Discounted, WholePast

    Examples
    --------
    A memory of one's own: the best credit that each strategy ever earned.

    >>> import divbandit as db
    >>> from divbandit.bandits import CoverageGain, Memory, Proportional
    >>> class Best:
    ...     means, counts, largest = (), (), 0.0
    ...     def begin(self, parts, largest):
    ...         self.means, self.counts = [0.0] * parts, [0] * parts
    ...         self.largest = largest
    ...     def add(self, part, credit):
    ...         self.means[part] = max(credit, self.means[part])
    ...         self.counts[part] += 1
    >>> isinstance(Best(), Memory)
    True
    >>> babblings = [db.MotorBabbling(), db.GoalBabbling(0.05)]
    >>> bandit = db.Bandit(babblings, credit=CoverageGain(), memory=Best(), rule=Proportional())
    >>> run = db.explore(db.PlanarArm(20), bandit, n=100, rng=0)
    >>> bool((run.diversities[1:] >= run.diversities[:-1]).all())
    True
    """

    @property
    def means(self) -> Sequence[float]:
        """The mean credit of each strategy."""

    @property
    def counts(self) -> Sequence[float]:
        """How many credits each mean is of."""

    @property
    def largest(self) -> float:
        """What no credit exceeds, or has exceeded so far."""

    def begin(self, parts: int, largest: float, /) -> None:
        """Forget all; there are so many strategies, and no credit exceeds `largest`.

        Parameters
        ----------
        parts : int
        largest : float
            0.0 where credits have no bound.

        Examples
        --------
        >>> import divbandit as db
        >>> memory = db.bandits.Window(3, head_start=1)
        >>> memory.begin(2, 6.0)
        >>> memory.means, memory.counts
        ([6.0, 6.0], [1, 1])
        """

    def add(self, part: int, credit: float, /) -> None:
        """Remember a credit of a strategy.

        Parameters
        ----------
        part : int
            Its index.
        credit : float

        Examples
        --------
        >>> import divbandit as db
        >>> memory = db.bandits.WholePast()
        >>> memory.begin(2, 6.0)
        >>> memory.add(1, 3.0)
        >>> memory.means, memory.counts
        ([0.0, 3.0], [0, 1])
        """
