"""KernelModel: the base of the library's inverse models, whose kernels are compiled."""

from __future__ import annotations

from typing import TYPE_CHECKING

from divbandit import _core
from divbandit._value import Value

if TYPE_CHECKING:
    import numpy as np
    from numpy.random import Generator
    from numpy.typing import ArrayLike, NDArray

    from divbandit.history import History

#: Upper limit on the effects that a model looks at.
MOST_NEIGHBOURS = 1_000_000


class KernelModel(Value):
    """The description of an inverse model, which `start` turns into a running one.

    Examples
    --------
    >>> import divbandit as db
    >>> isinstance(db.inverse.Nearest(), KernelModel)
    True
    """

    def start(self, history: History) -> _core.InverseModel:
        """Return a running model, for one history.

        Parameters
        ----------
        history : History

        Returns
        -------
        object
            Has a method ``command(goal, history, rng)``.

        Examples
        --------
        >>> import numpy as np
        >>> import divbandit as db
        >>> history = db.History(db.Box([0], [1]))
        >>> history.append([0.25], [7.0])
        >>> model = db.inverse.Nearest(0.1).start(history)
        >>> model.command([8.0], history, np.random.default_rng(0))
        array([0.27739234])
        """
        del history
        return _core.InverseModel(self)

    def command(self, goal: ArrayLike, history: History, rng: Generator) -> NDArray[np.float64]:
        """Return a command for a goal.

        Parameters
        ----------
        goal : array_like, shape (s,)
        history : History
        rng : numpy.random.Generator

        Returns
        -------
        numpy.ndarray of float64, shape (m,)
            Read-only.

        Raises
        ------
        TypeError, ValueError
            If nothing was observed yet, or `goal` is not a finite point of the sensory space; `rng`
            is then as it was.

        Examples
        --------
        >>> import numpy as np
        >>> import divbandit as db
        >>> history = db.History(db.Box([0], [1]))
        >>> history.append([0.25], [7.0])
        >>> db.inverse.Nearest(0.1).command([8.0], history, np.random.default_rng(0))
        array([0.27739234])
        """
        return self.start(history).command(goal, history, rng)
