"""Goal samplers: where goal babbling wants to get next, given all observed so far."""

from divbandit.strategies.goals.frontier import FrontierGoals
from divbandit.strategies.goals.grid import GridGoals
from divbandit.strategies.goals.novel import NovelGoals
from divbandit.strategies.goals.protocol import GoalSampler
from divbandit.strategies.goals.uncovered import UncoveredGoals
from divbandit.strategies.goals.uniform import UniformGoals
from divbandit.strategies.goals.untried import UntriedGoals

__all__ = [
    "FrontierGoals",
    "GoalSampler",
    "GridGoals",
    "NovelGoals",
    "UncoveredGoals",
    "UniformGoals",
    "UntriedGoals",
]
