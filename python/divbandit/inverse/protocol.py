"""InverseModel: what turns the goals of goal babbling into commands."""

from __future__ import annotations

from typing import TYPE_CHECKING, Protocol, runtime_checkable

if TYPE_CHECKING:
    from numpy.random import Generator
    from numpy.typing import ArrayLike

    from divbandit.history import History


@runtime_checkable
class InverseModel(Protocol):
    """Turns goals into commands. Any object with this method will do; no base class is needed.

    A model may also have a method ``start(history)`` that returns the model for one exploration;
    without it, each exploration uses a copy.

    See Also
    --------
    Nearest, KNearest, LocalRegression, LocalJacobian, LineVariation, Crossover

    Examples
    --------
    Half of the coordinates drawn again:

    >>> import numpy as np
    >>> import divbandit as db
    >>> class Halves:
    ...     def command(self, goal, history, rng):
    ...         _, index = history.nearest(goal)
    ...         kept = rng.random(history.motor_space.dim) < 0.5
    ...         return np.where(kept, history.commands[index], history.motor_space.sample(rng))
    >>> isinstance(Halves(), db.inverse.InverseModel)
    True
    >>> run = db.explore(db.PlanarArm(3), db.GoalBabbling(inverse=Halves()), n=10, rng=0)
    """

    def command(self, goal: ArrayLike, history: History, rng: Generator) -> ArrayLike:
        """Return a command for a goal.

        Parameters
        ----------
        goal : array_like, shape (s,)
        history : History
            All that was observed so far; not empty.
        rng : numpy.random.Generator
            The only source of randomness to use.

        Returns
        -------
        array_like, shape (m,)
            A point of ``history.motor_space``.

        Examples
        --------
        >>> import numpy as np
        >>> import divbandit as db
        >>> history = db.History(db.Box([0], [1]))
        >>> history.append([0.25], [7.0])
        >>> db.inverse.Nearest(0.0).command([8.0], history, np.random.default_rng(0))
        array([0.25])
        """
