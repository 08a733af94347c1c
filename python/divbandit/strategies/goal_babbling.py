"""GoalBabbling: a goal is drawn, and an inverse model turns it into a command."""

from __future__ import annotations

from typing import TYPE_CHECKING, cast

from divbandit import _core
from divbandit._checks import real
from divbandit._engine import bounds_of
from divbandit.box import Box, BoxLike
from divbandit.strategies.base import Strategy, Trial
from divbandit.strategies.goals.protocol import GoalSampler
from divbandit.strategies.goals.uniform import UniformGoals
from divbandit.strategies.inverse.nearest import NearestNeighbor
from divbandit.strategies.inverse.protocol import InverseModel

if TYPE_CHECKING:
    from numpy.random import Generator
    from numpy.typing import ArrayLike

    from divbandit._engine import Description
    from divbandit.history import History


_NO_GOALS = "goals must be given to GoalBabbling: there is no sensory space to draw them from"

#: The paper's perturbation.
_D = 0.05


class GoalBabbling(Strategy):
    """Random goal babbling, RGB(d) (Benureau and Oudeyer 2015, figure 2).

    A goal is drawn uniformly, and the inverse model turns it into a command: that of the
    observed effect nearest to the goal, perturbed by up to the share `d` of each motor range.
    Goals may be drawn in other ways, and other inverse models take them. With nothing observed
    yet, it babbles in M.

    Parameters
    ----------
    d : float
        Perturbation, a share of the motor range, in [0, 1].
    goals : Box, object with ``low`` and ``high``, or GoalSampler, optional
        Where goals are drawn, uniformly, or who draws them; by default uniformly in the
        environment's sensory space.
    inverse : InverseModel, optional
        Who turns goals into commands; by default ``NearestNeighbor(d)``. `d` then says nothing,
        and must be left at its default.

    Attributes
    ----------
    d : float
    goals : Box, GoalSampler or None
    inverse : InverseModel or None
        As given.

    Raises
    ------
    TypeError, ValueError
        If `d` is not a number in [0, 1], `goals` is no box and no sampler, `inverse` is no inverse
        model, or `d` is given as well.

    See Also
    --------
    UniformGoals, GridGoals, UncoveredGoals, FrontierGoals, NovelGoals, NearestNeighbor, KNearest,
    LocalRegression

    Examples
    --------
    >>> import divbandit as db
    >>> arm = db.PlanarArm(20)
    >>> goal_babbling = db.explore(arm, db.GoalBabbling(0.05), n=1000, rng=0)
    >>> motor_babbling = db.explore(arm, db.MotorBabbling(), n=1000, rng=0)
    >>> bool(goal_babbling.coverage(0.02)[-1] > motor_babbling.coverage(0.02)[-1])
    True
    >>> other = db.GoalBabbling(goals=db.FrontierGoals(0.02), inverse=db.KNearest(2, 0.05))
    >>> db.explore(arm, other, n=100, rng=0).effects.shape
    (100, 2)
    """

    def __init__(
        self,
        d: float = _D,
        *,
        goals: BoxLike | GoalSampler | None = None,
        inverse: InverseModel | None = None,
    ) -> None:
        self.d = real("d", d, low=0.0, high=1.0)
        self.goals: Box | GoalSampler | None = None if goals is None else _goals(goals)
        self.inverse = inverse
        if inverse is None:
            return
        if not _is_one(inverse, InverseModel):
            raise TypeError(
                "inverse must be an InverseModel, such as LocalRegression(10, 0.05), "
                f"got {_kind(inverse)}"
            )
        if self.d != _D:
            raise ValueError(f"d must not be given together with an inverse model, got {d!r}")

    def check(self, motor_space: Box, effect_dim: int | None, *, has_goals: bool) -> None:
        """Require goals of the effects' dimension."""
        del motor_space
        goals = self.goals
        if goals is None:
            if not has_goals:
                raise ValueError(_NO_GOALS)
        elif not isinstance(goals, Box):
            check = getattr(goals, "check", None)
            if check is not None:
                check(effect_dim, has_goals=has_goals)
        elif effect_dim is not None and goals.dim != effect_dim:
            raise ValueError(
                f"goals must have the dimension of the effects, {effect_dim}, got {goals.dim}"
            )

    def propose(self, history: History, rng: Generator) -> Trial:
        """Draw a goal and invert it.

        By default one ``rng.random()`` a coordinate of S, then of M.
        """
        if len(history) == 0:
            return Trial(history.motor_space.sample(rng))
        goals = self.goals if self.goals is not None else history.sensory_space
        if goals is None:
            raise ValueError(_NO_GOALS)
        goal: ArrayLike = (
            goals.sample(rng) if isinstance(goals, Box) else goals.sample(history, rng)
        )
        if self.inverse is None:
            return Trial(history.inverse(goal, rng, d=self.d), goal=goal)
        return Trial(self.inverse.command(goal, history, rng), goal=goal)

    def propose_many(self, history: History, n: int, rng: Generator) -> list[Trial]:
        """Return what `n` calls of `propose` return; by default in one call into Rust."""
        if len(history) == 0:
            return Trial.many(list(history.motor_space.sample_many(n, rng)))
        goals, d = self._plainly(history)
        if goals is None or d is None:
            return super().propose_many(history, n, rng)
        space = history.motor_space.bounds
        drawn, commands = _core.babble(
            n, goals.bounds, d, history.tree, history.commands, space, rng
        )
        return Trial.many(list(commands), list(drawn))

    def _plainly(self, history: History) -> tuple[Box | None, float | None]:
        """Return the box that goals are uniform in, and d; None for what is drawn otherwise."""
        goals: object = self.goals
        if type(goals) is UniformGoals:
            goals = goals.box
        if goals is None:
            goals = history.sensory_space
        d: float | None = self.d
        if self.inverse is not None:
            d = self.inverse.d if type(self.inverse) is NearestNeighbor else None
        return (goals if type(goals) is Box else None), d

    def _describe(self, description: Description) -> int:
        goals, d = None, self.d
        if isinstance(self.goals, Box):
            goals = bounds_of("goals", self.goals)
        elif self.goals is not None:
            goals = description.detail("goals", self.goals)
        if self.inverse is not None:
            d = description.detail("inverse", self.inverse)
        return description.engine.goal_babbling(d, goals)

    def __repr__(self) -> str:
        arguments = [repr(self.d)] if self.inverse is None else []
        if self.goals is not None:
            arguments.append(f"goals={self.goals!r}")
        if self.inverse is not None:
            arguments.append(f"inverse={self.inverse!r}")
        return f"GoalBabbling({', '.join(arguments)})"


def _goals(value: object) -> Box | GoalSampler:
    """Return a box as a Box, and a sampler as it is, or say what is wrong."""
    is_box = hasattr(value, "low") and hasattr(value, "high")
    if not is_box and _is_one(value, GoalSampler):
        return cast("GoalSampler", value)
    try:
        return Box.of(cast("BoxLike", value), name="goals")
    except TypeError as error:
        if is_box:
            raise
        raise TypeError(f"{error}; or be a GoalSampler, such as UncoveredGoals(0.02)") from None


def _is_one(value: object, protocol: type) -> bool:
    """Say whether it has the methods of a protocol; a class has them too, but is none."""
    return isinstance(value, protocol) and not isinstance(value, type)


def _kind(value: object) -> str:
    return f"the class {value.__name__}" if isinstance(value, type) else type(value).__name__
