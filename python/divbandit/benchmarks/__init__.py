"""Benchmarks: black boxes by the conventions of the field, each with its source."""

from divbandit.benchmarks.arm_repertoire import ArmRepertoire
from divbandit.benchmarks.gray_scott import GrayScott
from divbandit.benchmarks.lenia import Lenia
from divbandit.benchmarks.linear_projection import LinearProjection
from divbandit.benchmarks.maze import Maze

__all__ = ["ArmRepertoire", "GrayScott", "Lenia", "LinearProjection", "Maze"]
