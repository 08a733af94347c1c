"""Softmax: each strategy in proportion to the exponential of its mean reward."""

from __future__ import annotations

from dataclasses import dataclass

from divbandit import _core
from divbandit._checks import positive, truth
from divbandit._value import Value


@dataclass(frozen=True, init=False, repr=False)
class Softmax(Value):
    """Strategy j with probability proportional to exp(m_j / (temperature B)), of mean reward m_j.

    Boltzmann exploration (Sutton and Barto 2018, "Reinforcement Learning: An Introduction",
    section 2.8, with means in place of preferences). B is the largest reward, or, where rewards
    have no bound, the largest absolute one so far; while there is none, all are equal. One draw a
    choice.

    Parameters
    ----------
    temperature : float
        Positive. The smaller, the more often the best is chosen.
    scaled : bool
        False makes B 1: `temperature` is then in the units of the rewards.

    Attributes
    ----------
    temperature, scaled
        As given.

    Raises
    ------
    TypeError, ValueError
        If `temperature` is not a positive number, or `scaled` neither True nor False.

    Examples
    --------
    >>> import numpy as np
    >>> from divbandit.bandits import Softmax, WholePast
    >>> estimates, policy = WholePast().start(2, 6.0), Softmax(0.5).start(2, 6.0)
    >>> estimates.add(1, 3.0)
    >>> index, probability = policy.choose(estimates, np.random.default_rng(0))
    >>> index, round(probability, 6)  # 3 is half of 6: e / (1 + e)
    (1, 0.731059)
    """

    temperature: float
    scaled: bool

    def __init__(self, temperature: float = 0.1, *, scaled: bool = True) -> None:
        self._set(temperature=positive("temperature", temperature), scaled=truth("scaled", scaled))

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
        >>> from divbandit.bandits import Softmax, WholePast
        >>> estimates, policy = WholePast().start(2, 6.0), Softmax().start(2, 6.0)
        >>> policy.choose(estimates, np.random.default_rng(0))
        (1, 0.5)
        """
        return _core.Policy(self, parts, largest)
