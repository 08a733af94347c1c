"""GoalBabbling: goals at random, and the inverse model to reach them."""

from __future__ import annotations

from typing import TYPE_CHECKING

from divbandit._checks import real
from divbandit._engine import bounds_of
from divbandit.box import Box, BoxLike
from divbandit.strategies.base import Strategy, Trial

if TYPE_CHECKING:
    from numpy.random import Generator

    from divbandit._engine import Description
    from divbandit.history import History


_NO_GOALS = "goals must be given to GoalBabbling: there is no sensory space to draw them from"


class GoalBabbling(Strategy):
    """Random goal babbling, RGB(d) (Benureau and Oudeyer 2015, figure 2).

    A goal is drawn uniformly, and the inverse model turns it into a command: that of the
    observed effect nearest to the goal, perturbed by up to the share `d` of each motor range.
    With nothing observed yet, it babbles in M.

    Parameters
    ----------
    d : float
        Perturbation, a share of the motor range, in [0, 1].
    goals : Box or object with ``low`` and ``high``, optional
        Where goals are drawn; by default the environment's sensory space.

    Raises
    ------
    TypeError, ValueError
        If `d` is not a number in [0, 1], or `goals` is no box.

    Examples
    --------
    >>> import divbandit as db
    >>> arm = db.PlanarArm(20)
    >>> goal_babbling = db.explore(arm, db.GoalBabbling(0.05), n=1000, rng=0)
    >>> motor_babbling = db.explore(arm, db.MotorBabbling(), n=1000, rng=0)
    >>> bool(goal_babbling.coverage(0.02)[-1] > motor_babbling.coverage(0.02)[-1])
    True
    """

    def __init__(self, d: float = 0.05, *, goals: BoxLike | None = None) -> None:
        self.d = real("d", d, low=0.0, high=1.0)
        self.goals = None if goals is None else Box.of(goals, name="goals")

    def check(self, motor_space: Box, effect_dim: int | None, *, has_goals: bool) -> None:
        """Require goals of the effects' dimension."""
        del motor_space
        if self.goals is None:
            if not has_goals:
                raise ValueError(_NO_GOALS)
        elif effect_dim is not None and self.goals.dim != effect_dim:
            raise ValueError(
                f"goals must have the dimension of the effects, {effect_dim}, got {self.goals.dim}"
            )

    def propose(self, history: History, rng: Generator) -> Trial:
        """Draw a goal and invert it: one ``rng.random()`` a coordinate of S, then of M."""
        if len(history) == 0:
            return Trial(history.motor_space.sample(rng))
        goals = self.goals if self.goals is not None else history.sensory_space
        if goals is None:
            raise ValueError(_NO_GOALS)
        goal = goals.sample(rng)
        return Trial(history.inverse(goal, rng, d=self.d), goal=goal)

    def _describe(self, description: Description) -> int:
        goals = None if self.goals is None else bounds_of("goals", self.goals)
        return description.engine.goal_babbling(self.d, goals)

    def __repr__(self) -> str:
        goals = "" if self.goals is None else f", goals={self.goals!r}"
        return f"GoalBabbling({self.d!r}{goals})"
