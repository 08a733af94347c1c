"""Reward: what an effect is worth to the strategy that produced it."""

from __future__ import annotations

from typing import TYPE_CHECKING, Protocol, runtime_checkable

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

    from divbandit._core import Trial
    from divbandit.history import History


@runtime_checkable
class Reward(Protocol):
    """What an effect is worth to the strategy that produced it.

    Any object with these members will do; no base class is needed. Each exploration starts a deep
    copy of a user-defined reward, so that `start` may prepare the object and return itself.

    See Also
    --------
    Gain, CompetenceProgress, FunctionReward

    Examples
    --------
    A user-defined reward: how far an effect is from the one before it, at most 1.

    >>> import divbandit as db
    >>> from divbandit.bandits import Proportional, Reward, Window
    >>> class Leap:
    ...     def largest(self, dim):
    ...         return 1.0
    ...     def start(self, dim):
    ...         return self
    ...     def of(self, trial, effect, history):
    ...         if len(history) == 1:
    ...             return 0.0
    ...         return min(1.0, float(abs(effect - history.effects[-2]).max()))
    >>> isinstance(Leap(), Reward)
    True
    >>> babblings = [db.MotorBabbling(), db.GoalBabbling(0.05)]
    >>> bandit = db.Bandit(babblings, reward=Leap(), estimator=Window(50), policy=Proportional())
    >>> run = db.explore(db.PlanarArm(20), bandit, n=100, rng=0)
    >>> bool((run.estimates <= 1.0).all())
    True
    """

    def largest(self, dim: int, /) -> float:
        """Return the upper bound of the rewards; 0.0 if there is none.

        Parameters
        ----------
        dim : int
            Dimension of the effects; 2 where it is not known yet.

        Raises
        ------
        ValueError
            If effects of that dimension cannot be rewarded.

        Examples
        --------
        >>> import divbandit as db
        >>> db.bandits.Gain(db.measures.GridCoverage(0.5)).largest(2)
        1.0
        """

    def start(self, dim: int, /) -> RunningReward:
        """Return what rewards the effects of one exploration.

        Parameters
        ----------
        dim : int
            Dimension of the effects.

        Examples
        --------
        >>> import divbandit as db
        >>> reward = db.bandits.CompetenceProgress().start(2)
        """


@runtime_checkable
class RunningReward(Protocol):
    """A running reward.

    Its state should follow from the history alone: a nested bandit rewards its own trials only.

    Examples
    --------
    >>> import divbandit as db
    >>> history = db.History(db.Box([0], [1]))
    >>> history.append([0.5], [3.0, 4.0])
    >>> gain = db.bandits.Gain(db.measures.GridCoverage(1.0)).start(2)
    >>> gain.of(db.Trial([0.5]), history.effects[0], history)
    1.0
    """

    def of(self, trial: Trial, effect: NDArray[np.float64], history: History, /) -> float:
        """Return the reward of the newest effect.

        Parameters
        ----------
        trial : Trial
        effect : numpy.ndarray, shape (s,)
            The newest of the history, ``history.effects[-1]``.
        history : History

        Returns
        -------
        float
            Finite, and within 1e300 of 0.

        Examples
        --------
        >>> import divbandit as db
        >>> history = db.History(db.Box([0], [1]))
        >>> history.append([0.5], [3.0, 4.0])
        >>> progress = db.bandits.CompetenceProgress().start(2)
        >>> progress.of(db.Trial([0.5], goal=[3, 3]), history.effects[0], history)
        0.0
        """
