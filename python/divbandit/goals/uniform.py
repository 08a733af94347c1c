"""UniformGoals: goals at random, as the paper draws them."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

from divbandit.goals.boxed import BoxedGoals, box_of

if TYPE_CHECKING:
    from divbandit.box import Box, BoxLike


@dataclass(frozen=True, init=False, repr=False)
class UniformGoals(BoxedGoals):
    """Goals uniform in a box (Benureau and Oudeyer 2015).

    What `GoalBabbling` does when it is given a box, or nothing. A goal costs one ``rng.random()`` a
    coordinate.

    Parameters
    ----------
    box : Box or object with ``low`` and ``high``, optional
        Where goals are drawn; by default the environment's sensory space.

    Attributes
    ----------
    box : Box or None

    Raises
    ------
    TypeError, ValueError
        If `box` is no box.

    Examples
    --------
    >>> import numpy as np
    >>> import divbandit as db
    >>> history = db.History(db.Box([0], [1]))
    >>> goals = db.goals.UniformGoals(db.Box([0], [10]))
    >>> goals.sample(history, np.random.default_rng(0))
    array([6.36961687])
    """

    box: Box | None

    def __init__(self, box: BoxLike | None = None) -> None:
        self._set(box=box_of(box))
