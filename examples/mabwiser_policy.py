"""Policies of MABWiser choose among goal babblings; the bandit's other two parts are built in.

Needs MABWiser: ``pip install 'divbandit[mabwiser]'``.
"""

from mabwiser.mab import LearningPolicy

import divbandit as db
from divbandit.adapters import MabwiserPolicy
from divbandit.bandits import Proportional, WholePast, Window

arm = db.PlanarArm(20)
babblings = [db.MotorBabbling(), *(db.GoalBabbling(d) for d in (0.001, 0.05, 0.5))]


def bandit(policy, estimator):
    """Return a bandit that is rewarded for the area that effects newly cover."""
    return db.Bandit(babblings, tau=0.02, estimator=estimator, policy=policy)


def is_success(_, share):
    """Say which share of a whole disc is a success: Thompson sampling knows nothing between."""
    return share > 0.2


bandits = {
    # A policy of MABWiser keeps its own estimates; the estimator says what the run records.
    "epsilon-greedy": bandit(MabwiserPolicy(LearningPolicy.EpsilonGreedy(0.1)), WholePast()),
    "UCB1": bandit(MabwiserPolicy(LearningPolicy.UCB1(0.5)), WholePast()),
    "Thompson": bandit(MabwiserPolicy(LearningPolicy.ThompsonSampling(is_success)), WholePast()),
    "ADAPT": bandit(Proportional(0.1), Window(50)),
}
for name, strategy in bandits.items():
    run = db.explore(arm, strategy, n=1000, rng=0)
    shares = [f"{(run.choices == index).mean():.0%}" for index in range(len(babblings))]
    print(f"{name:14} covers {run.coverage(0.02)[-1]:.2f} m2, chose {' '.join(shares)}")
