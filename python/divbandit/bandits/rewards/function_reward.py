"""FunctionReward: reward by a plain function."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

from divbandit._checks import real
from divbandit._value import Value

if TYPE_CHECKING:
    from collections.abc import Callable

    import numpy as np
    from numpy.typing import NDArray

    from divbandit._core import Trial
    from divbandit.history import History


@dataclass(frozen=True, init=False, repr=False)
class FunctionReward(Value):
    """The value of a function of the newest effect and the history that ends with it.

    A bandit takes the function itself as well, as a reward without a bound.

    Parameters
    ----------
    function : callable
        ``function(effect, history) -> float``, with the effect of shape (s,).
    bound : float
        Upper bound of the rewards; 0.0 if there is none.

    Attributes
    ----------
    function, bound
        As given.

    Raises
    ------
    TypeError, ValueError
        If `function` is not callable, or `bound` is not a number or negative.

    Examples
    --------
    >>> import divbandit as db
    >>> from divbandit.bandits import FunctionReward, Proportional, Window
    >>> def height(effect, history):
    ...     return max(0.0, float(effect[1]))
    >>> babblings = [db.MotorBabbling(), db.GoalBabbling(0.05)]
    >>> reward = FunctionReward(height, bound=1.0)
    >>> bandit = db.Bandit(babblings, reward=reward, estimator=Window(50), policy=Proportional())
    >>> len(db.explore(db.PlanarArm(20), bandit, n=100, rng=0))
    100
    """

    function: Callable[[NDArray[np.float64], History], float]
    bound: float

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
        self._set(function=function, bound=real("bound", bound, low=0.0))

    def largest(self, dim: int) -> float:
        """Return the upper bound of the rewards, as given."""
        del dim
        return self.bound

    def start(self, dim: int) -> FunctionReward:
        """Return itself: it has no state."""
        del dim
        return self

    def of(self, trial: Trial, effect: NDArray[np.float64], history: History) -> Any:  # noqa: ANN401 - checked by the bandit
        """Return the value of the function."""
        del trial
        return self.function(effect, history)
