"""Thompson: each strategy as often as it is likely to be the best."""

from __future__ import annotations

from dataclasses import dataclass

from divbandit import _core
from divbandit._value import Value


@dataclass(frozen=True, init=False, repr=False)
class Thompson(Value):
    """The strategy with the largest of numbers drawn from N(m_j, B^2 / (n_j + 1)), one for each.

    Thompson sampling with Gaussian posteriors (Agrawal and Goyal 2013, "Further Optimal Regret
    Bounds for Thompson Sampling", AISTATS, 99-107), where m_j is the mean reward of strategy j and
    n_j of how many rewards; theirs divides the sum of rewards by n_j + 1. B is the largest reward
    or, where rewards have no bound, the largest absolute one so far; 1 while there is none. Each
    choice draws once for each strategy, in order.

    Examples
    --------
    >>> import numpy as np
    >>> from divbandit.bandits import Thompson, WholePast
    >>> estimates, policy = WholePast().start(2, 6.0), Thompson().start(2, 6.0)
    >>> estimates.add(1, 3.0)
    >>> rng = np.random.default_rng(0)
    >>> [policy.choose(estimates, rng)[0] for _ in range(6)]
    [0, 1, 1, 1, 1, 0]
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
        >>> from divbandit.bandits import Thompson, WholePast
        >>> estimates, policy = WholePast().start(2, 6.0), Thompson().start(2, 6.0)
        >>> policy.choose(estimates, np.random.default_rng(0))
        (0, None)
        """
        return _core.Policy(self, parts, largest)
