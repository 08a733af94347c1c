"""The diversity that a run has reached, brought up to date effect by effect."""

from __future__ import annotations

from math import inf
from time import monotonic
from typing import TYPE_CHECKING

from divbandit.bandits import Gain
from divbandit.bandits.bandit import RewardedValue
from divbandit.measures import BallCoverage
from divbandit.measures.start import check_measure, start_measure
from divbandit.strategies.composite import Composite, CompositeValue

if TYPE_CHECKING:
    from divbandit.exploration import Explorer
    from divbandit.history import History
    from divbandit.measures import Measure, RunningMeasure
    from divbandit.strategies import Strategy


def tau_or_measure(
    tau: float | None, measure: Measure | None
) -> tuple[float | None, Measure | None]:
    """Return the radius of the balls, or else the measure, or neither; checked."""
    if tau is not None and measure is not None:
        raise ValueError(f"tau must not be given together with a measure, got {tau!r}")
    return (
        None if tau is None else BallCoverage(tau).tau,
        None if measure is None else check_measure("measure", measure),
    )


def measure_for(tau: float | None, measure: Measure | None, explorer: Explorer) -> Measure | None:
    """Return the measure given, or else what the explorer's bandit is rewarded by, if that is one.

    Examples
    --------
    >>> import divbandit as db
    >>> explorer = db.Explorer(db.Adapt([db.MotorBabbling()], tau=0.5), db.Box([0], [1]))
    >>> measure_for(None, None, explorer), measure_for(0.1, None, explorer)
    (BallCoverage(0.5), BallCoverage(0.1))
    """
    if tau is not None:
        return BallCoverage(tau)
    if measure is not None:
        return measure
    found = _rewarded(explorer._given)  # noqa: SLF001 - `strategy` may be what runs
    return found[0] if len(found) == 1 else None


def _rewarded(strategy: Strategy) -> list[Measure]:
    """Return the measures, each once, of the outermost bandits that have one."""
    if isinstance(strategy, RewardedValue) and isinstance(strategy.rewarding, Gain):
        return [strategy.rewarding.measure]
    found: list[Measure] = []
    parts = strategy.strategies if isinstance(strategy, (Composite, CompositeValue)) else ()
    for part in parts:
        found += [each for each in _rewarded(part) if each not in found]
    return found


class Diversity:
    """The diversity of the effects of a history that grows; each of them is added once."""

    def __init__(self, measure: Measure, history: History) -> None:
        self._measure, self._history = measure, history
        self._running: RunningMeasure | None = None
        if history.effect_dim is not None:
            self._running = start_measure("measure", measure, history.effect_dim)

    def __len__(self) -> int:
        """Return how many effects it is of."""
        return 0 if self._running is None else len(self._running)

    def now(self, *, within: float = inf) -> float:
        """Add the effects that are new, for about `within` seconds, and return the diversity."""
        until = monotonic() + within
        count = len(self._history) if within == inf else 1
        while len(self) < len(self._history):
            if self._running is None:
                dim: int = self._history.effect_dim  # type: ignore[assignment] # of the effects
                self._running = start_measure("measure", self._measure, dim)
            known = len(self._running)
            self._running.extend(self._history.effects[known : known + count])
            if monotonic() >= until:
                break
            count *= 2  # the last ones take about as long as all before them
        return 0.0 if self._running is None else float(self._running.measure)
