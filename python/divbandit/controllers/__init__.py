"""Controllers: what turns a motor command into what drives a body."""

from divbandit.controllers.movement_primitives import MovementPrimitives

__all__ = ["MovementPrimitives"]
