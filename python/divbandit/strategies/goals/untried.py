"""UntriedGoals: goals beyond what is covered, where going on was tried least."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from divbandit import _core
from divbandit._checks import positive, real, whole
from divbandit.strategies.goals.boxed import MOST_DRAWS, BoxedGoals

if TYPE_CHECKING:
    from numpy.random import Generator
    from numpy.typing import NDArray

    from divbandit.box import BoxLike
    from divbandit.history import History


class UntriedGoals(BoxedGoals):
    """Goals that no effect covers, near effects that few goals were near before.

    Each effect counts the goals that it was the nearest effect of. A few uncovered goals are drawn
    as `UncoveredGoals` draws them, and the one whose nearest effect has the least count is taken,
    the first of several. So an effect from which nothing new was reached, be it at the border of
    what can be reached, is left alone for others. A goal that is farther than `reach` times `tau`
    from its nearest effect is moved straight towards it, to that distance, for an inverse model
    that is right only nearby.

    What was counted belongs to one history: asked about another, all begins anew. A goal counts
    when it is drawn, whatever comes of it; of many drawn before anything is observed, each so
    counts for the next.

    Parameters
    ----------
    tau : float
        How far an effect covers, in the units of the effects; positive.
    candidates : int
        How many uncovered goals to choose from; at least 1. One whose nearest effect has no count
        yet is taken at once.
    tries : int
        How many points to draw at most until one is uncovered; at least 1. The last one is taken
        if none is.
    reach : float
        How far from the nearest effect goals lie at most, in `tau`; at least 1.
    box : Box or object with ``low`` and ``high``, optional
        Where goals are drawn; by default the environment's sensory space. Effects may lie
        outside of it: goals that would are moved to its border, however far that is.

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
    >>> import divbandit as db
    >>> babbling = db.GoalBabbling(0.05, goals=db.UntriedGoals(0.02))
    >>> run = db.explore(db.PlanarArm(20), babbling, n=100, rng=0)
    """

    def __init__(
        self,
        tau: float,
        *,
        candidates: int = 12,
        tries: int = 20,
        reach: float = 4.0,
        box: BoxLike | None = None,
    ) -> None:
        super().__init__(box)
        self.tau = positive("tau", tau)
        self.candidates = whole("candidates", candidates, low=1, high=MOST_DRAWS)
        self.tries = whole("tries", tries, low=1, high=MOST_DRAWS)
        self.reach = real("reach", reach, low=1.0)
        self._history: History | None = None
        self._counts: NDArray[np.uint32] | None = None

    def sample(self, history: History, rng: Generator) -> NDArray[np.float64]:
        """Draw a goal: one ``rng.random()`` a coordinate, for each of the points drawn.

        With nothing observed yet it is uniform in the box, and nothing is counted.

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
        >>> history.append([0.5], [0.0])
        >>> history.append([0.6], [1.0])
        >>> goals, rng = db.UntriedGoals(0.1, reach=1.0), np.random.default_rng(0)
        >>> sorted(round(float(goals.sample(history, rng)[0]), 6) for _ in range(4))
        [0.1, 0.1, 0.9, 0.9]
        """
        box = self.box_for(history)
        n = len(history)
        if n == 0:
            return box.sample(rng)
        known = self._counts if history is self._history else None
        if known is None or n > len(known):
            counts = np.zeros(max(64, 2 * n), dtype=np.uint32)
            if known is not None:
                counts[: len(known)] = known
            self._history, self._counts = history, counts
            known = counts
        return _core.untried_goal(
            box.bounds,
            self.tau,
            self.candidates,
            self.tries,
            self.reach,
            history.tree,
            known,
            rng,
        )

    def _arguments(self) -> list[str]:
        return [
            repr(self.tau),
            f"candidates={self.candidates}",
            f"tries={self.tries}",
            f"reach={self.reach!r}",
        ]
