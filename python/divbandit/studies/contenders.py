"""Contenders: the bandits that the studies compare, each with its parameters."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

from divbandit.bandits import (
    UCB,
    Bandit,
    Discounted,
    EpsilonGreedy,
    Exp3,
    Exp3S,
    Proportional,
    RecentWindow,
    RoundRobin,
    Softmax,
    Thompson,
    Uniform,
    WholePast,
    Window,
)
from divbandit.paper import setting

if TYPE_CHECKING:
    from collections.abc import Iterable

    from divbandit.bandits import Estimator, Policy
    from divbandit.strategies import Strategy


@dataclass(frozen=True)
class Contender:
    """An estimator and a policy under a name; the reward is always the newly covered area.

    Attributes
    ----------
    name : str
    estimator : Estimator
    policy : Policy
    """

    name: str
    estimator: Estimator
    policy: Policy

    def over(self, strategies: Iterable[Strategy]) -> Bandit:
        """Return the bandit over these strategies.

        Examples
        --------
        >>> import divbandit as db
        >>> len(PAPER.over([db.MotorBabbling(), db.GoalBabbling(0.05)]).strategies)
        2
        """
        return Bandit(strategies, tau=setting.TAU, estimator=self.estimator, policy=self.policy)


#: The square of 0.03: a "small bonus" is three hundredths of one scaled by the largest gain.
_SMALL = 0.0009

#: The paper's ADAPT.
PAPER = Contender("ADAPT", Window(50, head_start=1), Proportional(0.1))
#: Sharper than the paper's, by an estimator that discounts the past.
DISCOUNTED = Contender(
    "discounted ADAPT", Discounted(0.99, head_start=1), Proportional(0.05, power=8.0)
)
#: The closest to the best mixtures in the study of rules.
GREEDY = Contender("discounted greedy", Discounted(0.995, head_start=1), EpsilonGreedy(0.02))
SLIDING = Contender("SW-UCB, small bonus", RecentWindow(1000), UCB(0.6 * _SMALL))
FADING = Contender("D-UCB, small bonus", Discounted(0.999), UCB(0.6 * _SMALL))
THOMPSON = Contender("Thompson", WholePast(), Thompson())
EXP3S = Contender("Exp3.S", WholePast(), Exp3S(0.1, 0.0001))
ROUND_ROBIN = Contender("round robin", WholePast(), RoundRobin())
UNIFORM = Contender("uniform", WholePast(), Uniform())

#: All, the paper's first.
CONTENDERS = (
    PAPER,
    DISCOUNTED,
    GREEDY,
    Contender("softmax", Discounted(0.99, head_start=1), Softmax(0.005)),
    Contender("UCB1", WholePast(), UCB(2.0)),
    Contender("UCB1, small bonus", WholePast(), UCB(0.6 * _SMALL)),
    Contender("SW-UCB", RecentWindow(1000), UCB(0.6)),
    SLIDING,
    Contender("D-UCB", Discounted(0.999), UCB(2.4)),
    FADING,
    THOMPSON,
    Contender("Thompson, discounted", Discounted(0.999), Thompson()),
    Contender("Exp3", WholePast(), Exp3(0.2)),
    EXP3S,
    ROUND_ROBIN,
    UNIFORM,
)

#: Those that are compared over many strategies.
RIVALS = (PAPER, DISCOUNTED, GREEDY, SLIDING, FADING, THOMPSON, EXP3S, ROUND_ROBIN, UNIFORM)
