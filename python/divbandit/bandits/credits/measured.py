"""Measured: credits that are gains of a measure, which is brought up to date from the history."""

from __future__ import annotations

from abc import ABC, abstractmethod
from typing import TYPE_CHECKING, Any

import numpy as np

if TYPE_CHECKING:
    from collections.abc import Sequence

    from numpy.typing import NDArray

    from divbandit.history import History
    from divbandit.measures import Measure
    from divbandit.strategies.base import Trial


class Measured(ABC):
    """The gain of an effect: what it adds to the measure of all effects before it.

    A nested bandit is told of its own trials alone; the others' effects are in the history, and
    are added first.
    """

    def __init__(self) -> None:
        self._measured: Measure | None = None

    @abstractmethod
    def empty(self, dim: int) -> Measure:
        """Return what effects of this dimension are to be measured by, or refuse them."""

    def largest(self, dim: int) -> float:
        """Return the measure's largest gain."""
        return self.empty(dim).largest_gain

    def of(self, trial: Trial, effect: NDArray[np.float64], history: History) -> float:
        """Return the gain of an effect, given all before it in the history."""
        measured, place = self._measured, trial.place
        if measured is None or len(measured) != place:
            measured = self._up_to(_place_of(trial), history)
        gain = measured.add(effect)
        if type(gain) is not float:
            gain = float(gain)
        if gain - gain != 0.0:
            raise ValueError(f"measure must give finite gains, got {gain}")
        return gain

    def of_many(
        self, trials: Sequence[Trial], effects: NDArray[np.float64], history: History
    ) -> list[float]:
        """Return the gains of effects, each given all before it in the history."""
        del effects  # those of others in between are in the history alone
        if not trials:
            return []
        places = [trial.place if trial.place is not None else _place_of(trial) for trial in trials]
        first, end = min(places), max(places) + 1
        measured = self._up_to(first, history)
        found = np.asarray(measured.extend(history.effects[first:end]), dtype=np.float64)
        if places != list(range(first, end)):
            found = found[[place - first for place in places]]
        if not np.isfinite(found).all():
            bad = found[~np.isfinite(found)][0]
            raise ValueError(f"measure must give finite gains, got {bad}")
        gains: list[float] = found.tolist()
        return gains

    def _up_to(self, place: int, history: History) -> Measure:
        """Return the measure of the first `place` effects, to which more can be added."""
        measured = self._measured
        if measured is None or len(measured) > place:
            # What has been measured too far, as when an earlier effect is told of once more, cannot
            # be taken back.
            measured = self._measured = self.empty(history.effects.shape[1])
        if len(measured) < place:
            measured.extend(history.effects[len(measured) : place])
        return measured

    def __getstate__(self) -> dict[str, Any]:
        """Leave out what was measured: it is made anew from the history."""
        return {**self.__dict__, "_measured": None}


def _place_of(trial: Trial) -> int:
    if trial.place is None:
        raise ValueError("trial must have the place of its effect in the history")
    return trial.place
