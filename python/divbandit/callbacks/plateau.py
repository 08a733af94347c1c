"""Plateau: stop a run that finds little that is new."""

from __future__ import annotations

from collections import deque
from dataclasses import dataclass
from typing import TYPE_CHECKING

from divbandit._checks import real, whole
from divbandit._value import Value
from divbandit.callbacks.diversity import Diversity, measure_for, tau_or_measure

if TYPE_CHECKING:
    from divbandit._core import Trial
    from divbandit.callbacks.protocol import RunningCallback
    from divbandit.exploration import Explorer
    from divbandit.measures import Measure


@dataclass(frozen=True, init=False, repr=False)
class Plateau(Value):
    """Stops a run when the last evaluations added little to the diversity.

    That is when the last `trials` evaluations of the run, failed ones included, have added less
    than `share` of the diversity reached so far, or nothing at all. Effects that were known before
    the run are part of what is reached.

    Parameters
    ----------
    trials : int
        How many evaluations, at least 1. A run never stops before so many.
    share : float
        In [0, 1]; with 0, only a run that finds nothing new stops.
    tau : float, optional
        Radius of the balls whose area or volume is the diversity, in the units of the effects;
        short for ``measure=BallCoverage(tau)``.
    measure : Measure, optional
        The diversity; by default the one that the strategy, a bandit, is rewarded by.

    Attributes
    ----------
    trials, share, tau, measure
        As given.

    Raises
    ------
    TypeError, ValueError
        If an argument is not what it must be, or `tau` and `measure` are both given. When a run
        begins, if neither is given and the strategy is not rewarded by one measure.

    Notes
    -----
    It looks after every evaluation, or after every hundredth part of `trials`, and may be late by
    that.

    Examples
    --------
    >>> import divbandit as db
    >>> arm, strategy = db.PlanarArm(3), db.default_strategy(0.1)
    >>> stop = db.callbacks.Plateau(500, 0.01)
    >>> run = db.explore(arm, strategy, 100_000, rng=0, callbacks=[stop])
    >>> len(run) < 20_000
    True
    """

    trials: int
    share: float
    tau: float | None
    measure: Measure | None

    def __init__(
        self,
        trials: int,
        share: float,
        *,
        tau: float | None = None,
        measure: Measure | None = None,
    ) -> None:
        radius, given = tau_or_measure(tau, measure)
        self._set(
            trials=whole("trials", trials, low=1),
            share=real("share", share, low=0.0, high=1.0),
            tau=radius,
            measure=given,
        )

    @property
    def every(self) -> int:
        """After how many evaluations it looks: a hundredth part of `trials`, at least 1."""
        return max(1, self.trials // 100)

    def start(self, explorer: Explorer, n: int | None) -> RunningCallback:
        """Return what stops a run that begins now."""
        del n
        measure = measure_for(self.tau, self.measure, explorer)
        if measure is None:
            raise ValueError(
                "measure must be given to Plateau, or tau, where the strategy is not a bandit that "
                "is rewarded by a measure, got None"
            )
        return _Watching(self, Diversity(measure, explorer.history), explorer)


class _Watching:
    """A plateau that is looked for in one run."""

    def __init__(self, plateau: Plateau, diversity: Diversity, explorer: Explorer) -> None:
        self._trials, self._share, self._diversity = plateau.trials, plateau.share, diversity
        # How many evaluations there were, and the diversity then: from `trials` evaluations ago on.
        self._looks = deque([(_evaluations(explorer), diversity.now())])

    def __call__(self, explorer: Explorer, trial: Trial) -> bool:
        """Say whether the last evaluations have added too little."""
        del trial
        made, now, looks = _evaluations(explorer), self._diversity.now(), self._looks
        looks.append((made, now))
        while looks[1][0] <= made - self._trials:
            looks.popleft()
        then, before = looks[0]
        added = now - before
        return made - then >= self._trials and (added <= 0.0 or added < self._share * now)


def _evaluations(explorer: Explorer) -> int:
    """Return how many evaluations there were, failed ones included."""
    return len(explorer.history) + len(explorer.history.failures)
