"""Repeating: the same command at every step."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

from divbandit.strategies import Strategy, Trial
from divbandit.strategies.base import StrategyValue

if TYPE_CHECKING:
    import numpy as np
    from numpy.random import Generator
    from numpy.typing import NDArray

    from divbandit.history import History
    from divbandit.strategies.base import Starter


@dataclass(frozen=True, init=False, repr=False)
class Repeating(StrategyValue):
    """A command drawn uniformly in M, at each step the same: a strategy that finds nothing.

    Examples
    --------
    >>> import divbandit as db
    >>> run = db.explore(db.PlanarArm(20), Repeating(), n=100, rng=0)
    >>> bool(run.coverage(0.02)[0] == run.coverage(0.02)[-1])
    True
    """

    def start(self, start: Starter) -> Strategy:
        """Return a strategy without a command yet."""
        del start
        return _Repeating()


class _Repeating(Strategy):
    """The command, once it is drawn."""

    _command: NDArray[np.float64] | None = None

    def propose(self, history: History, rng: Generator) -> Trial:
        """Return the command; at first one ``rng.random()`` a coordinate draws it."""
        if self._command is None:
            self._command = history.motor_space.sample(rng)
        return Trial(self._command)
