"""Every: a callback that is called less often."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

from divbandit._checks import whole
from divbandit._duration import seconds
from divbandit._value import Value
from divbandit.callbacks.protocol import check_callback, start_callback

if TYPE_CHECKING:
    from divbandit.callbacks.protocol import CallbackLike, RunningCallback
    from divbandit.exploration import Explorer


@dataclass(frozen=True, init=False, repr=False)
class Every(Value):
    """A callback, called after every k evaluations, or not more often than every so many seconds.

    Parameters
    ----------
    k : int or str
        How many evaluations, at least 1; or a duration such as ``"30s"``.
    callback : callable or Callback
        Any function of an explorer and a trial, or another callback. How often it asks to be called
        itself does not matter.

    Attributes
    ----------
    k, callback
        As given.

    Raises
    ------
    TypeError, ValueError
        If `k` is not a whole number of at least 1, or text that is not a duration; if `callback` is
        not a callback.

    Examples
    --------
    >>> import divbandit as db
    >>> def report(explorer, trial):
    ...     print(len(explorer.history), "effects")
    >>> arm = db.PlanarArm(20)
    >>> every = db.callbacks.Every(40, report)
    >>> run = db.explore(arm, db.MotorBabbling(), 100, rng=0, callbacks=[every])
    40 effects
    80 effects
    """

    k: int | str
    callback: CallbackLike

    def __init__(self, k: int | str, callback: CallbackLike) -> None:
        if isinstance(k, str):
            seconds("k", k)
        else:
            k = whole("k", k, low=1)
        self._set(k=k, callback=check_callback("callback", callback))

    @property
    def every(self) -> int | str:
        """How often it is called: `k`."""
        return self.k

    def start(self, explorer: Explorer, n: int | None) -> RunningCallback:
        """Return the callback under way."""
        return start_callback(self.callback, explorer, n)
