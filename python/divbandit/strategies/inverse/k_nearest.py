"""KNearest: a command between those of the nearest effects, perturbed."""

from __future__ import annotations

from typing import TYPE_CHECKING

from divbandit import _core
from divbandit._checks import real, whole

if TYPE_CHECKING:
    import numpy as np
    from numpy.random import Generator
    from numpy.typing import ArrayLike, NDArray

    from divbandit.history import History

#: More neighbours than anybody waits for.
MOST_NEIGHBOURS = 1_000_000


class KNearest:
    """The weighted mean of the commands of the `k` effects nearest to the goal, perturbed.

    A command's weight is 1 over the distance of its effect from the goal (Shepard 1968); effects
    that are the goal itself share all of it. With `k` of 1 it is `NearestNeighbor`. The mean of
    commands that reach alike places by different ways may reach another: a small `k` mixes fewer.

    Parameters
    ----------
    k : int
        How many effects; at least 1. All of them where fewer are known.
    d : float
        Perturbation, a share of the motor range, in [0, 1].

    Attributes
    ----------
    k, d
        As given.

    Raises
    ------
    TypeError, ValueError
        If a number is out of range.

    Examples
    --------
    >>> import divbandit as db
    >>> babbling = db.GoalBabbling(inverse=db.KNearest(3, 0.05))
    >>> run = db.explore(db.PlanarArm(20), babbling, n=100, rng=0)
    """

    def __init__(self, k: int = 3, d: float = 0.05) -> None:
        self.k = whole("k", k, low=1, high=MOST_NEIGHBOURS)
        self.d = real("d", d, low=0.0, high=1.0)

    def command(self, goal: ArrayLike, history: History, rng: Generator) -> NDArray[np.float64]:
        """Return a command: one ``rng.random()`` a motor coordinate.

        Parameters
        ----------
        goal : array_like, shape (s,)
        history : History
        rng : numpy.random.Generator

        Returns
        -------
        numpy.ndarray of float64, shape (m,)

        Raises
        ------
        TypeError, ValueError
            If nothing was observed yet, or `goal` is no finite point of the sensory space.

        Examples
        --------
        >>> import numpy as np
        >>> import divbandit as db
        >>> history = db.History(db.Box([0], [1]))
        >>> history.append([0.25], [7.0])
        >>> history.append([0.75], [11.0])
        >>> db.KNearest(2, d=0.0).command([8.0], history, np.random.default_rng(0))
        array([0.375])
        """
        space = history.motor_space.bounds
        return _core.k_nearest(goal, self.k, self.d, history.tree, history.commands, space, rng)

    def __repr__(self) -> str:
        return f"KNearest({self.k}, {self.d!r})"
