"""Contenders: the bandits that the studies compare, each with its parameters."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

from divbandit import bandits
from divbandit.paper import setting

if TYPE_CHECKING:
    from collections.abc import Iterable

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
    estimator: bandits.Estimator
    policy: bandits.Policy

    @property
    def parts(self) -> str:
        """What it is made of."""
        return f"{self.estimator!r}, {self.policy!r}"

    def over(self, strategies: Iterable[Strategy]) -> bandits.Bandit:
        """Return the bandit over these strategies.

        Examples
        --------
        >>> import divbandit as db
        >>> len(PAPER.over([db.MotorBabbling(), db.GoalBabbling(0.05)]).strategies)
        2
        """
        return bandits.Bandit(
            strategies, tau=setting.TAU, estimator=self.estimator, policy=self.policy
        )


#: The square of 0.03: a "small bonus" is three hundredths of one scaled by the largest gain.
_SMALL = 0.0009

#: The paper's ADAPT.
PAPER = Contender("ADAPT", bandits.Window(50, head_start=1), bandits.Proportional(0.1))
#: Sharper than the paper's, by an estimator that discounts the past.
DISCOUNTED = Contender(
    "discounted ADAPT",
    bandits.Discounted(0.99, head_start=1),
    bandits.Proportional(0.05, power=8.0),
)
#: The closest to the best mixtures in the study of rules.
GREEDY = Contender(
    "discounted greedy", bandits.Discounted(0.995, head_start=1), bandits.EpsilonGreedy(0.02)
)
SLIDING = Contender("SW-UCB, small bonus", bandits.RecentWindow(1000), bandits.UCB(0.6 * _SMALL))
FADING = Contender("D-UCB, small bonus", bandits.Discounted(0.999), bandits.UCB(0.6 * _SMALL))
THOMPSON = Contender("Thompson", bandits.WholePast(), bandits.Thompson())
EXP3S = Contender("Exp3.S", bandits.WholePast(), bandits.Exp3S(0.1, 0.0001))
ROUND_ROBIN = Contender("round robin", bandits.WholePast(), bandits.RoundRobin())
UNIFORM = Contender("uniform", bandits.WholePast(), bandits.Uniform())

#: All, the paper's first.
CONTENDERS = (
    PAPER,
    DISCOUNTED,
    GREEDY,
    Contender("softmax", bandits.Discounted(0.99, head_start=1), bandits.Softmax(0.005)),
    Contender("UCB1", bandits.WholePast(), bandits.UCB(2.0)),
    Contender("UCB1, small bonus", bandits.WholePast(), bandits.UCB(0.6 * _SMALL)),
    Contender("SW-UCB", bandits.RecentWindow(1000), bandits.UCB(0.6)),
    SLIDING,
    Contender("D-UCB", bandits.Discounted(0.999), bandits.UCB(2.4)),
    FADING,
    THOMPSON,
    Contender("Thompson, discounted", bandits.Discounted(0.999), bandits.Thompson()),
    Contender("Exp3", bandits.WholePast(), bandits.Exp3(0.2)),
    EXP3S,
    ROUND_ROBIN,
    UNIFORM,
)

#: Those that are compared over many strategies.
RIVALS = (PAPER, DISCOUNTED, GREEDY, SLIDING, FADING, THOMPSON, EXP3S, ROUND_ROBIN, UNIFORM)
