"""Inverse models: from a goal to a command likely to bring about an effect near it."""

from divbandit.strategies.inverse.k_nearest import KNearest
from divbandit.strategies.inverse.local_jacobian import LocalJacobian
from divbandit.strategies.inverse.local_regression import LocalRegression
from divbandit.strategies.inverse.nearest import NearestNeighbor
from divbandit.strategies.inverse.protocol import InverseModel

__all__ = ["InverseModel", "KNearest", "LocalJacobian", "LocalRegression", "NearestNeighbor"]
