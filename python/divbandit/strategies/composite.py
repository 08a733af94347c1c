"""Composite: a strategy that at each step lets one of several others propose."""

from __future__ import annotations

from abc import abstractmethod
from typing import TYPE_CHECKING

from divbandit._checks import whole
from divbandit._core import Trial
from divbandit.strategies.base import Starter, Strategy, StrategyValue

if TYPE_CHECKING:
    from collections.abc import Iterable

    import numpy as np
    from numpy.random import Generator
    from numpy.typing import NDArray

    from divbandit.box import Box
    from divbandit.history import History


class Composite(Strategy):
    """A strategy made of others. Derive from it and write `choose`.

    Composites nest: each part learns of the trials that it proposed, and of no other.

    Parameters
    ----------
    strategies : iterable of Strategy
        At least one.

    Attributes
    ----------
    strategies : tuple of Strategy
        As given; during an exploration, their running counterparts.

    Raises
    ------
    TypeError, ValueError
        If one of them is not a Strategy, or there is none.

    Examples
    --------
    >>> import divbandit as db
    >>> class InTurn(db.Composite):
    ...     def choose(self, history, rng):
    ...         return len(history) % len(self.strategies)
    >>> turns = InTurn([db.MotorBabbling(), db.GoalBabbling(0.05)])
    >>> db.explore(db.PlanarArm(3), turns, n=4, rng=0).choices
    array([0, 1, 0, 1])
    """

    def __init__(self, strategies: Iterable[Strategy]) -> None:
        self.strategies = strategies_of(strategies)

    @abstractmethod
    def choose(self, history: History, rng: Generator) -> int | tuple[int, float | None]:
        """Return the index of the strategy that is to propose next.

        Parameters
        ----------
        history : History
        rng : numpy.random.Generator

        Returns
        -------
        int, or a pair (int, float or None)
            The index, and the probability with which it was chosen if that is known.
        """

    def propose(self, history: History, rng: Generator) -> Trial:
        """Let the chosen strategy propose."""
        chosen = self.choose(history, rng)
        index, probability = chosen if isinstance(chosen, tuple) else (chosen, None)
        index = whole("choose()", index, low=0, high=len(self.strategies) - 1)
        proposal = Trial.of(self.strategies[index].propose(history, rng))
        return proposal.proposed_by(index, probability)

    def observe(self, trial: Trial, effect: NDArray[np.float64]) -> None:
        """Let the strategy that proposed the trial learn its effect."""
        self.strategies[trial.path[0]].observe(_inner(trial), effect)

    def fail(self, trial: Trial, reason: str) -> None:
        """Let the strategy that proposed the trial learn that it failed."""
        self.strategies[trial.path[0]].fail(_inner(trial), reason)

    def check(self, motor_space: Box, effect_dim: int | None, *, has_goals: bool) -> None:
        """Let every part check."""
        for strategy in self.strategies:
            strategy.check(motor_space, effect_dim, has_goals=has_goals)

    def start(self, start: Starter) -> Strategy:
        """Return a deep copy that holds the started parts."""
        running = start.copy_of(self)
        running.strategies = tuple(map(start, self.strategies))
        return running

    def __repr__(self) -> str:
        return f"{type(self).__name__}({list(self.strategies)!r})"


class CompositeValue(StrategyValue):
    """A composite strategy of the library: an immutable value with a field `strategies`."""

    strategies: tuple[Strategy, ...]

    def check(self, motor_space: Box, effect_dim: int | None, *, has_goals: bool) -> None:
        """Let every part check."""
        for strategy in self.strategies:
            strategy.check(motor_space, effect_dim, has_goals=has_goals)


def strategies_of(strategies: Iterable[Strategy]) -> tuple[Strategy, ...]:
    """Return strategies as a tuple, or say what is wrong with them."""
    if isinstance(strategies, Strategy):
        raise TypeError("strategies must be a list of strategies, got a single one")
    try:
        each = iter(strategies)
    except TypeError:
        raise TypeError(
            f"strategies must be a list of strategies, got {type(strategies).__name__}"
        ) from None
    every = tuple(each)
    if not every:
        raise ValueError("strategies must hold at least one strategy, got none")
    for index, strategy in enumerate(every):
        if not isinstance(strategy, Strategy):
            raise TypeError(
                f"strategies[{index}] must be a Strategy, got {type(strategy).__name__}"
            )
    return every


def _inner(trial: Trial) -> Trial:
    """Return the trial that a composite's part proposed."""
    if trial.inner is None:
        raise ValueError("trial must be one that this composite strategy proposed")
    return trial.inner
