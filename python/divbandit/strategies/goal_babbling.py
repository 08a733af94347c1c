"""GoalBabbling: a goal is drawn, and an inverse model turns it into a command."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, cast

from divbandit._checks import real
from divbandit._core import Trial
from divbandit.box import Box, BoxLike
from divbandit.goals import GoalSampler, UniformGoals
from divbandit.inverse import InverseModel, Nearest
from divbandit.strategies.base import Starter, Strategy, StrategyValue

if TYPE_CHECKING:
    from numpy.random import Generator

    from divbandit.history import History


#: The paper's perturbation.
_D = 0.05


@dataclass(frozen=True, init=False, repr=False)
class GoalBabbling(StrategyValue):
    """Random goal babbling, RGB(d) (Benureau and Oudeyer 2015, figure 2).

    A goal is drawn uniformly, and the inverse model turns it into a command: that of the observed
    effect nearest to the goal, perturbed by up to the share `d` of each motor range. `goals` and
    `inverse` put others in place of either. Until something is observed, it babbles in M.

    Parameters
    ----------
    d : float, optional
        Perturbation, a share of the motor range, in [0, 1]; 0.05 by default. Short for
        ``inverse=Nearest(d)``.
    goals : Box, object with ``low`` and ``high``, or GoalSampler, optional
        Where goals are drawn, uniformly, or what draws them; by default uniformly in the
        environment's sensory space.
    inverse : InverseModel, optional
        Turns goals into commands; in place of `d`.

    Attributes
    ----------
    d : float or None
    goals : GoalSampler or None
    inverse : InverseModel or None
        As given.

    Raises
    ------
    TypeError, ValueError
        If `d` is not a number in [0, 1], `goals` is neither a box nor a sampler, `inverse` is not
        an inverse model, or `d` is given as well.

    See Also
    --------
    divbandit.goals, divbandit.inverse

    Examples
    --------
    >>> import divbandit as db
    >>> arm = db.PlanarArm(20)
    >>> goal_babbling = db.explore(arm, db.GoalBabbling(0.05), n=1000, rng=0)
    >>> motor_babbling = db.explore(arm, db.MotorBabbling(), n=1000, rng=0)
    >>> bool(goal_babbling.coverage(0.02)[-1] > motor_babbling.coverage(0.02)[-1])
    True
    >>> other = db.GoalBabbling(goals=db.goals.FrontierGoals(0.02), inverse=db.inverse.KNearest(2))
    >>> db.explore(arm, other, n=100, rng=0).effects.shape
    (100, 2)
    """

    d: float | None
    goals: GoalSampler | None
    inverse: InverseModel | None

    def __init__(
        self,
        d: float | None = None,
        *,
        goals: BoxLike | GoalSampler | None = None,
        inverse: InverseModel | None = None,
    ) -> None:
        sampler = None if goals is None else _sampler_of(goals)
        if inverse is None:
            d = real("d", _D if d is None else d, low=0.0, high=1.0)
        elif not _is_one(inverse, InverseModel):
            raise TypeError(
                "inverse must be an InverseModel, such as LocalRegression(10, 0.05), "
                f"got {_kind(inverse)}"
            )
        elif d is not None:
            raise ValueError(
                f"d must not be given together with an inverse model, got {d!r}: write d=None"
            )
        self._set(d=d, goals=sampler, inverse=inverse)

    @property
    def sampler(self) -> GoalSampler:
        """What draws the goals."""
        return UniformGoals() if self.goals is None else self.goals

    @property
    def model(self) -> InverseModel:
        """What turns them into commands."""
        return Nearest(cast("float", self.d)) if self.inverse is None else self.inverse

    def check(self, motor_space: Box, effect_dim: int | None, *, has_goals: bool) -> None:
        """Require goals of the effects' dimension."""
        del motor_space
        check = getattr(self.sampler, "check", None)
        if check is not None:
            check(effect_dim, has_goals=has_goals)

    def start(self, start: Starter) -> Strategy:
        """Return goal babbling with the sampler and the model started."""
        sampler = start.part(self.sampler, start.history)
        return _Babbling(sampler, start.part(self.model, start.history))


class _Babbling(Strategy):
    """Goal babbling under way."""

    def __init__(self, sampler: Any, model: Any) -> None:  # noqa: ANN401 - the library's or a user's
        self._sampler, self._model = sampler, model

    def propose(self, history: History, rng: Generator) -> Trial:
        """Draw a goal and invert it.

        By default one ``rng.random()`` a coordinate of S, then of M.
        """
        if len(history) == 0:
            return Trial(history.motor_space.sample(rng))
        goal = self._sampler.sample(history, rng)
        return Trial(self._model.command(goal, history, rng), goal=goal)


def _sampler_of(value: object) -> GoalSampler:
    """Return a box as uniform goals in it, and a sampler as it is, or say what is wrong."""
    is_box = hasattr(value, "low") and hasattr(value, "high")
    if not is_box and _is_one(value, GoalSampler):
        return cast("GoalSampler", value)
    try:
        return UniformGoals(Box.of(cast("BoxLike", value), name="goals"))
    except TypeError as error:
        if is_box:
            raise
        raise TypeError(f"{error}; or be a GoalSampler, such as UncoveredGoals(0.02)") from None


def _is_one(value: object, protocol: type) -> bool:
    """Return whether an object, not a class, has the methods of a protocol."""
    return isinstance(value, protocol) and not isinstance(value, type)


def _kind(value: object) -> str:
    return f"the class {value.__name__}" if isinstance(value, type) else type(value).__name__
