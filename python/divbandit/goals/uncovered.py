"""UncoveredGoals: goals that no effect covers yet."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

from divbandit._checks import positive, whole
from divbandit.goals.boxed import MOST_DRAWS, BoxedGoals, box_of

if TYPE_CHECKING:
    from divbandit.box import Box, BoxLike


@dataclass(frozen=True, init=False, repr=False)
class UncoveredGoals(BoxedGoals):
    """Goals uniform among those that no effect covers.

    A point of the box is drawn until it is farther than `tau` from every effect, at most `tries`
    times; the last point is the goal. Until something is observed, the first one is. Each point
    costs one ``rng.random()`` a coordinate.

    Parameters
    ----------
    tau : float
        How far an effect covers, in the units of the effects; positive.
    tries : int
        How many points to draw at most; at least 1.
    box : Box or object with ``low`` and ``high``, optional
        Where goals are drawn; by default the environment's sensory space.

    Attributes
    ----------
    tau, tries
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
    >>> history.append([0.5], [0.6])
    >>> db.goals.UncoveredGoals(0.1).sample(history, np.random.default_rng(0))
    array([0.26978671])
    >>> babbling = db.GoalBabbling(0.05, goals=db.goals.UncoveredGoals(0.02))
    >>> run = db.explore(db.PlanarArm(20), babbling, n=100, rng=0)
    """

    tau: float
    tries: int
    box: Box | None

    def __init__(self, tau: float, *, tries: int = 20, box: BoxLike | None = None) -> None:
        self._set(
            tau=positive("tau", tau),
            tries=whole("tries", tries, low=1, high=MOST_DRAWS),
            box=box_of(box),
        )
