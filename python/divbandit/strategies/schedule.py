"""Schedule: one strategy after another."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

from divbandit._checks import whole
from divbandit.strategies.composite import Composite, CompositeValue, strategies_of

if TYPE_CHECKING:
    from collections.abc import Iterable

    from numpy.random import Generator

    from divbandit.history import History
    from divbandit.strategies.base import Starter, Strategy


@dataclass(frozen=True, init=False, repr=False)
class Schedule(CompositeValue):
    """Each strategy for a number of steps, then the next.

    Figure 2 of the paper babbles in M for 10 steps before it babbles goals. Steps count the
    schedule's own proposals, even where it is part of another strategy.

    Parameters
    ----------
    phases : iterable of (steps, Strategy)
        `steps` is at least 1, or None for all that remain. The last phase never ends, whatever
        its number of steps.

    Attributes
    ----------
    phases : tuple of (steps, Strategy)
    strategies : tuple of Strategy

    Raises
    ------
    TypeError, ValueError
        If a phase is not such a pair, there are no phases, or one before the last never ends.

    Examples
    --------
    >>> import divbandit as db
    >>> schedule = db.Schedule([(2, db.MotorBabbling()), (None, db.GoalBabbling(0.05))])
    >>> db.explore(db.PlanarArm(20), schedule, n=5, rng=0).choices
    array([0, 0, 1, 1, 1])
    """

    phases: tuple[tuple[int | None, Strategy], ...]

    def __init__(self, phases: Iterable[tuple[int | None, Strategy]]) -> None:
        try:
            pairs = [(steps, strategy) for steps, strategy in phases]
        except (TypeError, ValueError):
            raise TypeError("phases must be pairs (steps, strategy)") from None
        try:
            strategies = strategies_of(strategy for _, strategy in pairs)
        except (TypeError, ValueError) as error:
            raise type(error)(f"phases: {error}") from None
        for index, (steps, _) in enumerate(pairs):
            if steps is not None:
                whole(f"phases[{index}].steps", steps, low=1)
            elif index < len(pairs) - 1:
                raise ValueError(f"phases[{index}].steps must be a number: only the last is None")
        self._set(phases=tuple(pairs), strategies=strategies)

    def start(self, start: Starter) -> Strategy:
        """Return the schedule at its beginning, with the started parts."""
        return _Progress(map(start, self.strategies), [steps for steps, _ in self.phases])


class _Progress(Composite):
    """A schedule under way: which phase it is in, and for how many proposals."""

    def __init__(self, strategies: Iterable[Strategy], steps: list[int | None]) -> None:
        super().__init__(strategies)
        self._steps = steps
        self._phase = 0
        self._proposed = 0

    def choose(self, history: History, rng: Generator) -> int:
        """Return the current phase; nothing is drawn."""
        del history, rng
        steps = self._steps[self._phase]
        if steps is not None and self._proposed >= steps and self._phase < len(self._steps) - 1:
            self._phase += 1
            self._proposed = 0
        self._proposed += 1
        return self._phase
