"""OptunaSampler: a sampler of Optuna as a strategy; it optimises the reward of its effects."""

from __future__ import annotations

import threading
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

from divbandit._checks import real
from divbandit._library import library, seed_from
from divbandit.bandits import Gain, Reward
from divbandit.bandits.bandit import tau_or_reward
from divbandit.measures import BallCoverage
from divbandit.strategies import Strategy, Trial
from divbandit.strategies.base import StrategyValue

if TYPE_CHECKING:
    from collections.abc import Callable
    from types import ModuleType

    import numpy as np
    from numpy.random import Generator
    from numpy.typing import ArrayLike, NDArray
    from optuna.samplers import BaseSampler
    from optuna.study import Study
    from typing_extensions import Self

    from divbandit.bandits.rewards import RunningReward
    from divbandit.box import Box
    from divbandit.history import History
    from divbandit.strategies.base import Starter

    SamplerFactory = Callable[..., BaseSampler]
    Rewarding = Reward | Callable[[NDArray[np.float64], History], float]

#: The reward by default: the paper's.
_GAIN = Gain(BallCoverage(0.02))

#: Optuna's verbosity belongs to all threads: one at a time turns it down.
_VERBOSITY = threading.Lock()


class _OfStudy(Trial):
    """A trial that has a number in a study."""

    study_number: int

    def __new__(cls, command: ArrayLike, *, study_number: int) -> Self:
        """Make one."""
        trial = super().__new__(cls, command)
        trial.study_number = study_number
        return trial


@dataclass(frozen=True, init=False, repr=False)
class OptunaSampler(StrategyValue):
    """A sampler of Optuna as a strategy: TPE, CMA-ES, quasi-Monte Carlo and others.

    It proposes what it expects to be rewarded most, and learns the reward of each of its effects as
    it comes: by default its gain, the new area that it covered. The gain shrinks as an area fills
    up, whichever strategy fills it, which draws a sampler to what has not been found yet; how well
    it follows this moving target, a bandit finds out. The sampler knows of trials under way; a
    trial that failed has the state FAIL.

    Parameters
    ----------
    sampler : callable, optional
        What makes a sampler when it is called with ``seed=``: a class such as
        ``optuna.samplers.CmaEsSampler``, or a ``functools.partial`` of one. The default is
        ``optuna.samplers.TPESampler``.
    reward : Reward or callable, optional
        What it optimises, the larger the better: a reward as bandits have them, or a function
        ``(effect, history) -> float`` for the newest effect of the history. The default is
        ``Gain(BallCoverage(0.02))``.

    Attributes
    ----------
    sampler : callable or None
    reward : Reward or None
        As given; a function as a `FunctionReward`.

    Raises
    ------
    ModuleNotFoundError
        If Optuna is not installed.
    TypeError, ValueError
        If an argument is not what it must be, or a reward is not a finite number.

    Notes
    -----
    The first proposal draws one ``rng.random()``, the seed of the sampler, whose draws are its own.
    The study is held in memory, and not logged: ``explorer.strategy.study``, None at first.

    Examples
    --------
    >>> import divbandit as db
    >>> from divbandit.adapters import OptunaSampler
    >>> sampler = OptunaSampler(reward=db.bandits.Gain(db.measures.BallCoverage(0.05)))
    >>> adapt = db.Adapt([sampler, db.GoalBabbling(0.05)], tau=0.05)
    >>> run = db.explore(db.PlanarArm(7), adapt, n=50, rng=0)
    >>> run.effects.shape
    (50, 2)
    """

    sampler: SamplerFactory | None
    reward: Reward | None

    def __init__(
        self,
        sampler: SamplerFactory | None = None,
        *,
        reward: Rewarding | None = None,
    ) -> None:
        library("optuna", user="OptunaSampler")
        if sampler is not None and not callable(sampler):
            raise TypeError(f"sampler must be callable, got {type(sampler).__name__}")
        if reward is not None:
            _, reward = tau_or_reward(None, reward)
        self._set(sampler=sampler, reward=reward)

    @property
    def rewarding(self) -> Reward:
        """What is optimised: the reward given, or the gain."""
        return _GAIN if self.reward is None else self.reward

    def check(self, motor_space: Box, effect_dim: int | None, *, has_goals: bool) -> None:
        """Require effects of a dimension that can be rewarded."""
        del motor_space, has_goals
        if effect_dim is not None:
            self.rewarding.largest(effect_dim)

    def start(self, start: Starter) -> Strategy:
        """Return the sampler under way."""
        return _Sampling(self.sampler, start.value_or_copy(self.rewarding), start.history)


class _Sampling(Strategy):
    """A sampler under way: a study, from the first proposal on, with all that was tried."""

    study: Study | None = None

    def __init__(self, sampler: SamplerFactory | None, reward: Reward, history: History) -> None:
        self._sampler, self._rewarding, self._history = sampler, reward, history
        self._reward: RunningReward | None = None  # under way, from the first effect on
        self._ranges: dict[str, Any] = {}  # of the commands, by the names that Optuna has for them

    def propose(self, history: History, rng: Generator) -> Trial:
        """Ask the study; one ``rng.random()`` before the first proposal."""
        if self.study is None:
            optuna = library("optuna", user="OptunaSampler")
            space, distribution = history.motor_space, optuna.distributions.FloatDistribution
            for index, ends in enumerate(zip(space.low.tolist(), space.high.tolist(), strict=True)):
                self._ranges[f"x{index}"] = distribution(*ends)
            make = optuna.samplers.TPESampler if self._sampler is None else self._sampler
            self.study = _study(optuna, make(seed=seed_from(rng)))
        asked = self.study.ask(self._ranges)
        command = [asked.params[name] for name in self._ranges]
        return _OfStudy(command, study_number=asked.number)

    def observe(self, trial: Trial, effect: NDArray[np.float64]) -> None:
        """Tell the study the reward of the newest effect."""
        study, number = self._of_study(trial)
        if self._reward is None:
            self._reward = self._rewarding.start(len(effect))
        study.tell(number, real("reward", self._reward.of(trial, effect, self._history)))

    def fail(self, trial: Trial, reason: str) -> None:
        """Tell the study that the trial has failed."""
        del reason  # Optuna has no place for it
        study, number = self._of_study(trial)
        study.tell(number, state=library("optuna.trial", user="OptunaSampler").TrialState.FAIL)

    def _of_study(self, trial: Trial) -> tuple[Study, int]:
        """Return the study and the number that a trial has in it."""
        if self.study is None or not isinstance(trial, _OfStudy):
            raise ValueError("trial must be one that this strategy proposed")
        return self.study, trial.study_number


def _study(optuna: ModuleType, sampler: BaseSampler) -> Study:
    """Create a study in memory, which is not logged."""
    with _VERBOSITY:
        before = optuna.logging.get_verbosity()
        optuna.logging.set_verbosity(optuna.logging.WARNING)
        try:
            study: Study = optuna.create_study(
                storage=optuna.storages.InMemoryStorage(),
                sampler=sampler,
                study_name="divbandit",
                direction="maximize",
            )
        finally:
            optuna.logging.set_verbosity(before)
    return study
