"""Proportional: each strategy in proportion to its mean reward, as in the paper."""

from __future__ import annotations

from dataclasses import dataclass

from divbandit import _core
from divbandit._checks import real
from divbandit._value import Value


@dataclass(frozen=True, init=False, repr=False)
class Proportional(Value):
    """With probability alpha uniformly at random, else in proportion to the mean reward.

    Benureau and Oudeyer 2015. With K strategies of mean rewards m_j (a negative one counts as 0)
    strategy j is chosen with probability alpha / K + (1 - alpha) m_j^power / (sum of m_i^power);
    with 1 / K where no mean is positive. Always two draws a choice.

    Parameters
    ----------
    alpha : float
        Share of choices made uniformly at random, in [0, 1].
    power : float
        The larger, the more often the best is chosen. Not negative; 1 is the paper's, with 0
        all whose mean is positive are equal.

    Attributes
    ----------
    alpha, power
        As given.

    Raises
    ------
    TypeError, ValueError
        If a number is out of range.

    Examples
    --------
    >>> import numpy as np
    >>> from divbandit.bandits import Proportional, WholePast
    >>> estimates, policy = WholePast().start(2, 6.0), Proportional(alpha=0.0).start(2, 6.0)
    >>> estimates.add(0, 1.0)
    >>> estimates.add(1, 3.0)
    >>> policy.choose(estimates, np.random.default_rng(0))
    (1, 0.75)
    """

    alpha: float
    power: float

    def __init__(self, alpha: float = 0.1, *, power: float = 1.0) -> None:
        self._set(
            alpha=real("alpha", alpha, low=0.0, high=1.0), power=real("power", power, low=0.0)
        )

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
        >>> from divbandit.bandits import Proportional, WholePast
        >>> estimates, policy = WholePast().start(2, 6.0), Proportional().start(2, 6.0)
        >>> policy.choose(estimates, np.random.default_rng(0))
        (0, 0.5)
        """
        return _core.Policy(self, parts, largest)
