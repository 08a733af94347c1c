"""Experiments: many explorations at once, and what is kept of each."""

from divbandit.experiments.explore_many import explore_many
from divbandit.experiments.summary import Summary, summarize
from divbandit.experiments.task import Task

__all__ = ["Summary", "Task", "explore_many", "summarize"]
