"""Bandits by name: which parts they are made of."""

from __future__ import annotations

from typing import TYPE_CHECKING

from divbandit.bandits.bandit import Bandit
from divbandit.bandits.estimators import Discounted, RecentWindow, WholePast
from divbandit.bandits.policies import UCB, EpsilonGreedy, Proportional

if TYPE_CHECKING:
    from collections.abc import Iterable

    from divbandit.bandits.bandit import Rewarding
    from divbandit.strategies.base import Strategy


def ucb1(
    strategies: Iterable[Strategy], *, tau: float | None = None, reward: Rewarding | None = None
) -> Bandit:
    """Return UCB1: the strategy with the largest m_j + B sqrt(2 ln t / n_j).

    Auer, Cesa-Bianchi and Fischer (2002, "Finite-time Analysis of the Multiarmed Bandit Problem",
    Machine Learning 47, 235-256), for rewards up to B: of t rewards strategy j has earned n_j, of
    mean m_j.

    Parameters
    ----------
    strategies : iterable of Strategy
    tau, reward
        What strategies are rewarded for, as in `Bandit`: exactly one of the two.

    Returns
    -------
    Bandit

    Examples
    --------
    >>> import divbandit as db
    >>> from divbandit.bandits import ucb1
    >>> bandit = ucb1([db.MotorBabbling(), db.GoalBabbling(0.05)], tau=0.02)
    >>> bandit.estimator, bandit.policy
    (WholePast(), UCB())
    >>> sorted(db.explore(db.PlanarArm(20), bandit, n=2, rng=0).choices.tolist())
    [0, 1]
    """
    return Bandit(strategies, estimator=WholePast(), policy=UCB(2.0), tau=tau, reward=reward)


def sliding_window_ucb(
    strategies: Iterable[Strategy],
    *,
    window: int,
    xi: float = 0.6,
    tau: float | None = None,
    reward: Rewarding | None = None,
) -> Bandit:
    """Return SW-UCB: the strategy with the largest m_j + B sqrt(xi ln(min(t, w)) / n_j).

    Garivier and Moulines (2008, "On Upper-Confidence Bound Policies for Non-Stationary Bandit
    Problems"; 2011, ALT, 174-188), for rewards up to B: of the last w of t rewards strategy j has
    earned n_j, of mean m_j.

    Parameters
    ----------
    strategies : iterable of Strategy
    window : int
        w, from 1 to a million.
    xi : float
        Not negative; their analysis is for more than 1/2.
    tau, reward
        What strategies are rewarded for, as in `Bandit`: exactly one of the two.

    Returns
    -------
    Bandit

    Examples
    --------
    >>> import divbandit as db
    >>> from divbandit.bandits import sliding_window_ucb
    >>> babblings = [db.MotorBabbling(), db.GoalBabbling(0.05)]
    >>> bandit = sliding_window_ucb(babblings, window=200, tau=0.02)
    >>> bandit.estimator, bandit.policy
    (RecentWindow(200), UCB(0.6))
    """
    estimator = RecentWindow(window)
    return Bandit(strategies, estimator=estimator, policy=UCB(xi), tau=tau, reward=reward)


def discounted_ucb(
    strategies: Iterable[Strategy],
    *,
    gamma: float,
    xi: float = 0.6,
    tau: float | None = None,
    reward: Rewarding | None = None,
) -> Bandit:
    """Return D-UCB: the strategy with the largest m_j + 2 B sqrt(xi ln(n) / n_j).

    Garivier and Moulines (2008, "On Upper-Confidence Bound Policies for Non-Stationary Bandit
    Problems"; 2011, ALT, 174-188), for rewards up to B: one that is k rewards old weighs gamma^k;
    n_j is the weight of those of strategy j, m_j their mean and n the weight of all.

    Parameters
    ----------
    strategies : iterable of Strategy
    gamma : float
        In (0, 1].
    xi : float
        Not negative; their analysis is for more than 1/2.
    tau, reward
        What strategies are rewarded for, as in `Bandit`: exactly one of the two.

    Returns
    -------
    Bandit

    Examples
    --------
    >>> import divbandit as db
    >>> from divbandit.bandits import discounted_ucb
    >>> babblings = [db.MotorBabbling(), db.GoalBabbling(0.05)]
    >>> bandit = discounted_ucb(babblings, gamma=0.99, xi=0.5, tau=0.02)
    >>> bandit.estimator, bandit.policy  # 2 sqrt(xi) is sqrt(4 xi)
    (Discounted(0.99), UCB())
    """
    estimator, policy = Discounted(gamma), UCB(4.0 * UCB(xi).xi)
    return Bandit(strategies, estimator=estimator, policy=policy, tau=tau, reward=reward)


def discounted_adapt(
    strategies: Iterable[Strategy],
    *,
    gamma: float = 0.99,
    alpha: float = 0.05,
    power: float = 8.0,
    tau: float | None = None,
    reward: Rewarding | None = None,
) -> Bandit:
    """Return ADAPT with an estimator that discounts the past, and a sharper choice.

    The paper's window holds a strategy's own last gains, which are old where it is seldom chosen;
    and its proportional choice hardly separates strategies of similar gains. In the three settings
    of figure 4 this combination was at most 1.5 % worse than the best fixed mixture, with the
    paper's strategies and tau (``divbandit study rules``).

    Parameters
    ----------
    strategies : iterable of Strategy
    gamma : float
        In (0, 1]; about 1 / (1 - gamma) steps are remembered.
    alpha : float
        Share of choices made uniformly at random, in [0, 1].
    power : float
        Of the mean reward, to which the other choices are in proportion. Not negative.
    tau, reward
        What strategies are rewarded for, as in `Bandit`: exactly one of the two.

    Returns
    -------
    Bandit

    Examples
    --------
    >>> import divbandit as db
    >>> from divbandit.bandits import discounted_adapt
    >>> bandit = discounted_adapt([db.MotorBabbling(), db.GoalBabbling(0.05)], tau=0.02)
    >>> bandit.estimator, bandit.policy
    (Discounted(0.99, head_start=1), Proportional(0.05, power=8.0))
    """
    estimator, policy = Discounted(gamma, head_start=1), Proportional(alpha, power=power)
    return Bandit(strategies, estimator=estimator, policy=policy, tau=tau, reward=reward)


def discounted_greedy(
    strategies: Iterable[Strategy],
    *,
    gamma: float = 0.995,
    epsilon: float = 0.02,
    tau: float | None = None,
    reward: Rewarding | None = None,
) -> Bandit:
    """Return a greedy bandit that forgets: mostly the strategy of the best recent mean.

    In the three settings of figure 4 of Benureau and Oudeyer (2015) it was at most 0.5 % worse than
    the best of 21 fixed mixtures, and of all bandits here the closest to it
    (``divbandit study rules``).

    Parameters
    ----------
    strategies : iterable of Strategy
    gamma : float
        In (0, 1]; about 1 / (1 - gamma) steps are remembered.
    epsilon : float
        Share of choices made uniformly at random, in [0, 1].
    tau, reward
        What strategies are rewarded for, as in `Bandit`: exactly one of the two.

    Returns
    -------
    Bandit

    Examples
    --------
    >>> import divbandit as db
    >>> from divbandit.bandits import discounted_greedy
    >>> bandit = discounted_greedy([db.MotorBabbling(), db.GoalBabbling(0.05)], tau=0.02)
    >>> bandit.estimator, bandit.policy
    (Discounted(0.995, head_start=1), EpsilonGreedy(0.02))
    """
    estimator, policy = Discounted(gamma, head_start=1), EpsilonGreedy(epsilon)
    return Bandit(strategies, estimator=estimator, policy=policy, tau=tau, reward=reward)
