"""Bandits: strategies that choose among others by what these have just achieved."""

from divbandit.bandits.adapt import Adapt

__all__ = ["Adapt"]
