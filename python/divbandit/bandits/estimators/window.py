"""Window: the last rewards of each strategy, as in the paper."""

from __future__ import annotations

from dataclasses import dataclass

from divbandit import _core
from divbandit._checks import whole
from divbandit._value import Value

#: Upper limit on the window, all of whose rewards are stored.
LONGEST = 1_000_000


@dataclass(frozen=True, init=False, repr=False)
class Window(Value):
    """The mean of the last `size` rewards of each strategy, whenever it earned them.

    Benureau and Oudeyer 2015. The old rewards of a strategy that is seldom chosen count until it is
    chosen again; `RecentWindow` and `Discounted` forget with time. Means are rounded only once:
    they depend on the rewards in the window alone, and never drift.

    Parameters
    ----------
    size : int
        w, from 1 to a million.
    head_start : int
        How many fictitious rewards, each the largest possible, come first in each window, from 0
        to `size`; `counts` counts them. They leave it when real ones have followed. Where rewards
        have no bound they are 0.0.

    Attributes
    ----------
    size, head_start
        As given.

    Raises
    ------
    TypeError, ValueError
        If a number is not whole or out of range.

    Examples
    --------
    >>> from divbandit.bandits import Window
    >>> window = Window(3, head_start=1).start(2, 6.0)
    >>> for reward in (0.0, 3.0, 3.0):
    ...     window.add(0, reward)
    >>> window.means, window.counts
    ([2.0, 6.0], [3.0, 1.0])
    """

    size: int
    head_start: int

    def __init__(self, size: int = 50, *, head_start: int = 1) -> None:
        size = whole("size", size, low=1, high=LONGEST)
        self._set(size=size, head_start=whole("head_start", head_start, low=0, high=size))

    def start(self, parts: int, largest: float) -> _core.Estimator:
        """Return windows for `parts` strategies, with the head starts alone.

        Parameters
        ----------
        parts : int
        largest : float
            Upper bound of the rewards; 0.0 if there is none.

        Examples
        --------
        >>> from divbandit.bandits import Window
        >>> window = Window(3, head_start=2).start(2, 6.0)
        >>> window.means, window.counts
        ([6.0, 6.0], [2.0, 2.0])
        """
        return _core.Estimator(self, parts, largest)
