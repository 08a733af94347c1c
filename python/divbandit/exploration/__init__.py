"""Explorations: running a strategy in an environment, and the record of it."""

from divbandit.exploration.explore import explore
from divbandit.exploration.explorer import Explorer
from divbandit.exploration.result import Exploration

__all__ = ["Exploration", "Explorer", "explore"]
