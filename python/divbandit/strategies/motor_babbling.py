"""MotorBabbling: motor commands at random."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

from divbandit._core import Trial
from divbandit.strategies.base import Starter, StrategyValue

if TYPE_CHECKING:
    from numpy.random import Generator

    from divbandit.history import History


@dataclass(frozen=True, init=False, repr=False)
class MotorBabbling(StrategyValue):
    """Random motor babbling: commands uniform in M (Benureau and Oudeyer 2015, figure 1).

    Examples
    --------
    >>> import divbandit as db
    >>> run = db.explore(db.PlanarArm(20), db.MotorBabbling(), n=100, rng=0)
    >>> run.effects.shape
    (100, 2)
    """

    def start(self, start: Starter) -> MotorBabbling:
        """Return itself, which keeps no state; of a class that derives from it, a copy."""
        return self if type(self) is MotorBabbling else start.copy_of(self)

    def propose(self, history: History, rng: Generator) -> Trial:
        """Draw a command: one ``rng.random()`` a coordinate."""
        return Trial(history.motor_space.sample(rng))
