"""Inverse models: from a goal to a command likely to bring about an effect near it."""

from divbandit.inverse.crossover import Crossover
from divbandit.inverse.k_nearest import KNearest
from divbandit.inverse.line_variation import LineVariation
from divbandit.inverse.local_jacobian import LocalJacobian
from divbandit.inverse.local_regression import LocalRegression
from divbandit.inverse.nearest import Nearest
from divbandit.inverse.protocol import InverseModel

__all__ = [
    "Crossover",
    "InverseModel",
    "KNearest",
    "LineVariation",
    "LocalJacobian",
    "LocalRegression",
    "Nearest",
]
