"""Schedule: one strategy after another."""

from __future__ import annotations

from typing import TYPE_CHECKING, cast

from divbandit._checks import whole
from divbandit.strategies.composite import Composite

if TYPE_CHECKING:
    from collections.abc import Iterable

    from numpy.random import Generator

    from divbandit._engine import Description
    from divbandit.history import History
    from divbandit.strategies.base import Strategy


#: What the engine can count.
_MOST_STEPS = 2**63


class Schedule(Composite):
    """Each strategy for a number of steps, then the next.

    Figure 2 of the paper babbles in M for 10 steps before it babbles goals. Steps are the
    schedule's own proposals, also where it is a part of another strategy.

    Parameters
    ----------
    phases : iterable of (steps, Strategy)
        `steps` is at least 1, or None for all that remain. The last phase never ends, whatever
        its number of steps.

    Raises
    ------
    TypeError, ValueError
        If a phase is no such pair, there is none, or one before the last never ends.

    Examples
    --------
    >>> import divbandit as db
    >>> schedule = db.Schedule([(2, db.MotorBabbling()), (None, db.GoalBabbling(0.05))])
    >>> db.explore(db.PlanarArm(20), schedule, n=5, rng=0).choices
    array([0, 0, 1, 1, 1])
    """

    def __init__(self, phases: Iterable[tuple[int | None, Strategy]]) -> None:
        try:
            pairs = [(steps, strategy) for steps, strategy in phases]
        except (TypeError, ValueError):
            raise TypeError("phases must be pairs (steps, strategy)") from None
        try:
            super().__init__(strategy for _, strategy in pairs)
        except (TypeError, ValueError) as error:
            raise type(error)(f"phases: {error}") from None
        for index, (steps, _) in enumerate(pairs):
            if steps is not None:
                whole(f"phases[{index}].steps", steps, low=1)
            elif index < len(pairs) - 1:
                raise ValueError(f"phases[{index}].steps must be a number: only the last is None")
        self.steps = tuple(steps for steps, _ in pairs)
        self._phase = 0
        self._proposed = 0

    @property
    def phases(self) -> tuple[tuple[int | None, Strategy], ...]:
        """Each strategy, with its number of steps before it."""
        return tuple(zip(self.steps, self.strategies, strict=True))

    def choose(self, history: History, rng: Generator) -> int:
        """Return the current phase; nothing is drawn."""
        del history, rng
        steps = self.steps[self._phase]
        if steps is not None and self._proposed >= steps and self._phase < len(self.steps) - 1:
            self._phase += 1
            self._proposed = 0
        self._proposed += 1
        return self._phase

    def _describe(self, description: Description) -> int:
        parts = description.add_all(self.strategies)
        # More steps than can be counted are as good as one less.
        steps = [min(cast("int", steps), _MOST_STEPS) for steps in self.steps[:-1]]
        return description.engine.schedule(parts, steps, self._phase, self._proposed)

    def __repr__(self) -> str:
        return f"Schedule({list(self.phases)!r})"
