"""Estimators: the mean rewards of a bandit's strategies, over all or recent rewards."""

from divbandit.bandits.estimators.discounted import Discounted
from divbandit.bandits.estimators.protocol import Estimates, Estimator
from divbandit.bandits.estimators.recent_window import RecentWindow
from divbandit.bandits.estimators.whole_past import WholePast
from divbandit.bandits.estimators.window import Window

__all__ = ["Discounted", "Estimates", "Estimator", "RecentWindow", "WholePast", "Window"]
