"""default_strategy: what to begin with, when little is known about the environment."""

from __future__ import annotations

from typing import TYPE_CHECKING

from divbandit.bandits.published import discounted_adapt
from divbandit.bandits.rewards import Gain
from divbandit.goals import UntriedGoals
from divbandit.inverse import Crossover, LineVariation, LocalJacobian
from divbandit.measures import BallCoverage
from divbandit.strategies import GoalBabbling, MotorBabbling

if TYPE_CHECKING:
    from divbandit.bandits.bandit import Bandit
    from divbandit.box import BoxLike
    from divbandit.strategies import Strategy


#: Of gains in four and more dimensions, as a share of a ball: a bandit averages many.
_ACCURACY = 0.05


def default_strategy(tau: float, *, goals: BoxLike | None = None) -> Bandit:
    """Return the library's own composition, which needs no parameter but `tau`.

    The paper's answer to not knowing which strategy is good here: a bandit, `discounted_adapt`,
    chooses among the five `default_strategies` in proportion to a high power of their recent gains,
    which is nearly always the best one. In four and more dimensions gains are estimated, to a
    twentieth of a ball.

    On equal numbers of evaluations it covers more than the paper's ADAPT and than the algorithms of
    pyribs on nearly all of the field's problems that are in ``divbandit benchmark``: see
    docs/benchmarks.md, also for those where it does not, and for those on which its parameters were
    chosen.

    Parameters
    ----------
    tau : float
        Radius of the balls that effects cover, in the units of the effects; positive.
    goals : Box or object with ``low`` and ``high``, optional
        Where goals are drawn; by default around the effects observed so far.

    Returns
    -------
    Bandit

    Raises
    ------
    TypeError, ValueError
        If `tau` is not positive, or `goals` is no box.

    Examples
    --------
    >>> import divbandit as db
    >>> arm = db.PlanarArm(20)
    >>> run = db.explore(arm, db.default_strategy(0.02), n=1000, rng=0)
    >>> adapt = db.Adapt([db.MotorBabbling(), db.GoalBabbling(0.05)], tau=0.02)
    >>> papers = db.explore(arm, adapt, n=1000, rng=0)
    >>> bool(run.coverage(0.02)[-1] > papers.coverage(0.02)[-1])
    True
    """
    reward = Gain(BallCoverage(tau, accuracy=_ACCURACY))
    strategies = default_strategies(tau, goals=goals)
    return discounted_adapt(strategies, gamma=0.995, power=16.0, reward=reward)


def default_strategies(tau: float, *, goals: BoxLike | None = None) -> list[Strategy]:
    """Return what `default_strategy` chooses among, for another bandit.

    Motor babbling, without which explorations may never leave where they began; and goal babbling
    with `UntriedGoals`, a little beyond the effects near which the fewest goals were drawn, and
    four inverse models, each good where the others are not: `LocalJacobian` with long steps in a
    linear model, where few effects are known or the environment is nearly linear, and with short
    ones, where it is not; `LineVariation`, where commands have many coordinates that act together;
    `Crossover`, where each contributes by itself.

    Parameters
    ----------
    tau : float
        Radius of the balls that effects cover, in the units of the effects; positive.
    goals : Box or object with ``low`` and ``high``, optional
        Where goals are drawn; by default around the effects observed so far.

    Returns
    -------
    list of Strategy

    Raises
    ------
    TypeError, ValueError
        If `tau` is not positive, or `goals` is no box.

    Examples
    --------
    >>> import divbandit as db
    >>> from divbandit.bandits import Discounted, EpsilonGreedy, default_strategies
    >>> strategies = [*default_strategies(0.02), db.GoalBabbling(0.05)]
    >>> bandit = db.Bandit(
    ...     strategies, tau=0.02, estimator=Discounted(0.995), policy=EpsilonGreedy(0.02)
    ... )
    >>> run = db.explore(db.PlanarArm(20), bandit, n=100, rng=0)
    """
    untried = UntriedGoals(tau, box=goals)
    models = LocalJacobian(reach=0.2), LocalJacobian(), LineVariation(), Crossover()
    return [MotorBabbling(), *(GoalBabbling(goals=untried, inverse=model) for model in models)]
