"""Controllers: from a motor command to what drives a body."""

from divbandit.controllers.function import FunctionController
from divbandit.controllers.movement_primitives import MovementPrimitives
from divbandit.controllers.open_loop import OpenLoop
from divbandit.controllers.protocol import Controller, Trajectories
from divbandit.controllers.tracking import Tracking
from divbandit.controllers.via_points import ViaPoints

__all__ = [
    "Controller",
    "FunctionController",
    "MovementPrimitives",
    "OpenLoop",
    "Tracking",
    "Trajectories",
    "ViaPoints",
]
