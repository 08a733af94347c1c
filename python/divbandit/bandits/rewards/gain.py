"""Gain: what an effect adds to the diversity of those before it, as in the paper."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

from divbandit import _core
from divbandit._checks import real
from divbandit._value import Value
from divbandit.measures.start import check_measure, start_measure

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

    from divbandit._core import Trial
    from divbandit.bandits.rewards.protocol import RunningReward
    from divbandit.history import History
    from divbandit.measures import Measure, RunningMeasure


@dataclass(frozen=True, init=False, repr=False)
class Gain(Value):
    """The gain of an effect: what it adds to a measure of diversity, given all effects before it.

    By ``BallCoverage(tau)`` it is the paper's diversity of one effect, div_tau(y, E) =
    C_tau(E + y) - C_tau(E) (Benureau and Oudeyer 2015): the new area that its disc covers. Bandits
    take ``tau=`` as short for that.

    Parameters
    ----------
    measure : Measure
        For instance ``divbandit.measures.GridCoverage(0.05)``.

    Attributes
    ----------
    measure : Measure

    Raises
    ------
    TypeError
        If `measure` is not a measure.

    Examples
    --------
    >>> import divbandit as db
    >>> from divbandit.bandits import Gain
    >>> babblings = [db.MotorBabbling(), db.GoalBabbling(0.05)]
    >>> adapt = db.Adapt(babblings, reward=Gain(db.measures.GridCoverage(0.05)))
    >>> run = db.explore(db.PlanarArm(20), adapt, n=100, rng=0)
    >>> float(run.estimates[0, 0])
    1.0
    """

    measure: Measure

    def __init__(self, measure: Measure) -> None:
        self._set(measure=check_measure("measure", measure))

    def largest(self, dim: int) -> float:
        """Return the measure's largest gain.

        Examples
        --------
        >>> import divbandit as db
        >>> round(db.bandits.Gain(db.measures.BallCoverage(0.5)).largest(2), 6)
        0.785398
        """
        largest = start_measure("measure", self.measure, dim).largest_gain
        return real("measure.largest_gain", largest, low=0.0)

    def start(self, dim: int) -> RunningReward:
        """Return what finds the gains of one exploration."""
        if isinstance(self.measure, Value):
            return _core.Reward(self, dim)
        return _Measured(start_measure("measure", self.measure, dim))


class _Measured:
    """Gains by a user-defined measure, brought up to date from the history."""

    def __init__(self, measure: RunningMeasure) -> None:
        self._measure = measure

    def of(self, trial: Trial, effect: NDArray[np.float64], history: History) -> float:
        """Return the gain of the newest effect; the effects of others are added before it."""
        del trial
        known, before = len(self._measure), len(history) - 1
        if known < before:
            self._measure.extend(history.effects[known:before])
        gain = float(self._measure.add(effect))
        if gain - gain != 0.0:
            raise ValueError(f"measure must give finite gains, got {gain}")
        return gain
