"""Strategies: what proposes the next motor command.

`MotorBabbling` and `GoalBabbling` propose by themselves; `Mixture`, `Schedule` and the bandits of
`divbandit.bandits` let others propose. Derive a strategy from `Strategy`, one made of others from
`Composite`.
"""

from divbandit._core import Trial
from divbandit.strategies.base import Starter, Strategy
from divbandit.strategies.composite import Composite
from divbandit.strategies.goal_babbling import GoalBabbling
from divbandit.strategies.mixture import Mixture
from divbandit.strategies.motor_babbling import MotorBabbling
from divbandit.strategies.schedule import Schedule

__all__ = [
    "Composite",
    "GoalBabbling",
    "Mixture",
    "MotorBabbling",
    "Schedule",
    "Starter",
    "Strategy",
    "Trial",
]
