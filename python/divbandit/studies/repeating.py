"""Repeating: the same command at every step."""

from __future__ import annotations

from typing import TYPE_CHECKING

from divbandit.strategies import Strategy

if TYPE_CHECKING:
    import numpy as np
    from numpy.random import Generator
    from numpy.typing import NDArray

    from divbandit.history import History


class Repeating(Strategy):
    """A command drawn uniformly in M, at each step the same: a strategy that finds nothing.

    Examples
    --------
    >>> import numpy as np
    >>> import divbandit as db
    >>> run = db.explore(db.PlanarArm(2), Repeating(), 3, rng=0)
    >>> len(np.unique(run.commands, axis=0))
    1
    """

    _command: NDArray[np.float64] | None = None

    def propose(self, history: History, rng: Generator) -> NDArray[np.float64]:
        """Return the command; at first one ``rng.random()`` a coordinate draws it."""
        if self._command is None:
            self._command = history.motor_space.sample(rng)
        return self._command
