"""Repeating: the same command again and again."""

from __future__ import annotations

from typing import TYPE_CHECKING

from divbandit.strategies import Strategy, Trial

if TYPE_CHECKING:
    import numpy as np
    from numpy.random import Generator
    from numpy.typing import NDArray

    from divbandit.history import History


class Repeating(Strategy):
    """A command drawn uniformly in M, at each step the same: a strategy that finds nothing.

    The command belongs to one history; asked about another, it draws a new one.

    Examples
    --------
    >>> import divbandit as db
    >>> run = db.explore(db.PlanarArm(20), Repeating(), n=100, rng=0)
    >>> bool(run.coverage(0.02)[0] == run.coverage(0.02)[-1])
    True
    """

    def __init__(self) -> None:
        self._history: History | None = None
        self._command: NDArray[np.float64] | None = None

    def propose(self, history: History, rng: Generator) -> Trial:
        """Return the command; at first one ``rng.random()`` a coordinate draws it."""
        if self._command is None or history is not self._history:
            self._history, self._command = history, history.motor_space.sample(rng)
        return Trial(self._command)

    def __repr__(self) -> str:
        return "Repeating()"
