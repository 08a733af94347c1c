"""Explorations: running a strategy in an environment, and what comes of it."""

from divbandit.exploration.explore import explore
from divbandit.exploration.explorer import Explorer
from divbandit.exploration.result import Exploration
from divbandit.exploration.trials import Trials

__all__ = ["Exploration", "Explorer", "Trials", "explore"]
