"""Diversity-driven selection of exploration strategies.

A black box f: M -> S can be tried n times. Which inputs make it show the most different
outputs? Several exploration strategies are treated as the arms of a bandit whose reward is the
new volume that their effects cover (Benureau and Oudeyer, ICDL-EpiRob 2015).

The names below follow the data: environment -> strategy -> effect -> gain -> bandit ->
exploration -> figure (`plot`, which needs matplotlib only when it draws).
"""

from divbandit import bandits, goals, inverse, plot
from divbandit._core import NearestNeighbors
from divbandit.bandits import Adapt, Bandit, default_strategies, default_strategy
from divbandit.box import Box
from divbandit.controllers import (
    Controller,
    FunctionController,
    MovementPrimitives,
    OpenLoop,
    Tracking,
    Trajectories,
)
from divbandit.environments import (
    Controlled,
    Disc,
    Environment,
    Episode,
    FunctionEnvironment,
    GymnasiumEnvironment,
    PlanarArm,
    Polygon,
    ProcessEnvironment,
    PushArm,
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
    GoalBabbling,
    Mixture,
    MotorBabbling,
    QuasiRandomBabbling,
    Schedule,
    Strategy,
    Trial,
)

__all__ = [
    "Adapt",
    "Bandit",
    "Box",
    "Composite",
    "Controlled",
    "Controller",
    "Coverage",
    "Disc",
    "Entropy",
    "Environment",
    "Episode",
    "Exploration",
    "Explorer",
    "Failure",
    "FunctionController",
    "FunctionEnvironment",
    "GoalBabbling",
    "GridCoverage",
    "GymnasiumEnvironment",
    "History",
    "Loop",
    "Measure",
    "Mixture",
    "MotorBabbling",
    "MovementPrimitives",
    "NearestNeighbors",
    "OpenLoop",
    "PlanarArm",
    "Polygon",
    "ProcessEnvironment",
    "PushArm",
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
    "Wall",
    "bandits",
    "coverage",
    "default_strategies",
    "default_strategy",
    "explore",
    "explore_many",
    "goals",
    "inverse",
    "plot",
    "summarize",
]
