"""NovelGoals: of a few goals, the one farthest from all observed effects."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

from divbandit._checks import whole
from divbandit.goals.boxed import MOST_DRAWS, BoxedGoals, box_of

if TYPE_CHECKING:
    from divbandit.box import Box, BoxLike


@dataclass(frozen=True, init=False, repr=False)
class NovelGoals(BoxedGoals):
    """Of a few goals uniform in a box, the one whose nearest effect is farthest away.

    Unlike `UncoveredGoals` it needs no scale. The more candidates, the more goals lie where effects
    are farthest, even where nothing can be reached (Mitchell 1991 draws points in this way to
    spread them evenly). Each candidate costs one ``rng.random()`` a coordinate; until something is
    observed there is a single one.

    Parameters
    ----------
    candidates : int
        How many goals to choose from; at least 1. Each costs a search for its nearest effect.
    box : Box or object with ``low`` and ``high``, optional
        Where goals are drawn; by default the environment's sensory space.

    Attributes
    ----------
    candidates
        As given.
    box : Box or None

    Raises
    ------
    TypeError, ValueError
        If `candidates` is out of range, or `box` is no box.

    Examples
    --------
    >>> import numpy as np
    >>> import divbandit as db
    >>> history = db.History(db.Box([0], [1]), db.Box([0], [1]))
    >>> history.append([0.5], [0.6])
    >>> db.goals.NovelGoals(3).sample(history, np.random.default_rng(0))
    array([0.04097352])
    >>> babbling = db.GoalBabbling(0.05, goals=db.goals.NovelGoals(4))
    >>> run = db.explore(db.PlanarArm(20), babbling, n=100, rng=0)
    """

    candidates: int
    box: Box | None

    def __init__(self, candidates: int = 4, *, box: BoxLike | None = None) -> None:
        self._set(
            candidates=whole("candidates", candidates, low=1, high=MOST_DRAWS), box=box_of(box)
        )
