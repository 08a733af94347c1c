"""Environments: black boxes f: M -> S that turn a motor command into an effect."""

from divbandit.environments.base import Environment
from divbandit.environments.function import FunctionEnvironment
from divbandit.environments.obstacles import Disc, Polygon, Rectangle, Wall
from divbandit.environments.planar_arm import PlanarArm
from divbandit.environments.push_arm import PushArm

__all__ = [
    "Disc",
    "Environment",
    "FunctionEnvironment",
    "PlanarArm",
    "Polygon",
    "PushArm",
    "Rectangle",
    "Wall",
]
