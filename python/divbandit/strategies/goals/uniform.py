"""UniformGoals: goals at random, as the paper draws them."""

from __future__ import annotations

from typing import TYPE_CHECKING

from divbandit._engine import bounds_of
from divbandit.strategies.goals.boxed import BoxedGoals

if TYPE_CHECKING:
    import numpy as np
    from numpy.random import Generator
    from numpy.typing import NDArray

    from divbandit import _core
    from divbandit._engine import Description
    from divbandit.history import History


class UniformGoals(BoxedGoals):
    """Goals uniform in a box (Benureau and Oudeyer 2015).

    What `GoalBabbling` does when it is given a box, or nothing.

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
    >>> import divbandit as db
    >>> arm = db.PlanarArm(20)
    >>> goals = db.UniformGoals(db.Box([0, 0], [1, 1]))
    >>> run = db.explore(arm, db.GoalBabbling(0.05, goals=goals), n=100, rng=0)
    """

    def sample(self, history: History, rng: Generator) -> NDArray[np.float64]:
        """Draw a goal: one ``rng.random()`` a coordinate.

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
            If there is no box to draw in.

        Examples
        --------
        >>> import numpy as np
        >>> import divbandit as db
        >>> history = db.History(db.Box([0], [1]))
        >>> db.UniformGoals(db.Box([0], [10])).sample(history, np.random.default_rng(0))
        array([6.36961687])
        """
        return self.box_for(history).sample(rng)

    def _describe(self, description: Description) -> _core.Bounds | None:
        del description
        return None if self.box is None else bounds_of("box", self.box)
