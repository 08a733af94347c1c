"""Repeating: the same command again and again."""

from __future__ import annotations

from typing import TYPE_CHECKING

from divbandit.strategies import Strategy, Trial

if TYPE_CHECKING:
    from numpy.random import Generator

    from divbandit.history import History


class Repeating(Strategy):
    """The middle of M at each step: a strategy that finds nothing.

    Examples
    --------
    >>> import divbandit as db
    >>> run = db.explore(db.PlanarArm(20), Repeating(), n=100, rng=0)
    >>> bool(run.coverage(0.02)[0] == run.coverage(0.02)[-1])
    True
    """

    def propose(self, history: History, rng: Generator) -> Trial:
        """Return the middle of M; nothing is drawn."""
        del rng
        space = history.motor_space
        return Trial(space.low + (space.high - space.low) / 2)

    def __repr__(self) -> str:
        return "Repeating()"
