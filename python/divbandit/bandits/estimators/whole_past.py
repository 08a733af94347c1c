"""WholePast: all rewards alike."""

from __future__ import annotations

from dataclasses import dataclass

from divbandit import _core
from divbandit._value import Value


@dataclass(frozen=True, init=False, repr=False)
class WholePast(Value):
    """The mean of all rewards that each strategy ever earned.

    For strategies that stay equally good. Gains shrink as an exploration proceeds; the other
    estimators suit them better. Means are rounded only once.

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
        """Return an estimator for `parts` strategies, without rewards.

        Parameters
        ----------
        parts : int
        largest : float
            Upper bound of the rewards; 0.0 if there is none.

        Examples
        --------
        >>> from divbandit.bandits import WholePast
        >>> WholePast().start(2, 6.0).counts
        [0.0, 0.0]
        """
        return _core.Estimator(self, parts, largest)
