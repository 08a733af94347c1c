"""Diversity-driven selection of exploration strategies.

A black box f: M -> S can be tried n times. Which inputs make it show the most different
outputs? Several exploration strategies are treated as the arms of a bandit whose reward is the
new volume that their effects cover (Benureau and Oudeyer, ICDL-EpiRob 2015).

The names below follow the data: environment -> strategy -> effect -> gain -> bandit ->
exploration -> figure (`plot`, which needs matplotlib only when it draws).
"""

from divbandit import bandits, plot
from divbandit._core import NearestNeighbors
from divbandit.bandits import Adapt, Bandit, default_strategies, default_strategy
from divbandit.box import Box
from divbandit.controllers import (
    Controller,
    FunctionController,
    OpenLoop,
    Tracking,
    Trajectories,
)
from divbandit.environments import (
    Disc,
    Environment,
    Episode,
    FunctionEnvironment,
    GymnasiumEnvironment,
    PlanarArm,
    Polygon,
    Rectangle,
    Wall,
)
from divbandit.experiments import Summary, Task, explore_many, summarize
from divbandit.exploration import Exploration, Explorer, Trials, explore
from divbandit.history import Failure, History
from divbandit.measures import (
    Coverage,
    Entropy,
    GridCoverage,
    Loop,
    Measure,
    Sparseness,
    coverage,
)
from divbandit.strategies import (
    Composite,
    FrontierGoals,
    GoalBabbling,
    GoalSampler,
    GridGoals,
    InverseModel,
    KNearest,
    LocalJacobian,
    LocalRegression,
    Mixture,
    MotorBabbling,
    NearestNeighbor,
    NovelGoals,
    QuasiRandomBabbling,
    Schedule,
    Strategy,
    Trial,
    UncoveredGoals,
    UniformGoals,
    UntriedGoals,
)

__all__ = [
    "Adapt",
    "Bandit",
    "Box",
    "Composite",
    "Controller",
    "Coverage",
    "Disc",
    "Entropy",
    "Environment",
    "Episode",
    "Exploration",
    "Explorer",
    "Failure",
    "FrontierGoals",
    "FunctionController",
    "FunctionEnvironment",
    "GoalBabbling",
    "GoalSampler",
    "GridCoverage",
    "GridGoals",
    "GymnasiumEnvironment",
    "History",
    "InverseModel",
    "KNearest",
    "LocalJacobian",
    "LocalRegression",
    "Loop",
    "Measure",
    "Mixture",
    "MotorBabbling",
    "NearestNeighbor",
    "NearestNeighbors",
    "NovelGoals",
    "OpenLoop",
    "PlanarArm",
    "Polygon",
    "QuasiRandomBabbling",
    "Rectangle",
    "Schedule",
    "Sparseness",
    "Strategy",
    "Summary",
    "Task",
    "Tracking",
    "Trajectories",
    "Trial",
    "Trials",
    "UncoveredGoals",
    "UniformGoals",
    "UntriedGoals",
    "Wall",
    "bandits",
    "coverage",
    "default_strategies",
    "default_strategy",
    "explore",
    "explore_many",
    "plot",
    "summarize",
]
