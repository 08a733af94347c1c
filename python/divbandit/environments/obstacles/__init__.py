"""Obstacles: what stops the links of an arm."""

from divbandit.environments.obstacles.base import Obstacle, checked, kernels
from divbandit.environments.obstacles.disc import Disc
from divbandit.environments.obstacles.polygon import Polygon
from divbandit.environments.obstacles.rectangle import Rectangle
from divbandit.environments.obstacles.wall import Wall

__all__ = ["Disc", "Obstacle", "Polygon", "Rectangle", "Wall", "checked", "kernels"]
