"""CompetenceProgress: reward for coming nearer to a goal than ever before."""

from __future__ import annotations

from dataclasses import dataclass

from divbandit import _core
from divbandit._value import Value


@dataclass(frozen=True, init=False, repr=False)
class CompetenceProgress(Value):
    """By how much the nearest effect to the trial's goal has come nearer, in units of the effects.

    The distance from the goal to the nearest effect known before, less that to the new effect; 0
    where this is negative, where the trial has no goal, and for the first effect of all. In the
    spirit of the competence progress of Baranes and Oudeyer (2013, "Active Learning of Inverse
    Models with Intrinsically Motivated Goal Exploration in Robots", Robotics and Autonomous
    Systems 61(1), 49-73), with the nearest effect known as the competence for a goal.

    Motor babbling has no goals and earns nothing: combine with a policy that also chooses at
    random.

    Examples
    --------
    >>> import divbandit as db
    >>> from divbandit.bandits import CompetenceProgress, EpsilonGreedy, RecentWindow
    >>> babblings = [db.GoalBabbling(d) for d in (0.01, 0.05, 0.5)]
    >>> bandit = db.Bandit(
    ...     babblings,
    ...     reward=CompetenceProgress(),
    ...     estimator=RecentWindow(100),
    ...     policy=EpsilonGreedy(0.1),
    ... )
    >>> run = db.explore(db.PlanarArm(20), bandit, n=200, rng=0)
    >>> run.estimates.shape
    (200, 3)
    """

    def largest(self, dim: int) -> float:
        """Return 0.0: progress has no bound."""
        del dim
        return 0.0

    def start(self, dim: int) -> _core.Reward:
        """Return what finds the progress of one exploration."""
        return _core.Reward(self, dim)
