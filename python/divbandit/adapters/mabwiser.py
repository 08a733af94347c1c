"""MabwiserPolicy: a learning policy of MABWiser as the policy by which a bandit chooses."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

from divbandit._library import library, seed_from
from divbandit._value import Value

if TYPE_CHECKING:
    from numpy.random import Generator


@dataclass(frozen=True, init=False, repr=False)
class MabwiserPolicy(Value):
    """A learning policy of MABWiser as a policy of a `Bandit`.

    It keeps its own state; the bandit's estimates do not influence its choices. Each part is chosen
    once, in order, before the learning policy chooses. It learns rewards as shares of the largest,
    numbers from 0 to 1; where rewards have no bound, of the largest so far.

    Parameters
    ----------
    policy : mabwiser.mab.LearningPolicy
        One that needs no contexts, such as ``LearningPolicy.UCB1(alpha=1.0)``. Thompson sampling
        needs a ``binarizer``, which says what share of the largest reward is a success.

    Attributes
    ----------
    policy
        As given.

    Raises
    ------
    ModuleNotFoundError
        If MABWiser is not installed.
    TypeError, ValueError
        If `policy` is not a learning policy, or needs contexts or a binarizer.

    Notes
    -----
    The first choice draws one ``rng.random()``, the learning policy's seed. Each choice after the
    first round that is made before any reward is known draws one more.

    Examples
    --------
    >>> import numpy as np
    >>> from mabwiser.mab import LearningPolicy
    >>> from divbandit.adapters import MabwiserPolicy
    >>> policy = MabwiserPolicy(LearningPolicy.EpsilonGreedy(0.0))
    >>> running, rng = policy.start(2, largest=1.0), np.random.default_rng(0)
    >>> for reward in (0.25, 0.75):
    ...     running.learn(running.choose(None, rng), reward, None)
    >>> running.choose(None, rng)
    1
    """

    policy: Any

    def __init__(self, policy: object) -> None:
        library("mabwiser", user="MabwiserPolicy")
        mab = library("mabwiser.mab", user="MabwiserPolicy")
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
        self._set(policy=policy)

    def __eq__(self, other: object) -> bool:
        """MABWiser's are named tuples: those of different kinds compare equal."""
        if not isinstance(other, MabwiserPolicy):
            return NotImplemented
        return type(self.policy) is type(other.policy) and bool(self.policy == other.policy)

    def __hash__(self) -> int:
        return hash((type(self.policy), self.policy))

    def start(self, parts: int, largest: float) -> _Learning:
        """Return what chooses during one exploration.

        Parameters
        ----------
        parts : int
            How many there are to choose among.
        largest : float
            Upper bound of the rewards; 0.0 if there is none.

        Examples
        --------
        >>> import numpy as np
        >>> from mabwiser.mab import LearningPolicy
        >>> from divbandit.adapters import MabwiserPolicy
        >>> running = MabwiserPolicy(LearningPolicy.Random()).start(2, largest=1.0)
        >>> rng = np.random.default_rng(0)
        >>> running.choose(None, rng), running.choose(None, rng)
        (0, 1)
        """
        return _Learning(self.policy, parts, largest)


class _Learning:
    """A running learning policy."""

    def __init__(self, policy: object, parts: int, largest: float) -> None:
        self._policy, self._parts = policy, parts
        self._largest, self._is_bounded = largest, largest > 0.0
        self._chosen = 0
        self._bandit: Any = None  # MABWiser's, from the first choice on
        self._learned: list[tuple[int, float]] = []  # before that
        self._has_learned = False

    def choose(self, estimates: object, rng: Generator) -> int:
        """Return which part is to propose next."""
        del estimates  # it has its own
        if self._bandit is None:
            make = library("mabwiser.mab", user="MabwiserPolicy").MAB
            self._bandit = make(list(range(self._parts)), self._policy, seed=seed_from(rng))
            for part, share in self._learned:
                self._bandit.partial_fit([part], [share])
        self._chosen += 1
        if self._chosen <= self._parts:
            return self._chosen - 1
        if not self._has_learned:
            return int(rng.random() * self._parts)
        return int(self._bandit.predict())

    def learn(self, part: int, reward: float, probability: float | None) -> None:
        """Let the learning policy learn what a choice of this part has brought."""
        del probability  # all choices weigh alike
        self._has_learned = True
        share = self._share_of(reward)
        if self._bandit is None:  # the bandit started its policy again when rewards became known
            self._learned.append((part, share))
        else:
            self._bandit.partial_fit([part], [share])

    def _share_of(self, reward: float) -> float:
        """Return a reward as a share of the largest, or of the largest so far."""
        if not self._is_bounded:
            self._largest = max(self._largest, abs(reward))
        return min(1.0, reward / self._largest) if reward > 0.0 else 0.0
