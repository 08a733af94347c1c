"""TimeBudget: stop a run after some time."""

from __future__ import annotations

from dataclasses import dataclass
from time import monotonic
from typing import TYPE_CHECKING

from divbandit._duration import seconds
from divbandit._value import Value

if TYPE_CHECKING:
    from divbandit._core import Trial
    from divbandit.callbacks.protocol import RunningCallback
    from divbandit.exploration import Explorer


@dataclass(frozen=True, init=False, repr=False)
class TimeBudget(Value):
    """Stops a run after some time, by the clock on the wall.

    No evaluation begins after that; those under way are finished, so that a run takes longer by one
    evaluation at most. It begins again with each run.

    Parameters
    ----------
    limit : str or float
        The longest time: ``"250ms"``, ``"30s"``, ``"10min"``, ``"1.5 h"``, ``"1d"``, or a number of
        seconds.

    Attributes
    ----------
    limit : float
        In seconds.

    Raises
    ------
    TypeError, ValueError
        If `limit` is not a positive duration.

    Examples
    --------
    >>> import divbandit as db
    >>> db.callbacks.TimeBudget("2h")
    TimeBudget(7200.0)
    >>> arm, strategy = db.PlanarArm(20), db.MotorBabbling()
    >>> stop = db.callbacks.TimeBudget("50ms")
    >>> run = db.explore(arm, strategy, 10**7, rng=0, callbacks=[stop])
    >>> len(run) < 10**7
    True
    """

    limit: float

    def __init__(self, limit: str | float) -> None:
        self._set(limit=seconds("limit", limit))

    @property
    def every(self) -> str:
        """How often it looks at the clock: a hundred times a second at most."""
        return "10ms"

    def start(self, explorer: Explorer, n: int | None) -> RunningCallback:
        """Return what stops a run that begins now."""
        del explorer, n
        end = monotonic() + self.limit

        def is_over(explorer: Explorer, trial: Trial) -> bool:
            del explorer, trial
            return monotonic() >= end

        return is_over
