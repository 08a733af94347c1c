"""Environments: black boxes f: M -> S that turn a motor command into an effect."""

from divbandit.environments.base import Environment
from divbandit.environments.episode import Episode
from divbandit.environments.function import FunctionEnvironment
from divbandit.environments.gymnasium import GymnasiumEnvironment
from divbandit.environments.obstacles import Disc, Polygon, Rectangle, Wall
from divbandit.environments.planar_arm import PlanarArm

__all__ = [
    "Disc",
    "Environment",
    "Episode",
    "FunctionEnvironment",
    "GymnasiumEnvironment",
    "PlanarArm",
    "Polygon",
    "Rectangle",
    "Wall",
]
