"""Credit: what a bandit needs to know of that which it rewards its strategies for."""

from __future__ import annotations

from typing import TYPE_CHECKING, Protocol, runtime_checkable

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

    from divbandit.history import History
    from divbandit.strategies.base import Trial


@runtime_checkable
class Credit(Protocol):
    """What an effect is worth to the strategy that produced it.

    Anything with these members is one; no base class is needed. A bandit is given one as a
    template, of which each exploration takes a deep copy.

    What is remembered from one effect to the next should follow from the history alone: a nested
    bandit is told of its own trials only, and a trial may be told long after others that were
    asked for later.

    A credit may also have ``of_many(trials, effects, history) -> list[float]``, the very numbers
    that as many calls of `of` return, each in between what the history then holds. Then a bandit
    can be told of many effects at once.

    See Also
    --------
    CoverageGain, Gain, CompetenceProgress, FunctionCredit

    Examples
    --------
    A credit of one's own: how far an effect is from the one before it, at most 1.

    >>> import divbandit as db
    >>> from divbandit.bandits import Credit, Proportional, Window
    >>> class Leap:
    ...     def largest(self, dim):
    ...         return 1.0
    ...     def of(self, trial, effect, history):
    ...         if trial.place == 0:
    ...             return 0.0
    ...         before = history.effects[trial.place - 1]
    ...         return min(1.0, float(abs(effect - before).max()))
    >>> isinstance(Leap(), Credit)
    True
    >>> babblings = [db.MotorBabbling(), db.GoalBabbling(0.05)]
    >>> bandit = db.Bandit(babblings, credit=Leap(), memory=Window(50), rule=Proportional())
    >>> run = db.explore(db.PlanarArm(20), bandit, n=100, rng=0)
    >>> bool((run.diversities <= 1.0).all())
    True
    """

    def largest(self, dim: int, /) -> float:
        """Return what no credit exceeds; 0.0 where there is no such bound.

        Parameters
        ----------
        dim : int
            Dimension of the effects; 2 where it is not known yet.

        Raises
        ------
        ValueError
            If effects of that dimension cannot be credited.

        Examples
        --------
        >>> import divbandit as db
        >>> round(db.bandits.CoverageGain(0.5).largest(2), 6)
        0.785398
        """

    def of(self, trial: Trial, effect: NDArray[np.float64], history: History, /) -> float:
        """Return the credit of an effect.

        Parameters
        ----------
        trial : Trial
            ``trial.place`` is the effect's row in the history.
        effect : numpy.ndarray, shape (s,)
        history : History
            ``history.effects[:trial.place]`` were known before.

        Returns
        -------
        float
            Finite, and within 1e300 of 0.

        Examples
        --------
        >>> import numpy as np
        >>> import divbandit as db
        >>> history = db.History(db.Box([0], [1]))
        >>> history.append([0.5], [3.0, 4.0])
        >>> trial = db.Trial([0.5])
        >>> trial.place = 0
        >>> db.bandits.Gain(db.GridCoverage(1.0)).of(trial, history.effects[0], history)
        1.0
        """
