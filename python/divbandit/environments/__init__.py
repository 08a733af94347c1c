"""Environments: black boxes f: M -> S that turn a motor command into an effect."""

from divbandit.environments.base import Environment
from divbandit.environments.controlled import Controlled
from divbandit.environments.episode import Episode
from divbandit.environments.function import FunctionEnvironment
from divbandit.environments.gymnasium import GymnasiumEnvironment
from divbandit.environments.obstacles import Disc, Polygon, Rectangle, Wall
from divbandit.environments.planar_arm import PlanarArm
from divbandit.environments.process import ProcessEnvironment
from divbandit.environments.push_arm import PushArm

__all__ = [
    "Controlled",
    "Disc",
    "Environment",
    "Episode",
    "FunctionEnvironment",
    "GymnasiumEnvironment",
    "PlanarArm",
    "Polygon",
    "ProcessEnvironment",
    "PushArm",
    "Rectangle",
    "Wall",
]
