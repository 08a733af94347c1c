"""MotorBabbling: motor commands at random."""

from __future__ import annotations

from typing import TYPE_CHECKING

from divbandit.strategies.base import Strategy, Trial

if TYPE_CHECKING:
    from numpy.random import Generator

    from divbandit._engine import Description
    from divbandit.history import History


class MotorBabbling(Strategy):
    """Random motor babbling: commands uniform in M (Benureau and Oudeyer 2015, figure 1).

    Examples
    --------
    >>> import divbandit as db
    >>> run = db.explore(db.PlanarArm(20), db.MotorBabbling(), n=100, rng=0)
    >>> run.effects.shape
    (100, 2)
    """

    def propose(self, history: History, rng: Generator) -> Trial:
        """Draw a command: one ``rng.random()`` a coordinate."""
        return Trial(history.motor_space.sample(rng))

    def propose_many(self, history: History, n: int, rng: Generator) -> list[Trial]:
        """Return what `n` calls of `propose` return, in one call into Rust."""
        return Trial.many(list(history.motor_space.sample_many(n, rng)))

    def _describe(self, description: Description) -> int:
        return description.engine.motor_babbling()
