"""Rewards: what a bandit pays the strategy that produced an effect."""

from divbandit.bandits.rewards.competence_progress import CompetenceProgress
from divbandit.bandits.rewards.function_reward import FunctionReward
from divbandit.bandits.rewards.gain import Gain
from divbandit.bandits.rewards.protocol import Reward, RunningReward

__all__ = ["CompetenceProgress", "FunctionReward", "Gain", "Reward", "RunningReward"]
