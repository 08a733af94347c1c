"""FunctionCredit: credit by a plain function of one's own."""

from __future__ import annotations

from typing import TYPE_CHECKING

from divbandit._checks import real

if TYPE_CHECKING:
    from collections.abc import Callable

    import numpy as np
    from numpy.typing import NDArray

    from divbandit.history import History
    from divbandit.strategies.base import Trial


class FunctionCredit:
    """What a function makes of an effect and the history, of which the effect is the newest.

    A bandit takes the function itself as well, as one whose credits have no bound. It sees the
    history as it is when the effect is told, so effects are told one by one.

    Parameters
    ----------
    function : callable
        ``function(effect, history) -> float``, with the effect of shape (s,). To save a bandit
        by pickle it must be picklable, as functions with a name of their own are.
    bound : float
        What no credit exceeds; 0.0 where there is no such bound.

    Attributes
    ----------
    function, bound
        As given.

    Raises
    ------
    TypeError, ValueError
        If `function` is not callable, or `bound` is no number or negative.

    Examples
    --------
    >>> import divbandit as db
    >>> from divbandit.bandits import FunctionCredit, Proportional, Window
    >>> def height(effect, history):
    ...     return max(0.0, float(effect[1]))
    >>> babblings = [db.MotorBabbling(), db.GoalBabbling(0.05)]
    >>> credit = FunctionCredit(height, bound=1.0)
    >>> bandit = db.Bandit(babblings, credit=credit, memory=Window(50), rule=Proportional())
    >>> len(db.explore(db.PlanarArm(20), bandit, n=100, rng=0))
    100
    """

    def __init__(
        self,
        function: Callable[[NDArray[np.float64], History], float],
        *,
        bound: float = 0.0,
    ) -> None:
        if not callable(function):
            raise TypeError(
                "function must be callable, of an effect and a history, "
                f"got {type(function).__name__}"
            )
        self.function = function
        self.bound = real("bound", bound, low=0.0)

    def largest(self, dim: int) -> float:
        """Return what no credit exceeds, as given."""
        del dim
        return self.bound

    def of(self, trial: Trial, effect: NDArray[np.float64], history: History) -> float:
        """Return what the function does."""
        del trial
        return self.function(effect, history)

    def __repr__(self) -> str:
        return f"FunctionCredit({self.function!r}, bound={self.bound!r})"
