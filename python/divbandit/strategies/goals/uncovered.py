"""UncoveredGoals: goals where no effect is yet."""

from __future__ import annotations

from typing import TYPE_CHECKING

from divbandit import _core
from divbandit._checks import positive, whole
from divbandit.strategies.goals.boxed import MOST_DRAWS, BoxedGoals

if TYPE_CHECKING:
    import numpy as np
    from numpy.random import Generator
    from numpy.typing import NDArray

    from divbandit.box import BoxLike
    from divbandit.history import History


class UncoveredGoals(BoxedGoals):
    """Goals uniform among those that no effect covers.

    A point of the box is drawn until it is farther than `tau` from every effect, at most `tries`
    times; then the last one is the goal. With nothing observed yet the first is.

    Parameters
    ----------
    tau : float
        How far an effect covers, in the units of the effects; positive.
    tries : int
        How many points to draw at most; at least 1. Each costs a search for its nearest effect.
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
    >>> import divbandit as db
    >>> babbling = db.GoalBabbling(0.05, goals=db.UncoveredGoals(0.02))
    >>> run = db.explore(db.PlanarArm(20), babbling, n=100, rng=0)
    """

    def __init__(self, tau: float, *, tries: int = 20, box: BoxLike | None = None) -> None:
        super().__init__(box)
        self.tau = positive("tau", tau)
        self.tries = whole("tries", tries, low=1, high=MOST_DRAWS)

    def sample(self, history: History, rng: Generator) -> NDArray[np.float64]:
        """Draw a goal: one ``rng.random()`` a coordinate, for each of the points drawn.

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
        >>> db.UncoveredGoals(0.1).sample(history, np.random.default_rng(0))
        array([0.26978671])
        """
        box = self.box_for(history)
        if len(history) == 0:
            return box.sample(rng)
        return _core.uncovered_goal(box.bounds, self.tau, self.tries, history.tree, rng)

    def _arguments(self) -> list[str]:
        return [repr(self.tau), f"tries={self.tries}"]
