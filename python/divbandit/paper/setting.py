"""The setting of the paper's experiments (Benureau and Oudeyer 2015, figures 1 to 4)."""

from __future__ import annotations

from numpy.random import SeedSequence

from divbandit.bandits import Adapt
from divbandit.environments import PlanarArm
from divbandit.strategies import GoalBabbling, Mixture, MotorBabbling, Schedule, Strategy

#: Perturbations of the inverse model, shares of the motor range.
PERTURBATIONS = (0.001, 0.05, 0.5)
#: Radius of the discs, in metres.
TAU = 0.02
#: Shares of motor babbling in the mixtures of figure 4.
RATIOS = tuple(k / 20 for k in range(21))
#: Names of the two strategies, in the order in which bandits and mixtures hold them.
LABELS = ("motor babbling", "goal babbling")


def arm() -> PlanarArm:
    """Return the arm: 20 joints of +-150 degrees, 1 m long."""
    return PlanarArm(20)


def goal_babbling(d: float) -> Strategy:
    """Return figure 2's strategy: goal babbling once 10 commands were babbled."""
    return Schedule([(10, MotorBabbling()), (None, GoalBabbling(d))])


def mixture(d: float, ratio: float) -> Strategy:
    """Return figure 4's mixture with the share `ratio` of motor babbling."""
    return Mixture([MotorBabbling(), GoalBabbling(d)], weights=[ratio, 1 - ratio])


def adapt(d: float) -> Strategy:
    """Return ADAPT(w=50, tau=0.02, alpha=0.1) over the two strategies."""
    return Adapt([MotorBabbling(), GoalBabbling(d)], tau=TAU, window=50, alpha=0.1, head_start=1)


def seed_of(seed: int, *place: int) -> SeedSequence:
    """Return the seed of one exploration, by its place among all: independent of any order."""
    return SeedSequence(seed, spawn_key=place)
