"""Goal samplers: what goal babbling aims at next, given everything observed so far."""

from divbandit.goals.frontier import FrontierGoals
from divbandit.goals.grid import GridGoals
from divbandit.goals.novel import NovelGoals
from divbandit.goals.protocol import GoalSampler
from divbandit.goals.uncovered import UncoveredGoals
from divbandit.goals.uniform import UniformGoals
from divbandit.goals.untried import UntriedGoals

__all__ = [
    "FrontierGoals",
    "GoalSampler",
    "GridGoals",
    "NovelGoals",
    "UncoveredGoals",
    "UniformGoals",
    "UntriedGoals",
]
