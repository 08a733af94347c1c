"""Rules: how a bandit chooses, given what it remembers of its strategies' credits."""

from divbandit.bandits.rules.epsilon_greedy import EpsilonGreedy
from divbandit.bandits.rules.exp3 import Exp3
from divbandit.bandits.rules.exp3s import Exp3S
from divbandit.bandits.rules.proportional import Proportional
from divbandit.bandits.rules.protocol import Rule
from divbandit.bandits.rules.round_robin import RoundRobin
from divbandit.bandits.rules.softmax import Softmax
from divbandit.bandits.rules.thompson import Thompson
from divbandit.bandits.rules.ucb import UCB
from divbandit.bandits.rules.uniform import Uniform

__all__ = [
    "UCB",
    "EpsilonGreedy",
    "Exp3",
    "Exp3S",
    "Proportional",
    "RoundRobin",
    "Rule",
    "Softmax",
    "Thompson",
    "Uniform",
]
