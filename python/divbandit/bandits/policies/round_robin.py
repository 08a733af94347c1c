"""RoundRobin: one strategy after another."""

from __future__ import annotations

from dataclasses import dataclass

from divbandit import _core
from divbandit._value import Value


@dataclass(frozen=True, init=False, repr=False)
class RoundRobin(Value):
    """Each strategy in turn, whatever it earned: a baseline for other policies. No draws.

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
        """Return the policy for `parts` strategies, beginning with the first.

        Parameters
        ----------
        parts : int
        largest : float
            Upper bound of the rewards; 0.0 if there is none.

        Examples
        --------
        >>> import numpy as np
        >>> from divbandit.bandits import RoundRobin, WholePast
        >>> estimates, policy = WholePast().start(2, 6.0), RoundRobin().start(2, 6.0)
        >>> policy.choose(estimates, np.random.default_rng(0))
        (0, 1.0)
        """
        return _core.Policy(self, parts, largest)
