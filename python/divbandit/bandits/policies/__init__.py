"""Policies: how a bandit chooses, given the estimates of its strategies' rewards."""

from divbandit.bandits.policies.epsilon_greedy import EpsilonGreedy
from divbandit.bandits.policies.exp3 import Exp3
from divbandit.bandits.policies.exp3s import Exp3S
from divbandit.bandits.policies.proportional import Proportional
from divbandit.bandits.policies.protocol import Policy, RunningPolicy
from divbandit.bandits.policies.round_robin import RoundRobin
from divbandit.bandits.policies.softmax import Softmax
from divbandit.bandits.policies.thompson import Thompson
from divbandit.bandits.policies.ucb import UCB
from divbandit.bandits.policies.uniform import Uniform

__all__ = [
    "UCB",
    "EpsilonGreedy",
    "Exp3",
    "Exp3S",
    "Policy",
    "Proportional",
    "RoundRobin",
    "RunningPolicy",
    "Softmax",
    "Thompson",
    "Uniform",
]
