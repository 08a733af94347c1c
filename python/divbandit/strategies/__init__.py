"""Exploration strategies: how the next motor command is picked, given all observed so far."""

from divbandit.strategies.base import Strategy, Trial
from divbandit.strategies.composite import Composite
from divbandit.strategies.goal_babbling import GoalBabbling
from divbandit.strategies.mixture import Mixture
from divbandit.strategies.motor_babbling import MotorBabbling
from divbandit.strategies.quasi_random import QuasiRandomBabbling
from divbandit.strategies.schedule import Schedule

__all__ = [
    "Composite",
    "GoalBabbling",
    "Mixture",
    "MotorBabbling",
    "QuasiRandomBabbling",
    "Schedule",
    "Strategy",
    "Trial",
]
