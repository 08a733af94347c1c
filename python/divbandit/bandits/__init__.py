"""Bandits: strategies that choose among others by what these have achieved.

A `Bandit` has three parts. Credits: `CoverageGain`, `Gain`, `CompetenceProgress`,
`FunctionCredit`. Memories: `Window`, `RecentWindow`, `Discounted`, `WholePast`. Rules:
`Proportional`, `EpsilonGreedy`, `Softmax`, `UCB`, `Thompson`, `Exp3`, `Exp3S`, `RoundRobin`,
`Uniform`. By name: `Adapt`, the paper's, `ucb1`, `sliding_window_ucb`, `discounted_ucb`;
`default_strategy`, the library's own composition.
"""

from divbandit.bandits.adapt import Adapt
from divbandit.bandits.bandit import Bandit
from divbandit.bandits.credits import (
    CompetenceProgress,
    CoverageGain,
    Credit,
    FunctionCredit,
    Gain,
)
from divbandit.bandits.default import default_strategies, default_strategy
from divbandit.bandits.memories import Discounted, Memory, RecentWindow, WholePast, Window
from divbandit.bandits.published import (
    discounted_adapt,
    discounted_greedy,
    discounted_ucb,
    sliding_window_ucb,
    ucb1,
)
from divbandit.bandits.rules import (
    UCB,
    EpsilonGreedy,
    Exp3,
    Exp3S,
    Proportional,
    RoundRobin,
    Rule,
    Softmax,
    Thompson,
    Uniform,
)

__all__ = [
    "UCB",
    "Adapt",
    "Bandit",
    "CompetenceProgress",
    "CoverageGain",
    "Credit",
    "Discounted",
    "EpsilonGreedy",
    "Exp3",
    "Exp3S",
    "FunctionCredit",
    "Gain",
    "Memory",
    "Proportional",
    "RecentWindow",
    "RoundRobin",
    "Rule",
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
