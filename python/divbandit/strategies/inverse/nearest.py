"""NearestNeighbor: the command of the nearest effect, perturbed."""

from __future__ import annotations

from typing import TYPE_CHECKING

from divbandit._checks import real

if TYPE_CHECKING:
    import numpy as np
    from numpy.random import Generator
    from numpy.typing import ArrayLike, NDArray

    from divbandit._engine import Description
    from divbandit.history import History


class NearestNeighbor:
    """Inverse_d: the command of the effect nearest to the goal (Benureau and Oudeyer 2015).

    What `GoalBabbling` does when it is given `d` alone.

    Parameters
    ----------
    d : float
        Perturbation, a share of the motor range, in [0, 1].

    Attributes
    ----------
    d : float

    Raises
    ------
    TypeError, ValueError
        If `d` is not a number in [0, 1].

    Examples
    --------
    >>> import divbandit as db
    >>> babbling = db.GoalBabbling(inverse=db.NearestNeighbor(0.05))
    >>> run = db.explore(db.PlanarArm(20), babbling, n=100, rng=0)
    """

    def __init__(self, d: float = 0.05) -> None:
        self.d = real("d", d, low=0.0, high=1.0)

    def command(self, goal: ArrayLike, history: History, rng: Generator) -> NDArray[np.float64]:
        """Return ``history.inverse(goal, rng, d=d)``: one ``rng.random()`` a motor coordinate.

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
        >>> db.NearestNeighbor(0.1).command([8.0], history, np.random.default_rng(0))
        array([0.27739234])
        """
        return history.inverse(goal, rng, d=self.d)

    def _describe(self, description: Description) -> float:
        del description
        return self.d

    def __repr__(self) -> str:
        return f"NearestNeighbor({self.d!r})"
