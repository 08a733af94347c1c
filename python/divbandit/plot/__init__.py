"""Figures: each function takes data and an optional matplotlib Axes, draws, and returns the Axes.

What they draw is computed in `divbandit.plot.data`, and so available without a figure.
"""

from divbandit.plot.estimates import estimates
from divbandit.plot.mixtures import mixtures
from divbandit.plot.postures import postures
from divbandit.plot.ranking import ranking
from divbandit.plot.scene import scene
from divbandit.plot.series import series
from divbandit.plot.spread import spread
from divbandit.plot.usage import usage

__all__ = ["estimates", "mixtures", "postures", "ranking", "scene", "series", "spread", "usage"]
