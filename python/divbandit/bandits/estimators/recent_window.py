"""RecentWindow: the last rewards of all strategies together."""

from __future__ import annotations

from dataclasses import dataclass

from divbandit import _core
from divbandit._checks import whole
from divbandit._value import Value
from divbandit.bandits.estimators.window import LONGEST


@dataclass(frozen=True, init=False, repr=False)
class RecentWindow(Value):
    """The mean of each strategy's rewards among the last `size` rewards of all of them.

    The estimator of SW-UCB (Garivier and Moulines 2008, "On Upper-Confidence Bound Policies for
    Non-Stationary Bandit Problems"; 2011, ALT, 174-188). A strategy that was not chosen for `size`
    steps counts as never tried. Means are rounded only once.

    Parameters
    ----------
    size : int
        How many rewards, from 1 to a million.

    Attributes
    ----------
    size : int

    Raises
    ------
    TypeError, ValueError
        If `size` is not whole or out of range.

    Examples
    --------
    >>> from divbandit.bandits import RecentWindow
    >>> recent = RecentWindow(3).start(2, 6.0)
    >>> for part, reward in ((0, 6.0), (0, 2.0), (1, 5.0), (0, 3.0)):
    ...     recent.add(part, reward)
    >>> recent.means, recent.counts
    ([2.5, 5.0], [2.0, 1.0])
    """

    size: int

    def __init__(self, size: int) -> None:
        self._set(size=whole("size", size, low=1, high=LONGEST))

    def start(self, parts: int, largest: float) -> _core.Estimator:
        """Return an empty window for `parts` strategies.

        Parameters
        ----------
        parts : int
        largest : float
            Upper bound of the rewards; 0.0 if there is none.

        Examples
        --------
        >>> from divbandit.bandits import RecentWindow
        >>> RecentWindow(3).start(2, 6.0).counts
        [0.0, 0.0]
        """
        return _core.Estimator(self, parts, largest)
