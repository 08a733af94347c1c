"""Bandit: strategies chosen among by a rule, given what is remembered of their credits."""

from __future__ import annotations

import copy
from collections import deque
from typing import TYPE_CHECKING, Any

from divbandit._checks import real, whole
from divbandit._engine import NotBuiltInError, without_replacements
from divbandit.bandits.credits import Credit, FunctionCredit
from divbandit.bandits.credits.measured import Measured
from divbandit.bandits.memories import Memory, Window
from divbandit.bandits.rules import (
    UCB,
    EpsilonGreedy,
    Exp3,
    Exp3S,
    Proportional,
    RoundRobin,
    Rule,
    Softmax,
    Uniform,
)
from divbandit.measures import Coverage
from divbandit.strategies.composite import Composite

if TYPE_CHECKING:
    from collections.abc import Callable, Iterable, Sequence

    import numpy as np
    from numpy.random import Generator
    from numpy.typing import NDArray

    from divbandit._engine import Description
    from divbandit.box import Box
    from divbandit.history import History
    from divbandit.strategies.base import Strategy, Trial

    Creditor = Credit | Callable[[NDArray[np.float64], History], float]

#: Credits beyond this could not be summed up.
_MOST = 1e300

#: Rules whose choices need no check: a pair, of an index and a probability.
_PAIRED = frozenset({EpsilonGreedy, Exp3, Exp3S, Proportional, RoundRobin, Softmax, UCB, Uniform})

#: The dimension that effects are taken to have until the first of them tells it.
_PLANE = 2


class Bandit(Composite):
    """A bandit in three parts: what is rewarded, what is remembered of it, who is chosen.

    Each effect earns a *credit* for the strategy that produced it. A *memory* holds the mean
    credit of each, and a *rule* chooses by these means who proposes next. Any credit, memory and
    rule go together; `Adapt`, `ucb1` and others are well-known combinations. A trial that failed
    earns 0: the choice was spent in vain.

    Parameters
    ----------
    strategies : iterable of Strategy
        Those to choose among; they may be bandits themselves.
    credit : Credit or callable
        For instance ``CoverageGain(0.02)``, or a function ``(effect, history) -> float``.
    memory : Memory
        For instance ``Window(50)``.
    rule : Rule
        For instance ``Proportional(alpha=0.1)``.

    Attributes
    ----------
    strategies : tuple of Strategy
    credit, memory, rule
        As given: templates, of which each exploration takes deep copies. They are never changed.

    Raises
    ------
    TypeError, ValueError
        If a strategy is none, or a part is not what it must be.

    Examples
    --------
    >>> import divbandit as db
    >>> from divbandit.bandits import CompetenceProgress, Discounted, Softmax
    >>> babblings = [db.GoalBabbling(d) for d in (0.001, 0.05, 0.5)]
    >>> bandit = db.Bandit(
    ...     babblings, credit=CompetenceProgress(), memory=Discounted(0.99), rule=Softmax(0.1)
    ... )
    >>> run = db.explore(db.PlanarArm(20), bandit, n=500, rng=0)
    >>> run.diversities.shape  # the mean credits before each choice
    (500, 3)
    """

    credit: Creditor
    memory: Memory
    rule: Rule

    def __init_subclass__(cls, **options: Any) -> None:  # noqa: ANN401 - as any class
        """Let a `choose` of one's own have its way: the probability of its choice is not known."""
        super().__init_subclass__(**options)
        if "choose" in vars(cls) and "_choose" not in vars(cls):
            cls._choose = Composite._choose  # type: ignore[method-assign]  # noqa: SLF001 - its base

    def __init__(
        self, strategies: Iterable[Strategy], *, credit: Creditor, memory: Memory, rule: Rule
    ) -> None:
        super().__init__(strategies)
        self.credit = credit
        self.memory = _part_of("memory", memory, Memory, "Window(50)")
        self.rule = _part_of("rule", rule, Rule, "Proportional(0.1)")
        self._begin(None)

    def _begin(self, history: History | None) -> None:
        """Begin anew: nothing remembered, by fresh copies of the three parts."""
        credit = copy.deepcopy(_creditor(self.credit))
        dim = None if history is None else history.effect_dim
        try:
            largest = _largest(credit, dim)
        except ValueError:  # said by `check`, or when such an effect is to be credited
            largest, dim = _largest(credit, None), None
        memory, rule = copy.deepcopy(self.memory), copy.deepcopy(self.rule)
        memory.begin(len(self.strategies), largest)
        for name in ("means", "counts"):
            found = len(getattr(memory, name))
            if found != len(self.strategies):
                raise ValueError(
                    f"memory.{name} must hold one for each of {len(self.strategies)} strategies, "
                    f"got {found}"
                )
        rule.begin(len(self.strategies), largest)
        self._credit, self._memory = credit, memory
        self._rule: Any = rule
        self._rule_learns = hasattr(rule, "learn")
        self._rule_is_paired = type(rule) in _PAIRED
        self._dim, self._largest = dim, largest
        self._told = 0  # effects in the history, up to the last one that was told
        self._failed: list[tuple[int, float | None]] = []  # while the dimension is not known
        self._history = history

    @property
    def diversities(self) -> tuple[float, ...]:
        """The mean credit of each strategy that the next choice is made by."""
        return tuple(self._memory.means)

    def check(self, motor_space: Box, effect_dim: int | None, *, has_goals: bool) -> None:
        """Require effects of a dimension that can be credited."""
        super().check(motor_space, effect_dim, has_goals=has_goals)
        if effect_dim is not None:
            _largest(_creditor(self.credit), effect_dim)

    def choose(self, history: History, rng: Generator) -> int:
        """Return whom the rule chooses; the rule says how many ``rng.random()`` it draws.

        What a bandit remembers belongs to one history; asked about another, it begins anew.
        """
        return self._chosen(history, rng)[0]

    def _choose_many(
        self, history: History, n: int, rng: Generator
    ) -> Sequence[tuple[int, float | None]]:
        if "choose" in self.__dict__ or type(self._rule) is not Proportional:
            return super()._choose_many(history, n, rng)
        if history is not self._history:
            self._begin(history)
        return self._rule.choose_many(self._memory, n, rng)

    def _choose(self, history: History, rng: Generator) -> tuple[int, float | None]:
        if "choose" in self.__dict__:  # replaced, in this object alone
            return super()._choose(history, rng)
        if history is self._history:
            chosen: tuple[int, float | None] = self._rule.choose(self._memory, rng)
            return chosen if self._rule_is_paired else self._checked(chosen)
        return self._chosen(history, rng)

    def _chosen(self, history: History, rng: Generator) -> tuple[int, float | None]:
        """Return whom the rule chooses, and with which probability, if it says so."""
        if history is not self._history:
            self._begin(history)
        return self._checked(self._rule.choose(self._memory, rng))

    def _checked(self, chosen: object) -> tuple[int, float | None]:
        pair = chosen if isinstance(chosen, tuple) else (chosen, None)
        if len(pair) != 2:
            raise ValueError(
                "rule.choose() must be an index, or a pair of an index and a probability, "
                f"got {len(pair)} values"
            )
        index, probability = pair
        last = len(self.strategies) - 1
        return whole("rule.choose()", index, low=0, high=last), _probability(probability)

    def observe(self, trial: Trial, effect: NDArray[np.float64]) -> None:
        """Credit the strategy that proposed the trial."""
        history, place = self._history, trial.place
        if history is None or place is None:
            place = trial.place = self._newest()
            history = self._history
        if self._dim is None:
            self._learn_dimension()
        credit = self._credit.of(trial, effect, history)
        if type(credit) is not float or not -_MOST <= credit <= _MOST:
            credit = _credited(credit)
        super().observe(trial, effect)
        if place >= self._told:
            self._told = place + 1
        part = trial.path[0]
        self._memory.add(part, credit)
        if self._rule_learns:
            self._rule.learn(part, credit, trial.probability)

    def observe_many(self, trials: Sequence[Trial], effects: NDArray[np.float64]) -> None:
        """Credit the strategies that proposed the trials: as `observe` of one after the other."""
        if not hasattr(self._credit, "of_many"):
            for trial, effect in zip(trials, effects, strict=True):
                self.observe(trial, effect)
            return
        if not trials:
            return
        last = self._last_of(trials)
        if self._dim is None:
            self._learn_dimension()
        earned = list(self._credit.of_many(trials, effects, self._history))
        if len(earned) != len(trials):
            raise ValueError(
                f"credit.of_many() must return {len(trials)} credits, got {len(earned)}"
            )
        for row, credit in enumerate(earned):
            if type(credit) is not float or not -_MOST <= credit <= _MOST:
                earned[row] = _credited(credit)
        super().observe_many(trials, effects)
        self._told = max(self._told, last + 1)
        parts = [trial.path[0] for trial in trials]
        deque(map(self._memory.add, parts, earned), maxlen=0)
        if self._rule_learns:
            learn = self._rule.learn
            for part, credit, trial in zip(parts, earned, trials, strict=True):
                learn(part, credit, trial.probability)

    @property
    def learns_at_once(self) -> bool:
        """Whether the credit has a way for many effects, and all strategies have."""
        return hasattr(self._credit, "of_many") and super().learns_at_once

    def fail(self, trial: Trial, reason: str) -> None:
        """Credit the strategy that proposed the trial with 0."""
        super().fail(trial, reason)
        if self._dim is None:
            self._failed.append((trial.path[0], trial.probability))
        self._credit_failure(trial.path[0], trial.probability)

    def _credit_failure(self, part: int, probability: float | None) -> None:
        self._memory.add(part, 0.0)
        if self._rule_learns:
            self._rule.learn(part, 0.0, probability)

    def _last_of(self, trials: Sequence[Trial]) -> int:
        """Return the last place of the trials' effects; if told by hand, these are the newest."""
        places = [-1 if trial.place is None else trial.place for trial in trials]
        if self._history is None or -1 in places:
            first = self._newest() + 1 - len(trials)
            for row, trial in enumerate(trials):
                trial.place = places[row] = first + row
        return max(places)

    def _newest(self) -> int:
        """Return the place of the newest effect, of which the bandit was not told yet."""
        known = 0 if self._history is None else len(self._history)
        if known <= self._told:
            raise ValueError(
                f"effect must be in the history before {type(self).__name__} observes it"
            )
        return known - 1

    def _learn_dimension(self) -> None:
        """Take note of the effects' dimension; where credits are larger by it, begin anew."""
        assert self._history is not None  # noqa: S101 - for the type
        dim = self._history.effects.shape[1]
        largest = _largest(self._credit, dim)
        self._dim = dim
        if largest != self._largest:
            self._largest = largest
            self._memory.begin(len(self.strategies), largest)
            self._rule.begin(len(self.strategies), largest)
            for part, probability in self._failed:
                self._credit_failure(part, probability)
        self._failed = []

    def _describe(self, description: Description) -> int:
        """Describe ADAPT, the bandit that the engine knows."""
        parts = description.add_all(self.strategies)
        credit, memory, rule = self.credit, self.memory, self.rule
        if not isinstance(credit, Measured):
            raise NotBuiltInError("credit", type(credit).__name__)
        without_replacements("credit", credit)
        measure = credit.empty(description.effect_dim)
        if type(measure) is not Coverage:
            raise NotBuiltInError("credit.measure", type(measure).__name__)
        if type(memory) is not Window:
            raise NotBuiltInError("memory", type(memory).__name__)
        without_replacements("memory", memory)
        if type(rule) is not Proportional:
            raise NotBuiltInError("rule", type(rule).__name__)
        without_replacements("rule", rule)
        return description.engine.adapt(
            parts, measure, memory.size, rule.alpha, memory.head_start, rule.power
        )

    def __repr__(self) -> str:
        return (
            f"{type(self).__name__}({list(self.strategies)!r}, credit={self.credit!r}, "
            f"memory={self.memory!r}, rule={self.rule!r})"
        )


def _part_of(name: str, value: Any, kind: type, example: str) -> Any:  # noqa: ANN401 - any part
    """Return a part of this kind, or say what is wrong with it."""
    # A class has all the names that an instance has.
    if isinstance(value, type) or not isinstance(value, kind):
        got = f"the class {value.__name__}" if isinstance(value, type) else type(value).__name__
        raise TypeError(f"{name} must be a {kind.__name__}, such as {example}, got {got}")
    return value


def _creditor(credit: Any) -> Any:  # noqa: ANN401 - any credit
    """Return a credit, made of a function if that is what was given."""
    if not isinstance(credit, type):
        if isinstance(credit, Credit):
            return credit
        if callable(credit):
            return FunctionCredit(credit)
    example = "CoverageGain(0.02) or a function of effect and history"
    return _part_of("credit", credit, Credit, example)


def _largest(credit: Any, dim: int | None) -> float:  # noqa: ANN401 - any credit
    """Return what no credit exceeds where effects have this dimension, if it is known."""
    if dim is None:
        dim = getattr(credit, "dim", _PLANE)
    return real("credit.largest()", credit.largest(dim), low=0.0, high=_MOST)


def _credited(credit: object) -> float:
    """Return a credit that was no plain float as one, or say what is wrong with it."""
    return real("credit", credit, low=-_MOST, high=_MOST)


def _probability(probability: object) -> float | None:
    """Return the probability of a choice as a float, if it is known."""
    if probability is None:
        return None
    number = real("probability of rule.choose()", probability, low=0.0, high=1.0 + 1e-9)
    if number == 0.0:
        raise ValueError("probability of rule.choose() must be positive for what it chose, got 0.0")
    return min(1.0, number)  # what sums and products of probabilities lead to is rounded
