"""EpsilonGreedy: the strategy with the best mean reward, except for random choices."""

from __future__ import annotations

from dataclasses import dataclass

from divbandit import _core
from divbandit._checks import real
from divbandit._value import Value


@dataclass(frozen=True, init=False, repr=False)
class EpsilonGreedy(Value):
    """With probability epsilon uniformly at random, else the best mean reward.

    Sutton and Barto (2018, "Reinforcement Learning: An Introduction", section 2.2). Ties are broken
    uniformly. Always two draws a choice.

    Parameters
    ----------
    epsilon : float
        In [0, 1].

    Attributes
    ----------
    epsilon : float

    Raises
    ------
    TypeError, ValueError
        If `epsilon` is not a number in [0, 1].

    Examples
    --------
    >>> import numpy as np
    >>> from divbandit.bandits import EpsilonGreedy, WholePast
    >>> estimates, policy = WholePast().start(2, 6.0), EpsilonGreedy(0.5).start(2, 6.0)
    >>> estimates.add(1, 3.0)
    >>> policy.choose(estimates, np.random.default_rng(0))
    (1, 0.75)
    """

    epsilon: float

    def __init__(self, epsilon: float = 0.1) -> None:
        self._set(epsilon=real("epsilon", epsilon, low=0.0, high=1.0))

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
        >>> from divbandit.bandits import EpsilonGreedy, WholePast
        >>> estimates, policy = WholePast().start(2, 6.0), EpsilonGreedy().start(2, 6.0)
        >>> policy.choose(estimates, np.random.default_rng(0))
        (0, 0.5)
        """
        return _core.Policy(self, parts, largest)
