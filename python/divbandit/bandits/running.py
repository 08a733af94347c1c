"""RunningBandit: what a bandit does during an exploration - reward, remember, choose."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from divbandit._checks import real
from divbandit.bandits.estimators import Estimates
from divbandit.bandits.rewards import RunningReward
from divbandit.strategies.composite import Composite

if TYPE_CHECKING:
    from collections.abc import Sequence

    import numpy as np
    from numpy.typing import NDArray

    from divbandit._core import Trial
    from divbandit.bandits.estimators import Estimator
    from divbandit.bandits.rewards import Reward
    from divbandit.strategies.base import Starter, Strategy

#: Rewards beyond this could not be summed up.
_MOST = 1e300

#: The dimension that is assumed until the first effect.
_PLANE = 2


class RunningBandit(Composite):
    """Strategies under way, the reward that they are paid, and the estimator of their rewards.

    What depends on the dimension of the effects starts with the first effect, unless it is known
    before. A failed trial earns 0.
    """

    def __init__(
        self, strategies: Sequence[Strategy], reward: Reward, estimator: Estimator, start: Starter
    ) -> None:
        super().__init__(map(start, strategies))
        self._start = start
        self._history = start.history
        self._rewarding: Any = start.value_or_copy(reward)
        self._estimator = estimator
        self._reward: Any = None  # under way, once the dimension of the effects is known
        self._failed: list[Trial] = []  # before that
        dim = self._history.effect_dim
        if dim is None:
            try:
                self._largest = largest_of(self._rewarding, _PLANE)
            except ValueError:  # raised with the first effect, when its dimension is known
                self._largest = 0.0
        else:
            self._largest = largest_of(self._rewarding, dim)
            self._reward = self._started_reward(dim)
        self._estimate()

    def _estimate(self) -> None:
        """Start the estimator."""
        parts = len(self.strategies)
        started = self._start.part(self._estimator, parts, self._largest)
        self.estimator: Any = under_way("estimator", started, Estimates)
        _check_numbers("estimator.means", self.estimator.means, parts)
        _check_numbers("estimator.counts", self.estimator.counts, parts)

    def _started_reward(self, dim: int) -> Any:  # noqa: ANN401 - the library's or a user's
        return under_way("reward", self._rewarding.start(dim), RunningReward)

    def _begin(self, dim: int) -> None:
        """Start what depends on the dimension of the effects."""
        self._reward = self._started_reward(dim)
        largest, failed = largest_of(self._rewarding, dim), self._failed
        self._failed = []
        if largest != self._largest:
            self._largest = largest
            self._estimate()
            for trial in failed:
                self.learn(trial, 0.0)

    @property
    def estimates(self) -> tuple[float, ...]:
        """The mean reward of each strategy, as the next choice uses it."""
        return tuple(self.estimator.means)

    def reward_of(self, trial: Trial, effect: NDArray[np.float64]) -> float:
        """Return the reward of a trial, whose effect is the newest of the history."""
        if self._reward is None:
            self._begin(len(effect))
        reward = self._reward.of(trial, effect, self._history)
        if type(reward) is not float or not -_MOST <= reward <= _MOST:
            reward = real("reward", reward, low=-_MOST, high=_MOST)
        return reward

    def learn(self, trial: Trial, reward: float) -> None:
        """Remember the reward of the strategy that proposed a trial."""
        self.estimator.add(trial.path[0], reward)

    def observe(self, trial: Trial, effect: NDArray[np.float64]) -> None:
        """Reward the strategy that proposed the trial."""
        reward = self.reward_of(trial, effect)
        super().observe(trial, effect)
        self.learn(trial, reward)

    def fail(self, trial: Trial, reason: str) -> None:
        """Reward the strategy that proposed the trial with 0."""
        super().fail(trial, reason)
        if self._reward is None:
            self._failed.append(trial)
        self.learn(trial, 0.0)


def largest_of(reward: Reward, dim: int) -> float:
    """Return the upper bound of the rewards of effects of dimension `dim`."""
    return real("reward.largest()", reward.largest(dim), low=0.0, high=_MOST)


def under_way(name: str, running: Any, kind: type) -> Any:  # noqa: ANN401 - of any kind
    """Return what the `start` of a part returned, or say what is wrong with it."""
    if isinstance(running, type) or not isinstance(running, kind):
        got = (
            f"the class {running.__name__}" if isinstance(running, type) else type(running).__name__
        )
        raise TypeError(f"{name}.start() must return what is like {kind.__name__}, got {got}")
    return running


def _check_numbers(name: str, values: Any, parts: int) -> None:  # noqa: ANN401 - a user's
    """Raise unless there is a number for each strategy."""
    try:
        found = len(values)
    except TypeError:
        raise TypeError(f"{name} must be a list of numbers, got {type(values).__name__}") from None
    if found != parts:
        raise ValueError(f"{name} must hold one number for each of {parts} strategies, got {found}")
    for index, value in enumerate(values):
        real(f"{name}[{index}]", value)
