"""Credits: what a bandit gives a strategy for an effect that it produced."""

from divbandit.bandits.credits.competence_progress import CompetenceProgress
from divbandit.bandits.credits.coverage_gain import CoverageGain
from divbandit.bandits.credits.function import FunctionCredit
from divbandit.bandits.credits.gain import Gain
from divbandit.bandits.credits.protocol import Credit

__all__ = ["CompetenceProgress", "CoverageGain", "Credit", "FunctionCredit", "Gain"]
