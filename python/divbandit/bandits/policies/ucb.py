"""UCB: the strategy with the largest upper confidence bound on its mean reward."""

from __future__ import annotations

from dataclasses import dataclass

from divbandit import _core
from divbandit._checks import real
from divbandit._value import Value


@dataclass(frozen=True, init=False, repr=False)
class UCB(Value):
    """The strategy j with the largest m_j + B sqrt(xi ln(n) / n_j).

    m_j is its mean reward by the estimator, n_j the number of rewards behind that, n the sum of all
    n_j; B is the largest reward or, where rewards have no bound, the largest absolute one so far.
    The estimator decides which published policy this is:

    - with `WholePast`, UCB1 for xi = 2: m_j + B sqrt(2 ln t / n_j) (Auer, Cesa-Bianchi and Fischer
      2002, "Finite-time Analysis of the Multiarmed Bandit Problem", Machine Learning 47, 235-256);
    - with `RecentWindow`, SW-UCB: m_j + B sqrt(xi ln(min(t, w)) / n_j) (Garivier and Moulines 2008,
      "On Upper-Confidence Bound Policies for Non-Stationary Bandit Problems");
    - with `Discounted`, D-UCB of the same paper, m_j + 2 B sqrt(xi ln(n) / n_j), where a factor of
      2 before the root is one of 4 within: ``UCB(4 * xi)``.

    `ucb1`, `sliding_window_ucb` and `discounted_ucb` put these together. Strategies without rewards
    come first. Ties are broken uniformly: always one draw a choice.

    A pending trial counts as if it had earned its strategy's mean. So untried strategies take turns
    while no effect is known yet, and trials that are asked for together do not all go to one
    strategy. A trial that will never be told should be failed.

    Parameters
    ----------
    xi : float
        Weight of the confidence bound; not negative.

    Attributes
    ----------
    xi : float

    Raises
    ------
    TypeError, ValueError
        If `xi` is not a number, or negative.

    Examples
    --------
    >>> import numpy as np
    >>> from divbandit.bandits import UCB, WholePast
    >>> estimates, policy = WholePast().start(3, 6.0), UCB(2.0).start(3, 6.0)
    >>> estimates.add(1, 3.0)
    >>> rng = np.random.default_rng(0)
    >>> sorted(policy.choose(estimates, rng)[0] for _ in range(2))  # those never tried
    [0, 2]
    """

    xi: float

    def __init__(self, xi: float = 2.0) -> None:
        self._set(xi=real("xi", xi, low=0.0))

    def start(self, parts: int, largest: float) -> _core.Policy:
        """Return the policy for `parts` strategies, with no trial pending.

        Parameters
        ----------
        parts : int
        largest : float
            Upper bound of the rewards; 0.0 if there is none.

        Examples
        --------
        >>> import numpy as np
        >>> from divbandit.bandits import UCB, WholePast
        >>> estimates, policy = WholePast().start(2, 6.0), UCB().start(2, 6.0)
        >>> policy.choose(estimates, np.random.default_rng(0))
        (1, 0.5)
        """
        return _core.Policy(self, parts, largest)
