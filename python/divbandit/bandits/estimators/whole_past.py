"""WholePast: all rewards alike."""

from __future__ import annotations

from dataclasses import dataclass

from divbandit import _core
from divbandit._value import Value


@dataclass(frozen=True, init=False, repr=False)
class WholePast(Value):
    """The mean of all rewards that each strategy ever earned.

    For where strategies stay as good as they are. Gains of new effects shrink as an exploration
    goes on; there the other estimators do better. Means are exact before they are rounded once.

    Examples
    --------
    >>> from divbandit.bandits import WholePast
    >>> past = WholePast().start(2, 6.0)
    >>> for reward in (0.0, 3.0, 3.0):
    ...     past.add(0, reward)
    >>> past.means, past.counts
    ([2.0, 0.0], [3.0, 0.0])
    """

    def __init__(self) -> None:
        pass

    def start(self, parts: int, largest: float) -> _core.Estimator:
        """Return the means of so many strategies, with no rewards yet.

        Parameters
        ----------
        parts : int
        largest : float
            What no reward exceeds; 0.0 where rewards have no bound.

        Examples
        --------
        >>> from divbandit.bandits import WholePast
        >>> WholePast().start(2, 6.0).counts
        [0.0, 0.0]
        """
        return _core.Estimator(self, parts, largest)
