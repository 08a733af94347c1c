"""UntriedGoals: goals beyond what is covered, where the fewest were tried."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

from divbandit._checks import positive, real, whole
from divbandit.goals.boxed import MOST_DRAWS, BoxedGoals, box_of

if TYPE_CHECKING:
    from divbandit.box import Box, BoxLike


@dataclass(frozen=True, init=False, repr=False)
class UntriedGoals(BoxedGoals):
    """Uncovered goals, nearest to those effects that the fewest earlier goals were nearest to.

    Each effect counts the goals that it was the nearest effect of. Points are drawn uniformly in
    the box of all effects, a little wider; of those that are uncovered, farther than `tau` from
    every effect, the one whose nearest effect has the smallest count is taken, the first of
    several. So an effect from which nothing new is reached, as at the border of the reachable
    space, gives way to others. A goal that is farther than `reach` times `tau` from its nearest
    effect is moved straight towards it, to that distance, as inverse models are accurate only
    nearby.

    Where all points drawn are covered, goals lie just beyond the border of what is covered: effects
    take turns, the newest first, and one around which nothing uncovered is found in a few
    directions is passed over for good. If there is none left, the goal is the last point drawn.

    A goal counts when it is drawn, whatever its outcome. Each point, and each direction, costs one
    ``rng.random()`` a coordinate, the distance beyond the border another one.

    Parameters
    ----------
    tau : float
        How far an effect covers, in the units of the effects; positive.
    candidates : int
        How many uncovered goals to choose from; at least 1. One whose nearest effect has no count
        yet is taken at once.
    tries : int
        How many points to draw at most for a goal; at least 1.
    reach : float
        How far from the nearest effect goals lie at most, in `tau`; at least 1.
    box : Box or object with ``low`` and ``high``, optional
        Where goals are drawn instead, and none beyond. Effects may lie outside of it: goals that
        would are moved to its border, however far that is.

    Attributes
    ----------
    tau, candidates, tries, reach
        As given.
    box : Box or None

    Raises
    ------
    TypeError, ValueError
        If a number is out of range, or `box` is no box.

    Examples
    --------
    >>> import numpy as np
    >>> import divbandit as db
    >>> history = db.History(db.Box([0], [1]), db.Box([0], [1]))
    >>> history.append([0.5], [0.0])
    >>> history.append([0.6], [1.0])
    >>> sampler = db.goals.UntriedGoals(0.1, reach=1.0, box=db.Box([0], [1])).start(history)
    >>> rng = np.random.default_rng(0)
    >>> sorted(round(float(sampler.sample(history, rng)[0]), 6) for _ in range(4))
    [0.1, 0.1, 0.9, 0.9]
    >>> babbling = db.GoalBabbling(0.05, goals=db.goals.UntriedGoals(0.02))
    >>> run = db.explore(db.PlanarArm(20), babbling, n=100, rng=0)
    """

    tau: float
    candidates: int
    tries: int
    reach: float
    box: Box | None

    def __init__(
        self,
        tau: float,
        *,
        candidates: int = 12,
        tries: int = 20,
        reach: float = 4.0,
        box: BoxLike | None = None,
    ) -> None:
        self._set(
            tau=positive("tau", tau),
            candidates=whole("candidates", candidates, low=1, high=MOST_DRAWS),
            tries=whole("tries", tries, low=1, high=MOST_DRAWS),
            reach=real("reach", reach, low=1.0),
            box=box_of(box),
        )

    def check(self, effect_dim: int | None, *, has_goals: bool) -> None:
        """Raise a ValueError if the box is not of the effects' dimension.

        Parameters
        ----------
        effect_dim : int or None
            Dimension of the effects; None if it is not known yet.
        has_goals : bool
            Whether the environment names a sensory space; there need not be one.

        Examples
        --------
        >>> import divbandit as db
        >>> db.goals.UntriedGoals(0.1).check(2, has_goals=False)
        """
        super().check(effect_dim, has_goals=has_goals or self.box is None)
