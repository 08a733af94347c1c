"""Exp3S: Exp3 that adapts when another strategy becomes the best."""

from __future__ import annotations

from dataclasses import dataclass

from divbandit import _core
from divbandit._checks import positive, real
from divbandit._value import Value


@dataclass(frozen=True, init=False, repr=False)
class Exp3S(Value):
    """Exp3.S: as Exp3, but no weight falls far behind.

    Auer, Cesa-Bianchi, Freund and Schapire (2002, "The Nonstochastic Multiarmed Bandit Problem",
    SIAM Journal on Computing 32(1), 48-77, figure 4). With K strategies, strategy j is chosen with
    probability p_j = (1 - gamma) w_j / (sum of w) + gamma / K. Whenever one that had been chosen
    with probability p has earned x, its weight is multiplied by exp(gamma (x / p) / K), and then
    all weights grow by e alpha / K times the sum of those before. x is the reward as a share of
    the largest, within [0, 1]; where rewards have no bound, of the largest absolute one so far.
    One draw a choice.

    Parameters
    ----------
    gamma : float
        In (0, 1].
    alpha : float
        How fast the past is forgotten, in (0, 1]; about one over the number of choices.

    Attributes
    ----------
    gamma, alpha
        As given.

    Raises
    ------
    TypeError, ValueError
        If `gamma` or `alpha` is not a number in (0, 1].

    Examples
    --------
    >>> import numpy as np
    >>> from divbandit.bandits import Exp3S, WholePast
    >>> estimates, policy = WholePast().start(2, 6.0), Exp3S(0.5, 0.01).start(2, 6.0)
    >>> policy.learn(1, 3.0, 0.5)
    >>> index, probability = policy.choose(estimates, np.random.default_rng(0))
    >>> index, round(probability, 6)
    (1, 0.530365)
    """

    gamma: float
    alpha: float

    def __init__(self, gamma: float = 0.1, alpha: float = 0.001) -> None:
        for name, value in (("gamma", gamma), ("alpha", alpha)):
            positive(name, value)
        self._set(
            gamma=real("gamma", gamma, low=0.0, high=1.0),
            alpha=real("alpha", alpha, low=0.0, high=1.0),
        )

    def start(self, parts: int, largest: float) -> _core.Policy:
        """Return the policy for `parts` strategies, all with equal weights.

        Parameters
        ----------
        parts : int
        largest : float
            Upper bound of the rewards; 0.0 if there is none.

        Examples
        --------
        >>> import numpy as np
        >>> from divbandit.bandits import Exp3S, WholePast
        >>> estimates, policy = WholePast().start(2, 6.0), Exp3S().start(2, 6.0)
        >>> policy.choose(estimates, np.random.default_rng(0))
        (1, 0.5)
        """
        return _core.Policy(self, parts, largest)
