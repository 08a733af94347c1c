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
    """Goals that no effect covers, between `tau` and a few `tau` from one of the effects.

    An effect is taken at random, and a point around it, until that is farther than `tau` from
    every effect, at most `tries` times; then the last one is the goal. What is explored so
    grows at its border, evenly along it. `UncoveredGoals` are mostly far away where most of the
    box is out of reach, and those few effects that are nearest to it are then tried again and
    again.

    Parameters
    ----------
    tau : float
        How far an effect covers, in the units of the effects; positive.
    reach : float
        How far beyond an effect goals lie at most, in `tau`; at least 1.
    tries : int
        How many points to draw at most; at least 1. Each costs a search for its nearest effect.
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
    >>> import divbandit as db
    >>> babbling = db.GoalBabbling(0.05, goals=db.FrontierGoals(0.02))
    >>> run = db.explore(db.PlanarArm(20), babbling, n=100, rng=0)
    """

    def __init__(
        self, tau: float, *, reach: float = 3.0, tries: int = 50, box: BoxLike | None = None
    ) -> None:
        super().__init__(box)
        self.tau = positive("tau", tau)
        self.reach = real("reach", reach, low=1.0)
        self.tries = whole("tries", tries, low=1, high=MOST_DRAWS)

    def sample(self, history: History, rng: Generator) -> NDArray[np.float64]:
        """Draw a goal: ``rng.random()`` s + 2 times for each of the points drawn.

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
        array([0.28255112])
        """
        box = self.box_for(history)
        if len(history) == 0:
            return box.sample(rng)
        tree = history.tree
        return _core.frontier_goal(box.bounds, self.tau, self.reach, self.tries, tree, rng)

    def _arguments(self) -> list[str]:
        return [repr(self.tau), f"reach={self.reach!r}", f"tries={self.tries}"]
