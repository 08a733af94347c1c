"""Estimator: what a bandit requires of an estimator of its strategies' rewards."""

from __future__ import annotations

from typing import TYPE_CHECKING, Protocol, runtime_checkable

if TYPE_CHECKING:
    from collections.abc import Sequence


@runtime_checkable
class Estimates(Protocol):
    """A running estimator: the mean reward of each strategy, and its weight.

    Attributes
    ----------
    means : sequence of float
        The mean reward of each strategy, in order; 0.0 where none is remembered.
    counts : sequence of float
        The number of rewards behind each mean, or their total weight; 0 for a strategy that counts
        as never tried.
    largest : float
        Upper bound of the rewards; where there is none, the largest absolute reward so far.

    Examples
    --------
    >>> from divbandit.bandits import Estimates, WholePast
    >>> estimates = WholePast().start(2, 6.0)
    >>> isinstance(estimates, Estimates)
    True
    >>> estimates.means, estimates.counts, estimates.largest
    ([0.0, 0.0], [0.0, 0.0], 6.0)
    """

    @property
    def means(self) -> Sequence[float]:
        """The mean reward of each strategy."""

    @property
    def counts(self) -> Sequence[float]:
        """The number of rewards behind each mean."""

    @property
    def largest(self) -> float:
        """Upper bound of the rewards, or of those so far."""

    def add(self, part: int, reward: float, /) -> None:
        """Remember a reward of a strategy.

        Parameters
        ----------
        part : int
            Its index.
        reward : float

        Examples
        --------
        >>> import divbandit as db
        >>> estimates = db.bandits.WholePast().start(2, 6.0)
        >>> estimates.add(1, 3.0)
        >>> estimates.means, estimates.counts
        ([0.0, 3.0], [0.0, 1.0])
        """


@runtime_checkable
class Estimator(Protocol):
    """How the mean rewards of strategies are estimated.

    Any object with a method `start` will do; no base class is needed. Each exploration starts a
    deep copy, so `start` may prepare the object itself and return it.

    See Also
    --------
    Window, RecentWindow, Discounted, WholePast

    Examples
    --------
    A new estimator: the best reward that each strategy ever earned.

    >>> import divbandit as db
    >>> from divbandit.bandits import Estimator, Proportional
    >>> class Best:
    ...     def start(self, parts, largest):
    ...         self.means, self.counts, self.largest = [0.0] * parts, [0] * parts, largest
    ...         return self
    ...     def add(self, part, reward):
    ...         self.means[part] = max(reward, self.means[part])
    ...         self.counts[part] += 1
    >>> isinstance(Best(), Estimator)
    True
    >>> babblings = [db.MotorBabbling(), db.GoalBabbling(0.05)]
    >>> bandit = db.Bandit(babblings, tau=0.02, estimator=Best(), policy=Proportional())
    >>> run = db.explore(db.PlanarArm(20), bandit, n=100, rng=0)
    >>> bool((run.estimates[1:] >= run.estimates[:-1]).all())
    True
    """

    def start(self, parts: int, largest: float, /) -> Estimates:
        """Return a running estimator that has no rewards yet.

        Called again if the dimension of the first effect leads to another `largest`.

        Parameters
        ----------
        parts : int
            How many strategies there are.
        largest : float
            Upper bound of the rewards; 0.0 if there is none.

        Returns
        -------
        Estimates

        Examples
        --------
        >>> import divbandit as db
        >>> estimates = db.bandits.Window(3, head_start=1).start(2, 6.0)
        >>> estimates.means, estimates.counts
        ([6.0, 6.0], [1.0, 1.0])
        """
