"""Benchmarks: black boxes by the conventions of the field, each with its source."""

from divbandit.benchmarks.arm_repertoire import ArmRepertoire
from divbandit.benchmarks.linear_projection import LinearProjection

__all__ = ["ArmRepertoire", "LinearProjection"]
