"""FrontierGoals: goals just beyond what is covered."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

from divbandit._checks import positive, real, whole
from divbandit.goals.boxed import MOST_DRAWS, BoxedGoals, box_of

if TYPE_CHECKING:
    from divbandit.box import Box, BoxLike


@dataclass(frozen=True, init=False, repr=False)
class FrontierGoals(BoxedGoals):
    """Goals that no effect covers, between `tau` and a few `tau` from one of the effects.

    An effect and a point around it are drawn until the point is farther than `tau` from every
    effect, at most `tries` times; the last point is the goal. So the covered region grows evenly
    along its border. Where most of the box is out of reach, `UncoveredGoals` are mostly far away,
    and the few effects nearest to them are tried again and again. Each point costs s + 2 times
    ``rng.random()``; until something is observed, goals are uniform in the box.

    Parameters
    ----------
    tau : float
        How far an effect covers, in the units of the effects; positive.
    reach : float
        How far beyond an effect goals lie at most, in `tau`; at least 1.
    tries : int
        How many points to draw at most; at least 1.
    box : Box or object with ``low`` and ``high``, optional
        Where goals are drawn; by default the environment's sensory space. Points beyond it are
        moved to its border.

    Attributes
    ----------
    tau, reach, tries
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
    >>> db.goals.FrontierGoals(0.1).sample(history, np.random.default_rng(0))
    array([0.28255112])
    >>> babbling = db.GoalBabbling(0.05, goals=db.goals.FrontierGoals(0.02))
    >>> run = db.explore(db.PlanarArm(20), babbling, n=100, rng=0)
    """

    tau: float
    reach: float
    tries: int
    box: Box | None

    def __init__(
        self, tau: float, *, reach: float = 3.0, tries: int = 50, box: BoxLike | None = None
    ) -> None:
        self._set(
            tau=positive("tau", tau),
            reach=real("reach", reach, low=1.0),
            tries=whole("tries", tries, low=1, high=MOST_DRAWS),
            box=box_of(box),
        )
