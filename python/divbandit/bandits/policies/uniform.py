"""Uniform: strategies uniformly at random."""

from __future__ import annotations

from dataclasses import dataclass

from divbandit import _core
from divbandit._value import Value


@dataclass(frozen=True, init=False, repr=False)
class Uniform(Value):
    """A strategy uniformly at random, whatever it earned. One draw a choice.

    Examples
    --------
    >>> import numpy as np
    >>> from divbandit.bandits import Uniform, WholePast
    >>> estimates, policy = WholePast().start(4, 6.0), Uniform().start(4, 6.0)
    >>> rng = np.random.default_rng(0)
    >>> [policy.choose(estimates, rng)[0] for _ in range(5)]
    [2, 1, 0, 0, 3]
    """

    def __init__(self) -> None:
        pass

    def start(self, parts: int, largest: float) -> _core.Policy:
        """Return the policy for `parts` strategies.

        Parameters
        ----------
        parts : int
        largest : float
            Upper bound of the rewards; 0.0 if there is none.

        Examples
        --------
        >>> import numpy as np
        >>> from divbandit.bandits import Uniform, WholePast
        >>> estimates, policy = WholePast().start(2, 6.0), Uniform().start(2, 6.0)
        >>> policy.choose(estimates, np.random.default_rng(0))
        (1, 0.5)
        """
        return _core.Policy(self, parts, largest)
