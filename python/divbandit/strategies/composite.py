"""Composite: a strategy that at each step lets one of several others propose."""

from __future__ import annotations

from abc import abstractmethod
from collections import Counter
from collections.abc import Iterable
from typing import TYPE_CHECKING

from divbandit._checks import whole
from divbandit.strategies.base import Strategy, Trial

if TYPE_CHECKING:
    from collections.abc import Sequence

    import numpy as np
    from numpy.random import Generator
    from numpy.typing import NDArray

    from divbandit.box import Box
    from divbandit.history import History


class Composite(Strategy):
    """A strategy made of others. Derive from it and write `choose`.

    Composites nest: each part is told of the very trials that it proposed, and of no other.

    Parameters
    ----------
    strategies : iterable of Strategy
        At least one.

    Attributes
    ----------
    strategies : tuple of Strategy

    Raises
    ------
    TypeError, ValueError
        If one of them is no Strategy, or there is none.

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
        if isinstance(strategies, Strategy):
            raise TypeError("strategies must be a list of strategies, got a single one")
        try:
            self.strategies = tuple(strategies)
        except TypeError:
            raise TypeError(
                f"strategies must be a list of strategies, got {type(strategies).__name__}"
            ) from None
        if not self.strategies:
            raise ValueError("strategies must hold at least one strategy, got none")
        for index, strategy in enumerate(self.strategies):
            if not isinstance(strategy, Strategy):
                raise TypeError(
                    f"strategies[{index}] must be a Strategy, got {type(strategy).__name__}"
                )

    @abstractmethod
    def choose(self, history: History, rng: Generator) -> int:
        """Return the index of the strategy that is to propose next.

        Parameters
        ----------
        history : History
        rng : numpy.random.Generator

        Examples
        --------
        >>> import numpy as np
        >>> import divbandit as db
        >>> mixture = db.Mixture([db.MotorBabbling(), db.GoalBabbling(0.05)], weights=[0, 1])
        >>> mixture.choose(db.History(db.Box([0], [1])), np.random.default_rng(0))
        1
        """

    def propose(self, history: History, rng: Generator) -> Trial:
        """Let the chosen strategy propose."""
        index, probability = self._choose(history, rng)
        proposal = Trial.of(self.strategies[index].propose(history, rng))
        return proposal.proposed_by(index, probability)

    def propose_many(self, history: History, n: int, rng: Generator) -> list[Trial]:
        """Choose `n` times; then let each strategy, in order, propose all of its share."""
        choices = self._choose_many(history, n, rng)
        shares = Counter([index for index, _ in choices])
        proposals = {
            index: iter(proposals_of(self.strategies[index], history, shares[index], rng))
            for index in sorted(shares)
        }
        return [
            next(proposals[index]).proposed_by(index, probability) for index, probability in choices
        ]

    def _choose_many(
        self, history: History, n: int, rng: Generator
    ) -> Sequence[tuple[int, float | None]]:
        """Return what `n` calls of `_choose` return."""
        return [self._choose(history, rng) for _ in range(n)]

    def _choose(self, history: History, rng: Generator) -> tuple[int, float | None]:
        """Return who is to propose next, and with which probability that was chosen."""
        index = whole("choose()", self.choose(history, rng), low=0, high=len(self.strategies) - 1)
        return index, None

    def observe(self, trial: Trial, effect: NDArray[np.float64]) -> None:
        """Tell the strategy that proposed the trial."""
        inner = _part_of(trial)
        inner.place = trial.place
        self.strategies[trial.path[0]].observe(inner, effect)

    def observe_many(self, trials: Sequence[Trial], effects: NDArray[np.float64]) -> None:
        """Tell each strategy of all the trials that it proposed."""
        if all(strategy.learns_nothing for strategy in self.strategies):
            return
        # One that occurs twice is told of all its trials together, in their order.
        shares: dict[int, tuple[Strategy, list[int]]] = {}
        for row, trial in enumerate(trials):
            _part_of(trial).place = trial.place
            part = self.strategies[trial.path[0]]
            shares.setdefault(id(part), (part, []))[1].append(row)
        for part, rows in shares.values():
            part.observe_many([_part_of(trials[row]) for row in rows], effects[rows])

    @property
    def learns_at_once(self) -> bool:
        """Whether all parts do."""
        return super().learns_at_once and all(part.learns_at_once for part in self.strategies)

    def fail(self, trial: Trial, reason: str) -> None:
        """Tell the strategy that proposed the trial."""
        self.strategies[trial.path[0]].fail(_part_of(trial), reason)

    def check(self, motor_space: Box, effect_dim: int | None, *, has_goals: bool) -> None:
        """Let every part check."""
        for strategy in self.strategies:
            strategy.check(motor_space, effect_dim, has_goals=has_goals)


def proposals_of(strategy: Strategy, history: History, n: int, rng: Generator) -> list[Trial]:
    """Return `n` trials that a strategy proposes, or say what is wrong with what it returns.

    Examples
    --------
    >>> import numpy as np
    >>> import divbandit as db
    >>> history = db.History(db.Box([0], [1]))
    >>> len(proposals_of(db.MotorBabbling(), history, 3, np.random.default_rng(0)))
    3
    """
    proposed: object = strategy.propose_many(history, n, rng)
    if type(proposed) is list and set(map(type, proposed)) == {Trial}:
        trials = proposed  # as most are: looked through in a tenth of the time
    elif isinstance(proposed, Iterable):
        trials = [Trial.of(each) for each in proposed]
    else:
        kind = type(proposed).__name__
        raise TypeError(f"propose_many() of {strategy!r} must return a list, got {kind}")
    if len(trials) != n:
        raise ValueError(
            f"propose_many() of {strategy!r} must return {n} trials, got {len(trials)}"
        )
    return trials


def _part_of(trial: Trial) -> Trial:
    """Return the trial that a composite's part proposed."""
    if trial.inner is None:
        raise ValueError("trial must be one that this composite strategy proposed")
    return trial.inner


def total_of(weights: Iterable[float]) -> float:
    """Return the sum in plain order.

    The built-in ``sum`` rounds differently from one version of Python to another.
    """
    total = 0.0
    for weight in weights:
        total += weight
    return total


def proportionally(weights: Iterable[float], u: float) -> int:
    """Return an index with probability proportional to its weight; uniformly if all are 0.

    `u` is uniform in [0, 1).
    """
    weights = list(weights)
    return share_of(weights, total_of(weights), u)


def share_of(weights: Sequence[float], total: float, u: float) -> int:
    """Return what `proportionally` does, given the sum of the weights."""
    if total <= 0.0:
        return int(u * len(weights))
    left = u * total
    last = 0
    for index, weight in enumerate(weights):
        if left < weight:
            return index
        left -= weight
        if weight > 0.0:
            last = index
    return last  # rounding carried u past the end
