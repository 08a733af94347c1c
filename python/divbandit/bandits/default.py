"""default_strategy: what to begin with, when little is known about the environment."""

from __future__ import annotations

from typing import TYPE_CHECKING

from divbandit.bandits.adapt import Adapt
from divbandit.goals import UntriedGoals
from divbandit.inverse import LocalJacobian
from divbandit.strategies import GoalBabbling, MotorBabbling

if TYPE_CHECKING:
    from divbandit.box import BoxLike
    from divbandit.strategies import Strategy


def default_strategy(tau: float, *, goals: BoxLike | None = None) -> Adapt:
    """Return the library's own composition, which needs no parameter but `tau`.

    `Adapt` chooses between the two `default_strategies`, motor babbling and goals a little beyond
    what is covered, with a longer window than the paper's and in proportion to a high power of the
    diversities: nearly always the better one.

    On the arm of 20 joints with tau = 0.02 it covers (mean and standard deviation of 25
    explorations, ``rng=0`` to 24, in square metres)

    ====================================  ==============  ==============  ==============
    n                                     2000            5000            10000
    ====================================  ==============  ==============  ==============
    ``default_strategy(0.02)``            1.455 +- 0.029  2.611 +- 0.034  3.090 +- 0.013
    the paper's ADAPT, d = 0.05           1.305 +- 0.051  2.129 +- 0.110  2.639 +- 0.161
    ====================================  ==============  ==============  ==============

    where discs around all that the arm can reach would cover 3.27. Its parameters were chosen on
    this arm, and may not be the best elsewhere. It is made for many motor coordinates, few effect
    coordinates and maps that are smooth at the scale of tau. An exploration of few steps gains
    little from it.

    Parameters
    ----------
    tau : float
        Radius of the balls that effects cover, in the units of the effects; positive.
    goals : Box or object with ``low`` and ``high``, optional
        Where goals are drawn; by default the environment's sensory space. It should hold all
        effects, and may be much larger.

    Returns
    -------
    Adapt

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
    strategies = default_strategies(tau, goals=goals)
    return Adapt(strategies, tau=tau, window=200, alpha=0.05, power=8.0)


def default_strategies(tau: float, *, goals: BoxLike | None = None) -> list[Strategy]:
    """Return what `default_strategy` chooses among, for another bandit.

    Motor babbling, without which explorations may never leave where they began; and `GoalBabbling`
    with `UntriedGoals` and `LocalJacobian`: goals a little beyond the effects near which the fewest
    goals were drawn, and short steps towards them in a linear model of the commands nearby.

    Parameters
    ----------
    tau : float
        Radius of the balls that effects cover, in the units of the effects; positive.
    goals : Box or object with ``low`` and ``high``, optional
        Where goals are drawn; by default the environment's sensory space.

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
    return [MotorBabbling(), GoalBabbling(goals=untried, inverse=LocalJacobian())]
