"""NovelGoals: of a few goals the one that is least like what was observed."""

from __future__ import annotations

from typing import TYPE_CHECKING

from divbandit import _core
from divbandit._checks import whole
from divbandit.strategies.goals.boxed import MOST_DRAWS, BoxedGoals

if TYPE_CHECKING:
    import numpy as np
    from numpy.random import Generator
    from numpy.typing import NDArray

    from divbandit.box import BoxLike
    from divbandit.history import History


class NovelGoals(BoxedGoals):
    """Of a few goals uniform in a box, the one whose nearest effect is farthest away.

    It needs no scale, unlike `UncoveredGoals`; the more candidates, the more goals go where
    effects are farthest, be it that nothing can be reached there (Mitchell 1991 draws points
    like this, to spread them evenly).

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
    >>> import divbandit as db
    >>> babbling = db.GoalBabbling(0.05, goals=db.NovelGoals(4))
    >>> run = db.explore(db.PlanarArm(20), babbling, n=100, rng=0)
    """

    def __init__(self, candidates: int = 4, *, box: BoxLike | None = None) -> None:
        super().__init__(box)
        self.candidates = whole("candidates", candidates, low=1, high=MOST_DRAWS)

    def sample(self, history: History, rng: Generator) -> NDArray[np.float64]:
        """Draw a goal: one ``rng.random()`` a coordinate, for each candidate.

        With nothing observed yet there is a single candidate.

        Parameters
        ----------
        history : History
        rng : numpy.random.Generator

        Returns
        -------
        numpy.ndarray of float64, shape (s,)

        Raises
        ------
        ValueError
            If there is no box to draw in, or it is not of the effects' dimension.

        Examples
        --------
        >>> import numpy as np
        >>> import divbandit as db
        >>> history = db.History(db.Box([0], [1]), db.Box([0], [1]))
        >>> history.append([0.5], [0.6])
        >>> db.NovelGoals(3).sample(history, np.random.default_rng(0))
        array([0.04097352])
        """
        box = self.box_for(history)
        if len(history) == 0:
            return box.sample(rng)
        return _core.novel_goal(box.bounds, self.candidates, history.tree, rng)

    def _arguments(self) -> list[str]:
        return [repr(self.candidates)]
