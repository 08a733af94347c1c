"""Watching: callbacks that are called every so many evaluations, or every so many seconds."""

from __future__ import annotations

import math
from time import monotonic
from typing import TYPE_CHECKING

from divbandit._checks import whole
from divbandit._duration import seconds
from divbandit.callbacks.protocol import start_callback

if TYPE_CHECKING:
    from typing_extensions import Self

    from divbandit._core import Trial
    from divbandit.callbacks.protocol import CallbackLike
    from divbandit.exploration.explorer import Explorer

#: Evaluations or time.
Every = int | str


class Watcher:
    """A callback during a run; leaving the ``with`` statement closes it."""

    def __init__(self, callback: CallbackLike, explorer: Explorer, n: int) -> None:
        self._callback, self._explorer, self._n = callback, explorer, n
        self._period, self._time = period("every", getattr(callback, "every", 1))
        self.trials: float = self._period
        self._due = monotonic() + self._time

    @property
    def seconds(self) -> float:
        """How long until it is to be called."""
        return math.inf if math.isinf(self._time) else max(0.0, self._due - monotonic())

    def looks(self, trial: Trial) -> bool:
        """Call it if it is due, and return whether the run is to stop."""
        if self.trials > 0 and (math.isinf(self._time) or monotonic() < self._due):
            return False
        self.trials, self._due = self._period, monotonic() + self._time
        return self._running(self._explorer, trial) is True

    def __enter__(self) -> Self:
        self._running = start_callback(self._callback, self._explorer, self._n)
        return self

    def __exit__(self, *_: object) -> None:
        close = getattr(self._running, "close", None)
        if close is not None:
            close()


def period(name: str, every: Every) -> tuple[float, float]:
    """Return after how many evaluations something is due, or after how many seconds.

    Examples
    --------
    >>> period("every", 10), period("every", "2min")
    ((10, inf), (inf, 120.0))
    """
    if isinstance(every, str):
        return math.inf, seconds(name, every)
    return whole(name, every, low=1), math.inf
