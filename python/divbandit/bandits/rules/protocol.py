"""Rule: what a bandit needs to know of that which it chooses by."""

from __future__ import annotations

from typing import TYPE_CHECKING, Protocol, runtime_checkable

if TYPE_CHECKING:
    from numpy.random import Generator

    from divbandit.bandits.memories.protocol import Memory


@runtime_checkable
class Rule(Protocol):
    """Which strategy is to propose next.

    Anything with these members is one; no base class is needed. A bandit is given one as a
    template; each exploration takes a deep copy, and begins it.

    A rule that learns by itself has ``learn(part, credit, probability)`` as well: it is called for
    each credit, after the memory's `add`, with the probability with which `choose` had chosen that
    trial's strategy (None if it did not say). Trials may be told late and in any order; one that
    failed has credit 0.

    See Also
    --------
    Proportional, EpsilonGreedy, Softmax, UCB, Thompson, Exp3, Exp3S, RoundRobin, Uniform

    Examples
    --------
    A rule of one's own: of two strategies at random the one with the better mean.

    >>> import divbandit as db
    >>> from divbandit.bandits import CoverageGain, Rule, Window
    >>> class Tournament:
    ...     def begin(self, parts, largest):
    ...         self.parts = parts
    ...     def choose(self, memory, rng):
    ...         pair = [int(rng.random() * self.parts) for _ in range(2)]
    ...         return max(pair, key=lambda part: memory.means[part])
    >>> isinstance(Tournament(), Rule)
    True
    >>> babblings = [db.GoalBabbling(d) for d in (0.01, 0.05, 0.5)]
    >>> bandit = db.Bandit(babblings, credit=CoverageGain(), memory=Window(50), rule=Tournament())
    >>> len(db.explore(db.PlanarArm(20), bandit, n=100, rng=0))
    100
    """

    def begin(self, parts: int, largest: float, /) -> None:
        """Forget all; there are so many strategies, and no credit exceeds `largest`.

        Called again should the first effect, by its dimension, tell of another `largest`.

        Parameters
        ----------
        parts : int
        largest : float
            0.0 where credits have no bound.

        Examples
        --------
        >>> import divbandit as db
        >>> db.bandits.RoundRobin().begin(3, 6.0)
        """

    def choose(self, memory: Memory, rng: Generator, /) -> int | tuple[int, float | None]:
        """Return the index of the strategy that is to propose next.

        Parameters
        ----------
        memory : Memory
        rng : numpy.random.Generator
            The only source of randomness to use, by ``rng.random()``.

        Returns
        -------
        int, or a pair (int, float)
            With the probability with which it was chosen, where the rule knows it.

        Examples
        --------
        >>> import numpy as np
        >>> import divbandit as db
        >>> memory = db.bandits.WholePast()
        >>> memory.begin(2, 6.0)
        >>> memory.add(1, 3.0)
        >>> rule = db.bandits.Proportional(alpha=0.5)
        >>> rule.begin(2, 6.0)
        >>> rule.choose(memory, np.random.default_rng(0))
        (1, 0.75)
        """
