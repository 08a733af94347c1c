"""RoundRobin: one strategy after another."""

from __future__ import annotations

from dataclasses import dataclass

from divbandit import _core
from divbandit._value import Value


@dataclass(frozen=True, init=False, repr=False)
class RoundRobin(Value):
    """Each strategy in turn, whatever it earned: what the other policies must beat. No draws.

    Examples
    --------
    >>> import numpy as np
    >>> from divbandit.bandits import RoundRobin, WholePast
    >>> estimates, policy = WholePast().start(2, 6.0), RoundRobin().start(2, 6.0)
    >>> rng = np.random.default_rng(0)
    >>> [policy.choose(estimates, rng)[0] for _ in range(5)]
    [0, 1, 0, 1, 0]
    """

    def __init__(self) -> None:
        pass

    def start(self, parts: int, largest: float) -> _core.Policy:
        """Return the policy for so many strategies, the first of which comes first.

        Parameters
        ----------
        parts : int
        largest : float
            What no reward exceeds; 0.0 where rewards have no bound.

        Examples
        --------
        >>> import numpy as np
        >>> from divbandit.bandits import RoundRobin, WholePast
        >>> estimates, policy = WholePast().start(2, 6.0), RoundRobin().start(2, 6.0)
        >>> policy.choose(estimates, np.random.default_rng(0))
        (0, 1.0)
        """
        return _core.Policy(self, parts, largest)
