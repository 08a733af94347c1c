"""MabwiserRule: a learning policy of MABWiser as the rule by which a bandit chooses."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from divbandit._library import library, seed_from
from divbandit.bandits.rules.rewards import Rewards

if TYPE_CHECKING:
    from numpy.random import Generator


class MabwiserRule:
    """A learning policy of MABWiser as a rule of a `Bandit`.

    The policy remembers by itself what it was told, the whole past; the bandit's memory says
    what is believed, and does not decide. Each part is chosen once, in order, before the policy
    is asked. It is told of credits as shares of the largest, numbers from 0 to 1; where credits
    have no bound, of the largest so far.

    Parameters
    ----------
    policy : mabwiser.mab.LearningPolicy
        One that needs no contexts, such as ``LearningPolicy.UCB1(alpha=1.0)``. Thompson sampling
        needs a ``binarizer``, which tells what share of the largest credit is a success.

    Attributes
    ----------
    policy
        As given.

    Raises
    ------
    ModuleNotFoundError
        If MABWiser is not installed.
    TypeError, ValueError
        If `policy` is none, or needs contexts or a binarizer.

    Notes
    -----
    The first choice draws one ``rng.random()``, the policy's seed, which is kept should the bandit
    begin again. Each choice after the first round that is made before any credit is known draws
    one more.

    Examples
    --------
    >>> import numpy as np
    >>> from mabwiser.mab import LearningPolicy
    >>> from divbandit.adapters import MabwiserRule
    >>> rule, rng = MabwiserRule(LearningPolicy.EpsilonGreedy(0.0)), np.random.default_rng(0)
    >>> rule.begin(2, largest=1.0)
    >>> for credit in (0.25, 0.75):
    ...     rule.learn(rule.choose(None, rng), credit, None)
    >>> rule.choose(None, rng)
    1
    """

    def __init__(self, policy: object) -> None:
        library("mabwiser", user="MabwiserRule")
        mab = library("mabwiser.mab", user="MabwiserRule")
        try:
            bandit = mab.MAB([0, 1], policy)
        except TypeError:
            raise TypeError(
                f"policy must be a LearningPolicy of MABWiser, got {type(policy).__name__}"
            ) from None
        if bandit.is_contextual:
            raise ValueError(f"policy must need no contexts, got {policy!r}")
        if isinstance(policy, mab.LearningPolicy.ThompsonSampling) and policy.binarizer is None:
            raise ValueError("policy must be given a binarizer, got ThompsonSampling without one")
        self.policy = policy
        self._seed: int | None = None
        self.begin(1, 0.0)

    def begin(self, parts: int, largest: float) -> None:
        """Forget all; there are `parts` to choose among, and no credit exceeds `largest`.

        Examples
        --------
        >>> from mabwiser.mab import LearningPolicy
        >>> from divbandit.adapters import MabwiserRule
        >>> MabwiserRule(LearningPolicy.Random()).begin(2, largest=1.0)
        """
        self._parts = parts
        self._rewards = Rewards(largest)
        self._chosen = 0
        self._has_learned = False
        self._bandit: Any = None

    def choose(self, memory: object, rng: Generator) -> int:  # noqa: ARG002 - it has its own
        """Return which part is to propose next.

        Examples
        --------
        >>> import numpy as np
        >>> from mabwiser.mab import LearningPolicy
        >>> from divbandit.adapters import MabwiserRule
        >>> rule, rng = MabwiserRule(LearningPolicy.Random()), np.random.default_rng(0)
        >>> rule.begin(2, largest=1.0)
        >>> rule.choose(None, rng), rule.choose(None, rng)
        (0, 1)
        """
        if self._seed is None:
            self._seed = seed_from(rng)
        self._chosen += 1
        if self._chosen <= self._parts:
            return self._chosen - 1
        if not self._has_learned:
            return int(rng.random() * self._parts)
        return int(self._at_work(self._seed).predict())

    def learn(self, part: int, credit: float, probability: float | None) -> None:  # noqa: ARG002 - policies weigh all alike
        """Tell the policy what a choice of this part has brought.

        Examples
        --------
        >>> import numpy as np
        >>> from mabwiser.mab import LearningPolicy
        >>> from divbandit.adapters import MabwiserRule
        >>> rule = MabwiserRule(LearningPolicy.Random())
        >>> rule.begin(2, largest=1.0)
        >>> rule.learn(rule.choose(None, np.random.default_rng(0)), 0.5, None)
        """
        if self._seed is None:
            raise ValueError("part must have been chosen before its credit is learned")
        self._at_work(self._seed).partial_fit([part], [self._rewards.of(credit)])
        self._has_learned = True

    def _at_work(self, seed: int) -> Any:  # noqa: ANN401 - MABWiser has no types
        if self._bandit is None:
            make = library("mabwiser.mab", user="MabwiserRule").MAB
            self._bandit = make(list(range(self._parts)), self.policy, seed=seed)
        return self._bandit

    def __repr__(self) -> str:
        return f"MabwiserRule({self.policy!r})"
