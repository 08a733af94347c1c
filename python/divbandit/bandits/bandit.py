"""Bandit: strategies chosen among by a policy, given the estimates of their rewards."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

from divbandit._checks import real, whole
from divbandit.bandits.estimators import Estimator
from divbandit.bandits.policies import Policy, RunningPolicy
from divbandit.bandits.rewards import FunctionReward, Gain, Reward
from divbandit.bandits.running import RunningBandit, largest_of, under_way
from divbandit.measures import BallCoverage
from divbandit.strategies.composite import CompositeValue, strategies_of

if TYPE_CHECKING:
    from collections.abc import Callable, Iterable

    import numpy as np
    from numpy.random import Generator
    from numpy.typing import NDArray

    from divbandit._core import Trial
    from divbandit.box import Box
    from divbandit.history import History
    from divbandit.strategies.base import Starter, Strategy

    Rewarding = Reward | Callable[[NDArray[np.float64], History], float]


class RewardedValue(CompositeValue):
    """A bandit of the library: it has `tau`, or another `reward`."""

    tau: float | None
    reward: Reward | None

    @property
    def rewarding(self) -> Reward:
        """The reward: the gain in coverage with radius `tau`, or the one given."""
        return Gain(BallCoverage(self.tau)) if self.reward is None else self.reward  # type: ignore[arg-type]

    def check(self, motor_space: Box, effect_dim: int | None, *, has_goals: bool) -> None:
        """Require effects of a dimension that can be rewarded."""
        super().check(motor_space, effect_dim, has_goals=has_goals)
        if effect_dim is not None:
            try:
                largest_of(self.rewarding, effect_dim)
            except ValueError as error:
                raise ValueError(
                    f"effects must be of a dimension that {type(self).__name__} takes, "
                    f"got {effect_dim}: {error}"
                ) from None


@dataclass(frozen=True, init=False, repr=False)
class Bandit(RewardedValue):
    """A bandit in three parts: a reward, an estimator of its means, a policy that chooses.

    Each effect earns a *reward* for the strategy that produced it. An *estimator* holds the mean
    reward of each, and a *policy* chooses by these estimates which strategy proposes next. Any
    reward, estimator and policy go together; `Adapt`, `ucb1` and others are well-known
    combinations. A failed trial earns 0.

    Parameters
    ----------
    strategies : iterable of Strategy
        Those to choose among; they may be bandits themselves.
    estimator : Estimator
        For instance ``Window(50)``.
    policy : Policy
        For instance ``Proportional(alpha=0.1)``.
    tau : float, optional
        Radius of the balls whose newly covered area or volume is the reward, in the units of the
        effects. Short for ``reward=Gain(BallCoverage(tau))``.
    reward : Reward or callable, optional
        In place of `tau`: for instance ``CompetenceProgress()``, or a function
        ``(effect, history) -> float``.

    Attributes
    ----------
    strategies : tuple of Strategy
    estimator, policy, tau, reward
        As given.

    Raises
    ------
    TypeError, ValueError
        If a strategy is not one, a part is not what it must be, or not exactly one of `tau` and
        `reward` is given.

    Examples
    --------
    >>> import divbandit as db
    >>> from divbandit.bandits import CompetenceProgress, Discounted, Softmax
    >>> babblings = [db.GoalBabbling(d) for d in (0.001, 0.05, 0.5)]
    >>> bandit = db.Bandit(
    ...     babblings, reward=CompetenceProgress(), estimator=Discounted(0.99), policy=Softmax(0.1)
    ... )
    >>> run = db.explore(db.PlanarArm(20), bandit, n=500, rng=0)
    >>> run.estimates.shape  # the mean rewards before each choice
    (500, 3)
    """

    strategies: tuple[Strategy, ...]
    estimator: Estimator
    policy: Policy
    tau: float | None
    reward: Reward | None

    def __init__(
        self,
        strategies: Iterable[Strategy],
        *,
        estimator: Estimator,
        policy: Policy,
        tau: float | None = None,
        reward: Rewarding | None = None,
    ) -> None:
        radius, paid = tau_or_reward(tau, reward)
        self._set(
            strategies=strategies_of(strategies),
            estimator=part_of("estimator", estimator, Estimator, "Window(50)"),
            policy=part_of("policy", policy, Policy, "Proportional(0.1)"),
            tau=radius,
            reward=paid,
        )

    def start(self, start: Starter) -> Strategy:
        """Return the bandit under way."""
        return _Choosing(self, start)


class _Choosing(RunningBandit):
    """A bandit under way: the policy chooses."""

    def __init__(self, bandit: Bandit, start: Starter) -> None:
        self._policy = bandit.policy
        super().__init__(bandit.strategies, bandit.rewarding, bandit.estimator, start)

    def _estimate(self) -> None:
        super()._estimate()
        started = self._start.part(self._policy, len(self.strategies), self._largest)
        self.policy: Any = under_way("policy", started, RunningPolicy)
        self._learns = hasattr(self.policy, "learn")

    def choose(self, history: History, rng: Generator) -> tuple[int, float | None]:
        """Return the policy's choice; the policy says how many ``rng.random()`` it draws."""
        del history
        chosen = self.policy.choose(self.estimator, rng)
        pair = chosen if isinstance(chosen, tuple) else (chosen, None)
        if len(pair) != 2:
            raise ValueError(
                "policy.choose() must be an index, or a pair of an index and a probability, "
                f"got {len(pair)} values"
            )
        index, probability = pair
        last = len(self.strategies) - 1
        return whole("policy.choose()", index, low=0, high=last), _probability(probability)

    def learn(self, trial: Trial, reward: float) -> None:
        """Let the estimator and the policy learn."""
        super().learn(trial, reward)
        if self._learns:
            self.policy.learn(trial.path[0], reward, trial.probability)


def tau_or_reward(tau: float | None, reward: Any) -> tuple[float | None, Reward | None]:  # noqa: ANN401
    """Return the radius of the balls that gains are measured by, or else the reward."""
    if reward is None:
        if tau is None:
            raise ValueError("tau must be given, or reward: what strategies are rewarded for")
        return BallCoverage(tau).tau, None
    if tau is not None:
        raise ValueError(
            f"tau must not be given together with a reward, got {tau!r}: write tau=None"
        )
    if callable(reward) and not isinstance(reward, (type, Reward)):
        return None, FunctionReward(reward)
    return None, part_of(
        "reward", reward, Reward, "Gain(measure) or a function of effect and history"
    )


def part_of(name: str, value: Any, kind: type, example: str) -> Any:  # noqa: ANN401 - of any kind
    """Return a part of a bandit that has the members of a protocol, or say what is wrong."""
    if isinstance(value, type) or not isinstance(value, kind):
        got = f"the class {value.__name__}" if isinstance(value, type) else type(value).__name__
        article = "an" if kind.__name__.startswith("E") else "a"
        raise TypeError(f"{name} must be {article} {kind.__name__}, such as {example}, got {got}")
    return value


def _probability(probability: object) -> float | None:
    """Return the probability of a choice as a float, if it is known."""
    if probability is None:
        return None
    number = real("probability of policy.choose()", probability, low=0.0, high=1.0 + 1e-9)
    if number == 0.0:
        raise ValueError(
            "probability of policy.choose() must be positive for what it chose, got 0.0"
        )
    return min(1.0, number)  # sums and products of probabilities are rounded
