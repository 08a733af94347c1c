"""Exp3: weights that grow exponentially with rewards, for adversarial rewards."""

from __future__ import annotations

from dataclasses import dataclass

from divbandit import _core
from divbandit._checks import positive, real
from divbandit._value import Value


@dataclass(frozen=True, init=False, repr=False)
class Exp3(Value):
    """Strategy j of K with probability p_j = (1 - gamma) w_j / (sum of w) + gamma / K.

    Auer, Cesa-Bianchi, Freund and Schapire (2002, "The Nonstochastic Multiarmed Bandit Problem",
    SIAM Journal on Computing 32(1), 48-77, figure 1). A strategy that earned x, when it had been
    chosen with probability p, has its weight multiplied by exp(gamma (x / p) / K). x is the reward
    as a share of the largest, within [0, 1]; where rewards have no bound, of the largest absolute
    one so far. This policy keeps its own weights; the bandit's estimator, with its head start, does
    not influence it. One draw a choice.

    Parameters
    ----------
    gamma : float
        In (0, 1].

    Attributes
    ----------
    gamma : float

    Raises
    ------
    TypeError, ValueError
        If `gamma` is not a number in (0, 1].

    Examples
    --------
    >>> import numpy as np
    >>> from divbandit.bandits import Exp3, WholePast
    >>> estimates, policy = WholePast().start(2, 6.0), Exp3(0.5).start(2, 6.0)
    >>> policy.learn(1, 3.0, 0.5)  # its weight grows by exp(0.5 (0.5 / 0.5) / 2) = 1.284
    >>> index, probability = policy.choose(estimates, np.random.default_rng(0))
    >>> index, round(probability, 6)
    (1, 0.531088)
    """

    gamma: float

    def __init__(self, gamma: float = 0.1) -> None:
        positive("gamma", gamma)
        self._set(gamma=real("gamma", gamma, low=0.0, high=1.0))

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
        >>> from divbandit.bandits import Exp3, WholePast
        >>> estimates, policy = WholePast().start(2, 6.0), Exp3().start(2, 6.0)
        >>> policy.choose(estimates, np.random.default_rng(0))
        (1, 0.5)
        """
        return _core.Policy(self, parts, largest)
