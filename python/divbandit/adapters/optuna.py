"""OptunaSampler: a sampler of Optuna as a strategy; it optimises the gain of its own effects."""

from __future__ import annotations

import threading
from typing import TYPE_CHECKING, Any

from divbandit._checks import real
from divbandit.adapters._library import library, named, seed_from
from divbandit.measures import Coverage
from divbandit.measures.template import covering
from divbandit.strategies.base import Strategy, Trial

if TYPE_CHECKING:
    from collections.abc import Callable
    from types import ModuleType

    import numpy as np
    from numpy.random import Generator
    from numpy.typing import ArrayLike, NDArray
    from optuna.samplers import BaseSampler
    from optuna.study import Study

    from divbandit.box import Box
    from divbandit.history import History
    from divbandit.measures import Measure

    SamplerFactory = Callable[..., BaseSampler]
    Objective = Callable[[NDArray[np.float64], History], float]

#: How loud Optuna is belongs to all threads: one at a time turns it down.
_LOUDNESS = threading.Lock()


class _OfStudy(Trial):
    """A trial that has a number in a study."""

    __slots__ = ("study_number",)

    def __init__(self, command: ArrayLike, number: int) -> None:
        super().__init__(command)
        self.study_number = number


class OptunaSampler(Strategy):
    """A sampler of Optuna as a strategy: TPE, CMA-ES, quasi-Monte Carlo and others.

    It proposes what it expects to be worth most, and is told what each of its own effects was
    worth when it came: by default its gain, the new area that it covered. That shrinks as an
    area fills up, whoever fills it, so that a sampler is drawn to what nobody has found; how
    well it follows such a moving target is for a bandit to find out. Trials under way are known
    to the sampler as running; a trial that failed has the state FAIL.

    Parameters
    ----------
    sampler : callable, optional
        What makes a sampler when it is called with ``seed=``: a class such as
        ``optuna.samplers.CmaEsSampler``, or a ``functools.partial`` of one. The default is
        ``optuna.samplers.TPESampler``.
    objective : callable, optional
        A function of an effect and the history, whose newest effect it is: what it is worth, a
        finite number, the larger the better.
    tau : float
        Radius of the discs whose area is the gain, in the units of the effects. Where an
        objective is given it says nothing.

    Attributes
    ----------
    sampler, objective, tau
        As given.

    Raises
    ------
    ModuleNotFoundError
        If Optuna is not installed.
    TypeError, ValueError
        If an argument is not what it must be, or the objective gives no finite number.

    Notes
    -----
    The first proposal draws one ``rng.random()``, the sampler's seed; all that it draws is its
    own. Studies are held in memory, and none is logged.

    Examples
    --------
    >>> import divbandit as db
    >>> from divbandit.adapters import OptunaSampler
    >>> arm = db.PlanarArm(7)
    >>> adapt = db.Adapt([OptunaSampler(tau=0.05), db.GoalBabbling(0.05)], tau=0.05)
    >>> run = db.explore(arm, adapt, n=50, rng=0)
    >>> run.effects.shape
    (50, 2)
    """

    def __init__(
        self,
        sampler: SamplerFactory | None = None,
        *,
        objective: Objective | None = None,
        tau: float = 0.02,
    ) -> None:
        library("optuna", user="OptunaSampler")
        for name, value in [("sampler", sampler), ("objective", objective)]:
            if value is not None and not callable(value):
                raise TypeError(f"{name} must be callable, got {type(value).__name__}")
        self.sampler = sampler
        self.objective = objective
        self.tau = Coverage(tau).tau
        self._history: History | None = None
        self._measured: Measure | None = None

    @property
    def study(self) -> Study | None:
        """The study at work, with all that was tried and what it was worth; None at first."""
        return None if self._history is None else self._study

    def check(self, motor_space: Box, effect_dim: int | None, *, has_goals: bool) -> None:  # noqa: ARG002 - any space will do
        """Require effects of a dimension that can be measured."""
        if effect_dim is not None and self.objective is None:
            covering("OptunaSampler", self.tau, effect_dim)

    def propose(self, history: History, rng: Generator) -> Trial:
        """Ask the study.

        What is remembered belongs to one history; asked about another, all begins anew.
        """
        if history is not self._history:
            self._begin(history, rng)
        asked = self._study.ask(self._ranges)
        return _OfStudy([asked.params[name] for name in self._ranges], asked.number)

    def observe(self, trial: Trial, effect: NDArray[np.float64]) -> None:
        """Tell the study what the effect is worth."""
        history = self._history
        if history is None or not isinstance(trial, _OfStudy):
            raise ValueError("trial must be one that this strategy proposed")
        place = len(history) - 1 if trial.place is None else trial.place
        if self.objective is None:
            value = self._gain(effect, place, history)
        else:
            value = real("objective()", self.objective(effect, history))
        self._study.tell(trial.study_number, value)

    def fail(self, trial: Trial, reason: str) -> None:  # noqa: ARG002 - Optuna has no place for it
        """Tell the study that the trial has failed."""
        if self._history is None or not isinstance(trial, _OfStudy):
            raise ValueError("trial must be one that this strategy proposed")
        state = library("optuna.trial", user="OptunaSampler").TrialState.FAIL
        self._study.tell(trial.study_number, state=state)

    def _begin(self, history: History, rng: Generator) -> None:
        """Begin a study for this history."""
        optuna = library("optuna", user="OptunaSampler")
        space = history.motor_space
        ranges = zip(space.low.tolist(), space.high.tolist(), strict=True)
        names = [f"x{index}" for index in range(space.dim)]
        distribution = optuna.distributions.FloatDistribution
        self._ranges = {name: distribution(*ends) for name, ends in zip(names, ranges, strict=True)}
        make = optuna.samplers.TPESampler if self.sampler is None else self.sampler
        self._study = _study(optuna, make(seed=seed_from(rng)))
        self._measured = None
        self._history = history

    def _gain(self, effect: NDArray[np.float64], place: int, history: History) -> float:
        """Return what the effect in this place adds to all before it."""
        if self._measured is None:
            self._measured = covering("OptunaSampler", self.tau, len(effect))
        known = len(self._measured)
        if known < place:
            self._measured.extend(history.effects[known:place])
        return float(self._measured.add(effect))

    def __getstate__(self) -> dict[str, Any]:
        """Leave out what was measured: it is made anew from the history."""
        return {**self.__dict__, "_measured": None}

    def __repr__(self) -> str:
        words = [] if self.sampler is None else [named(self.sampler)]
        if self.objective is None:
            words.append(f"tau={self.tau!r}")
        else:
            words.append(f"objective={named(self.objective)}")
        return f"OptunaSampler({', '.join(words)})"


def _study(optuna: ModuleType, sampler: BaseSampler) -> Study:
    """Make a study in memory, without a word in the log."""
    with _LOUDNESS:
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
