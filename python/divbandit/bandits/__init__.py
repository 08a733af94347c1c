"""Bandits: strategies that choose among others by the rewards that these have earned.

A `Bandit` has three parts. Rewards: `Gain`, `CompetenceProgress`, `FunctionReward`. Estimators:
`Window`, `RecentWindow`, `Discounted`, `WholePast`. Policies: `Proportional`, `EpsilonGreedy`,
`Softmax`, `UCB`, `Thompson`, `Exp3`, `Exp3S`, `RoundRobin`, `Uniform`. By name: `Adapt`, the
paper's, `ucb1`, `sliding_window_ucb`, `discounted_ucb`, `discounted_adapt`, `discounted_greedy`;
`default_strategy`, the library's own composition.
"""

from divbandit.bandits.adapt import Adapt
from divbandit.bandits.bandit import Bandit
from divbandit.bandits.default import default_strategies, default_strategy
from divbandit.bandits.estimators import (
    Discounted,
    Estimates,
    Estimator,
    RecentWindow,
    WholePast,
    Window,
)
from divbandit.bandits.policies import (
    UCB,
    EpsilonGreedy,
    Exp3,
    Exp3S,
    Policy,
    Proportional,
    RoundRobin,
    RunningPolicy,
    Softmax,
    Thompson,
    Uniform,
)
from divbandit.bandits.published import (
    discounted_adapt,
    discounted_greedy,
    discounted_ucb,
    sliding_window_ucb,
    ucb1,
)
from divbandit.bandits.rewards import (
    CompetenceProgress,
    FunctionReward,
    Gain,
    Reward,
    RunningReward,
)

__all__ = [
    "UCB",
    "Adapt",
    "Bandit",
    "CompetenceProgress",
    "Discounted",
    "EpsilonGreedy",
    "Estimates",
    "Estimator",
    "Exp3",
    "Exp3S",
    "FunctionReward",
    "Gain",
    "Policy",
    "Proportional",
    "RecentWindow",
    "Reward",
    "RoundRobin",
    "RunningPolicy",
    "RunningReward",
    "Softmax",
    "Thompson",
    "Uniform",
    "WholePast",
    "Window",
    "default_strategies",
    "default_strategy",
    "discounted_adapt",
    "discounted_greedy",
    "discounted_ucb",
    "sliding_window_ucb",
    "ucb1",
]
