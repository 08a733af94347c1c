"""OptunaSampler: a sampler of Optuna as a strategy; it optimises the credit of its effects."""

from __future__ import annotations

import copy
import threading
from typing import TYPE_CHECKING

from divbandit._checks import real
from divbandit._library import library, named, seed_from
from divbandit.bandits import CoverageGain, Credit, FunctionCredit
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

    SamplerFactory = Callable[..., BaseSampler]
    Creditor = Credit | Callable[[NDArray[np.float64], History], float]

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

    It proposes what it expects to be worth most, and is told the credit of each of its own
    effects as it comes: by default its gain, the new area that it covered. That shrinks as an
    area fills up, whoever fills it, so that a sampler is drawn to what nobody has found; how
    well it follows such a moving target is for a bandit to find out. Trials under way are known
    to the sampler as running; a trial that failed has the state FAIL.

    Parameters
    ----------
    sampler : callable, optional
        What makes a sampler when it is called with ``seed=``: a class such as
        ``optuna.samplers.CmaEsSampler``, or a ``functools.partial`` of one. The default is
        ``optuna.samplers.TPESampler``.
    credit : Credit or callable, optional
        What it optimises, the larger the better: a credit as bandits have them, of which each
        exploration takes a deep copy, or a function ``(effect, history) -> float`` for
        the newest effect of the history. The default is ``CoverageGain(0.02)``.

    Attributes
    ----------
    sampler, credit
        As given.

    Raises
    ------
    ModuleNotFoundError
        If Optuna is not installed.
    TypeError, ValueError
        If an argument is not what it must be, or a credit is no finite number.

    Notes
    -----
    The first proposal draws one ``rng.random()``, the sampler's seed; all that it draws is its
    own. Studies are held in memory, and none is logged.

    Examples
    --------
    >>> import divbandit as db
    >>> from divbandit.adapters import OptunaSampler
    >>> arm = db.PlanarArm(7)
    >>> sampler = OptunaSampler(credit=db.bandits.CoverageGain(0.05))
    >>> adapt = db.Adapt([sampler, db.GoalBabbling(0.05)], tau=0.05)
    >>> run = db.explore(arm, adapt, n=50, rng=0)
    >>> run.effects.shape
    (50, 2)
    """

    def __init__(
        self,
        sampler: SamplerFactory | None = None,
        *,
        credit: Creditor | None = None,
    ) -> None:
        library("optuna", user="OptunaSampler")
        if sampler is not None and not callable(sampler):
            raise TypeError(f"sampler must be callable, got {type(sampler).__name__}")
        self.sampler = sampler
        self.credit = credit
        self._template = _credit_of(credit)
        self._history: History | None = None

    @property
    def study(self) -> Study | None:
        """The study at work, with all that was tried and what it was worth; None at first."""
        return None if self._history is None else self._study

    def check(self, motor_space: Box, effect_dim: int | None, *, has_goals: bool) -> None:  # noqa: ARG002 - any space will do
        """Require effects of a dimension that can be credited."""
        if effect_dim is not None:
            self._template.largest(effect_dim)

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
        if trial.place is None:
            trial.place = len(history) - 1
        credit = real("credit", self._credit.of(trial, effect, history))
        self._study.tell(trial.study_number, credit)

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
        self._credit = copy.deepcopy(self._template)
        self._history = history

    def __repr__(self) -> str:
        words = [] if self.sampler is None else [named(self.sampler)]
        if self.credit is not None:
            words.append(f"credit={named(self.credit)}")
        return f"OptunaSampler({', '.join(words)})"


def _credit_of(credit: object) -> Credit:
    """Return a credit, made of a function if that is what was given."""
    if credit is None:
        return CoverageGain()
    if isinstance(credit, Credit) and not isinstance(credit, type):
        return credit
    if callable(credit) and not isinstance(credit, type):
        return FunctionCredit(credit)
    got = f"the class {credit.__name__}" if isinstance(credit, type) else type(credit).__name__
    raise TypeError(
        "credit must be a Credit, such as CoverageGain(0.02), or a function of effect and history, "
        f"got {got}"
    )


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
