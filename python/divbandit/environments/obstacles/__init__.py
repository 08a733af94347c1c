"""Obstacles: what the links of an arm cannot pass."""

from divbandit.environments.obstacles.base import Obstacle, checked
from divbandit.environments.obstacles.disc import Disc
from divbandit.environments.obstacles.polygon import Polygon
from divbandit.environments.obstacles.rectangle import Rectangle
from divbandit.environments.obstacles.wall import Wall

__all__ = ["Disc", "Obstacle", "Polygon", "Rectangle", "Wall", "checked"]
