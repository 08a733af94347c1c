"""FrontierGoals: goals just beyond what is covered."""

from __future__ import annotations

from typing import TYPE_CHECKING

from divbandit import _core
from divbandit._checks import positive, real, whole
from divbandit.strategies.goals.boxed import MOST_DRAWS, BoxedGoals

if TYPE_CHECKING:
    import numpy as np
    from numpy.random import Generator
    from numpy.typing import NDArray

    from divbandit.box import BoxLike
    from divbandit.history import History


class FrontierGoals(BoxedGoals):
    """Goals that no effect covers, between `tau` and a few `tau` from the nearest effect.

    A goal is drawn as `UncoveredGoals` draws it, and then moved straight towards the effect that
    is nearest to it, until its distance is uniform between `tau` and `reach` times `tau`. On the
    way that effect stays the nearest, so that the goal remains uncovered; one that is as near as
    that already stays where it is. Effects at the border of large uncovered regions are so
    approached most often, as the nodes of a rapidly exploring random tree are (LaValle 1998).

    Parameters
    ----------
    tau : float
        How far an effect covers, in the units of the effects; positive.
    reach : float
        How far beyond an effect goals lie at most, in `tau`; at least 1.
    tries : int
        How many points to draw at most until one is uncovered; at least 1. The last one is taken
        if none is.
    box : Box or object with ``low`` and ``high``, optional
        Where goals are drawn; by default the environment's sensory space. Effects may lie
        outside of it: goals that would are moved to its border, however far that is.

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
    >>> import divbandit as db
    >>> babbling = db.GoalBabbling(0.05, goals=db.FrontierGoals(0.02))
    >>> run = db.explore(db.PlanarArm(20), babbling, n=100, rng=0)
    """

    def __init__(
        self, tau: float, *, reach: float = 3.0, tries: int = 20, box: BoxLike | None = None
    ) -> None:
        super().__init__(box)
        self.tau = positive("tau", tau)
        self.reach = real("reach", reach, low=1.0)
        self.tries = whole("tries", tries, low=1, high=MOST_DRAWS)

    def sample(self, history: History, rng: Generator) -> NDArray[np.float64]:
        """Draw a goal: as `UncoveredGoals` does, then one more ``rng.random()``.

        With nothing observed yet it is uniform in the box, and drawn as such.

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
        >>> db.FrontierGoals(0.1).sample(history, np.random.default_rng(0))
        array([0.15395734])
        """
        box = self.box_for(history)
        if len(history) == 0:
            return box.sample(rng)
        tree = history.tree
        return _core.frontier_goal(box.bounds, self.tau, self.reach, self.tries, tree, rng)

    def _arguments(self) -> list[str]:
        return [repr(self.tau), f"reach={self.reach!r}", f"tries={self.tries}"]
