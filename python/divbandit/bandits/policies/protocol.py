"""Policy: what a bandit requires of a policy."""

from __future__ import annotations

from typing import TYPE_CHECKING, Protocol, runtime_checkable

if TYPE_CHECKING:
    from numpy.random import Generator

    from divbandit.bandits.estimators.protocol import Estimates


@runtime_checkable
class RunningPolicy(Protocol):
    """A running policy, which chooses the strategy that proposes next.

    A policy that learns by itself also has ``learn(part, reward, probability)``, which is called
    for each reward, after the estimator's `add`, with the probability with which `choose` chose
    that trial's strategy (None if not given). Trials may be told late and in any order; a failed
    one has reward 0.

    Examples
    --------
    >>> from divbandit.bandits import RoundRobin, RunningPolicy
    >>> isinstance(RoundRobin().start(3, 6.0), RunningPolicy)
    True
    """

    def choose(self, estimates: Estimates, rng: Generator, /) -> int | tuple[int, float | None]:
        """Return the index of the strategy that proposes next.

        Parameters
        ----------
        estimates : Estimates
            The mean reward of each strategy, and its weight.
        rng : numpy.random.Generator
            The only source of randomness to use, by ``rng.random()``.

        Returns
        -------
        int, or a pair (int, float)
            The index, and the probability with which it was chosen if the policy knows it.

        Examples
        --------
        >>> import numpy as np
        >>> import divbandit as db
        >>> estimates = db.bandits.WholePast().start(2, 6.0)
        >>> estimates.add(1, 3.0)
        >>> policy = db.bandits.Proportional(alpha=0.5).start(2, 6.0)
        >>> policy.choose(estimates, np.random.default_rng(0))
        (1, 0.75)
        """


@runtime_checkable
class Policy(Protocol):
    """How the strategy that proposes next is chosen.

    Any object with a method `start` will do; no base class is needed. Each exploration starts a
    deep copy, so `start` may prepare the object itself and return it.

    See Also
    --------
    Proportional, EpsilonGreedy, Softmax, UCB, Thompson, Exp3, Exp3S, RoundRobin, Uniform

    Examples
    --------
    A new policy: of two strategies at random the one with the better mean.

    >>> import divbandit as db
    >>> from divbandit.bandits import Policy, Window
    >>> class Tournament:
    ...     def start(self, parts, largest):
    ...         self.parts = parts
    ...         return self
    ...     def choose(self, estimates, rng):
    ...         pair = [int(rng.random() * self.parts) for _ in range(2)]
    ...         return max(pair, key=lambda part: estimates.means[part])
    >>> isinstance(Tournament(), Policy)
    True
    >>> babblings = [db.GoalBabbling(d) for d in (0.01, 0.05, 0.5)]
    >>> bandit = db.Bandit(babblings, tau=0.02, estimator=Window(50), policy=Tournament())
    >>> len(db.explore(db.PlanarArm(20), bandit, n=100, rng=0))
    100
    """

    def start(self, parts: int, largest: float, /) -> RunningPolicy:
        """Return a running policy that has learned nothing yet.

        Called again if the dimension of the first effect leads to another `largest`.

        Parameters
        ----------
        parts : int
            How many strategies there are.
        largest : float
            Upper bound of the rewards; 0.0 if there is none.

        Returns
        -------
        RunningPolicy

        Examples
        --------
        >>> import numpy as np
        >>> import divbandit as db
        >>> estimates = db.bandits.Window(50).start(3, 6.0)
        >>> policy = db.bandits.Uniform().start(3, 6.0)
        >>> policy.choose(estimates, np.random.default_rng(0))
        (1, 0.3333333333333333)
        """
