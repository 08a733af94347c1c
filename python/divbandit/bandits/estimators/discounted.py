"""Discounted: all rewards, of which older ones weigh less."""

from __future__ import annotations

from dataclasses import dataclass

from divbandit import _core
from divbandit._checks import positive, real, whole
from divbandit._value import Value
from divbandit.bandits.estimators.window import LONGEST


@dataclass(frozen=True, init=False, repr=False)
class Discounted(Value):
    """The mean of each strategy's rewards, one that is k rewards old weighing gamma^k.

    The estimator of D-UCB (Kocsis and Szepesvari 2006, "Discounted UCB"; Garivier and Moulines
    2008, "On Upper-Confidence Bound Policies for Non-Stationary Bandit Problems"). Time is counted
    in rewards of all strategies together, so a strategy that is not chosen loses weight, which is
    what `counts` holds; its mean stays.

    Parameters
    ----------
    gamma : float
        In (0, 1]; with 1 nothing is forgotten. About 1 / (1 - gamma) rewards count.
    head_start : int
        How many fictitious rewards, each the largest possible, each strategy begins with. They come
        before all other rewards, in order, and fade like these; 0.0 where rewards have no bound.

    Attributes
    ----------
    gamma, head_start
        As given.

    Raises
    ------
    TypeError, ValueError
        If `gamma` is not a number in (0, 1], or `head_start` not a whole number from 0 to a
        million.

    Examples
    --------
    >>> from divbandit.bandits import Discounted
    >>> discounted = Discounted(0.5).start(2, 6.0)
    >>> for part, reward in ((0, 6.0), (0, 3.0), (1, 5.0)):
    ...     discounted.add(part, reward)
    >>> discounted.means, discounted.counts
    ([4.0, 5.0], [0.75, 1.0])
    """

    gamma: float
    head_start: int

    def __init__(self, gamma: float, *, head_start: int = 0) -> None:
        positive("gamma", gamma)
        self._set(
            gamma=real("gamma", gamma, low=0.0, high=1.0),
            head_start=whole("head_start", head_start, low=0, high=LONGEST),
        )

    def start(self, parts: int, largest: float) -> _core.Estimator:
        """Return an estimator for `parts` strategies, with the head starts alone.

        Parameters
        ----------
        parts : int
        largest : float
            Upper bound of the rewards; 0.0 if there is none.

        Examples
        --------
        >>> from divbandit.bandits import Discounted
        >>> discounted = Discounted(0.5, head_start=1).start(2, 6.0)
        >>> discounted.means, discounted.counts
        ([6.0, 6.0], [0.5, 1.0])
        """
        return _core.Estimator(self, parts, largest)
