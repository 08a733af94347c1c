"""Progress: a bar that shows how far a run is, and what it has found."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

from divbandit._library import library
from divbandit._value import Value
from divbandit.callbacks.diversity import Diversity, measure_for, tau_or_measure
from divbandit.measures import BallCoverage

if TYPE_CHECKING:
    from divbandit._core import Trial
    from divbandit.callbacks.protocol import RunningCallback
    from divbandit.exploration import Explorer
    from divbandit.measures import Measure

#: The longest time, in seconds, for which effects are measured before the bar is drawn.
_MEASURING = 0.01

#: The same when it is drawn for the last time.
_LAST_MEASURING = 1.0


@dataclass(frozen=True, init=False, repr=False)
class Progress(Value):
    """A progress bar: evaluations, failures, diversity, and the time that is left.

    It is drawn on standard error, or as a widget in a notebook, at most ten times a second, and
    takes about a tenth of the time at most: where effects come in faster than they can be measured,
    it says of how many the diversity is.

    It needs tqdm: ``pip install 'divbandit[cli]'``.

    Parameters
    ----------
    tau : float, optional
        Radius of the balls whose area or volume is shown, in the units of the effects; short for
        ``measure=BallCoverage(tau)``.
    measure : Measure, optional
        The diversity to show. By default the one that the strategy is rewarded by, if it is a
        bandit with one; otherwise none is shown.

    Attributes
    ----------
    tau, measure
        As given.

    Raises
    ------
    ModuleNotFoundError
        If tqdm is missing.
    TypeError, ValueError
        If an argument is not what it must be, or both are given.

    Examples
    --------
    >>> import divbandit as db
    >>> arm, strategy = db.PlanarArm(20), db.default_strategy(0.02)
    >>> show = [db.callbacks.Progress()]
    >>> run = db.explore(arm, strategy, 1000, rng=0, callbacks=show)
    """

    tau: float | None
    measure: Measure | None

    def __init__(self, *, tau: float | None = None, measure: Measure | None = None) -> None:
        library("tqdm", user="Progress", extra="cli")
        radius, given = tau_or_measure(tau, measure)
        self._set(tau=radius, measure=given)

    @property
    def every(self) -> str:
        """How often it is drawn: ten times a second at most."""
        return "0.1s"

    def start(self, explorer: Explorer, n: int | None) -> RunningCallback:
        """Return the bar of a run that begins now."""
        measure = measure_for(self.tau, self.measure, explorer)
        diversity = None if measure is None else Diversity(measure, explorer.history)
        name = "coverage" if isinstance(measure, BallCoverage) else "diversity"
        return _Bar(explorer, n, name, diversity)


class _Bar:
    """The bar of one run."""

    def __init__(
        self, explorer: Explorer, n: int | None, name: str, diversity: Diversity | None
    ) -> None:
        from tqdm.auto import tqdm  # noqa: PLC0415 - slow to import

        class Bar(tqdm):  # type: ignore[misc] # it has no types
            monitor_interval = 0  # no thread: worker processes may be forked

        self._history, self._name, self._diversity = explorer.history, name, diversity
        self._before = len(self._history) + len(self._history.failures)
        self._failed_before = len(self._history.failures)
        self._bar: Any = Bar(total=n, unit=" trials", dynamic_ncols=True)

    def __call__(self, explorer: Explorer, trial: Trial) -> None:
        """Draw the bar as it is now."""
        del explorer, trial
        self._count()
        self._bar.refresh()

    def close(self) -> None:
        """Draw the bar for the last time."""
        try:
            self._count(_LAST_MEASURING)
        finally:
            self._bar.close()

    def _count(self, within: float = _MEASURING) -> None:
        history, bar = self._history, self._bar
        failed = len(history.failures)
        text = f"{failed - self._failed_before} failed"
        if self._diversity is not None:
            text += f", {self._name} {self._diversity.now(within=within):.4g}"
            if len(self._diversity) < len(history):
                text += f" of the first {len(self._diversity)}"
        bar.set_postfix_str(text, refresh=False)
        bar.n = len(history) + failed - self._before
