"""Adapt: the paper's algorithm, strategies chosen in proportion to their diversity."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, Any

from divbandit._checks import real, whole
from divbandit.bandits.window import GainWindow
from divbandit.measures import Coverage
from divbandit.strategies.composite import Composite, proportionally

if TYPE_CHECKING:
    from collections.abc import Iterable

    import numpy as np
    from numpy.random import Generator
    from numpy.typing import NDArray

    from divbandit.box import Box
    from divbandit.history import History
    from divbandit.strategies.base import Strategy, Trial


#: The longest window: its gains are kept one by one.
_LONGEST = 1_000_000


class Adapt(Composite):
    """ADAPT(w, tau, alpha) (Benureau and Oudeyer 2015, figures 3 and 4).

    With probability alpha a strategy uniformly at random; otherwise strategy j with probability
    proportional to its diversity, the mean gain of the last w effects that it produced. The gain
    of an effect is the area that its disc of radius tau adds to those of all effects observed
    before it, whoever produced them.

    Parameters
    ----------
    strategies : iterable of Strategy
        Those to choose among; they may be bandits themselves.
    tau : float
        Radius of the discs, in the units of the effects; positive. The default is the paper's,
        for effects of the order of 1. Where it is far too small every effect gains a whole disc,
        where far too large none gains anything: then the diversities say nothing.
    window : int
        w, how many gains a strategy's diversity is averaged over; from 1 to a million.
    alpha : float
        Share of choices made uniformly at random, in [0, 1].
    head_start : int
        How many fictitious gains of a whole disc come first in each window, from 0 to `window`.
        With 0 all strategies begin with diversity 0 and are chosen uniformly until one gains.

    Raises
    ------
    TypeError, ValueError
        If a strategy is none, or a number is out of range.

    Examples
    --------
    >>> import divbandit as db
    >>> adapt = db.Adapt([db.MotorBabbling(), db.GoalBabbling(0.05)], tau=0.02)
    >>> run = db.explore(db.PlanarArm(20), adapt, n=1000, rng=0)
    >>> run.diversities.shape
    (1000, 2)
    """

    def __init__(
        self,
        strategies: Iterable[Strategy],
        *,
        tau: float = 0.02,
        window: int = 50,
        alpha: float = 0.1,
        head_start: int = 1,
    ) -> None:
        super().__init__(strategies)
        self.tau = Coverage(tau).tau
        self.window = whole("window", window, low=1, high=_LONGEST)
        self.alpha = real("alpha", alpha, low=0.0, high=1.0)
        self.head_start = whole("head_start", head_start, low=0, high=self.window)
        self._history: History | None = None
        self._forget()

    def _forget(self) -> None:
        """Begin anew: nothing covered, only head starts in the windows."""
        ball = math.pi * self.tau * self.tau
        self._coverage: Coverage | None = None
        self._windows = [
            GainWindow(self.window, head_start=ball, count=self.head_start) for _ in self.strategies
        ]
        self._diversities = [window.mean() for window in self._windows]

    @property
    def diversities(self) -> tuple[float, ...]:
        """The diversity of each strategy, as the next choice sees it."""
        return tuple(self._diversities)

    def check(self, motor_space: Box, effect_dim: int | None, *, has_goals: bool) -> None:
        """Require effects in the plane, where the gain is exact."""
        super().check(motor_space, effect_dim, has_goals=has_goals)
        if effect_dim is not None and effect_dim != 2:
            raise ValueError(f"effects must have dimension 2 for Adapt, got {effect_dim}")

    def choose(self, history: History, rng: Generator) -> int:
        """Draw a strategy: two ``rng.random()``.

        What Adapt remembers belongs to one history; asked about another, it begins anew.
        """
        if history is not self._history:
            self._forget()
            self._history = history
        uniformly = rng.random() < self.alpha
        u = rng.random()
        return int(u * len(self._windows)) if uniformly else proportionally(self._diversities, u)

    def observe(self, trial: Trial, effect: NDArray[np.float64]) -> None:
        """Credit the strategy that proposed the trial with the gain of its effect."""
        gain = self._gain(effect)
        super().observe(trial, effect)
        index = trial.path[0]
        self._windows[index].add(gain)
        self._diversities[index] = self._windows[index].mean()

    def _gain(self, effect: NDArray[np.float64]) -> float:
        """Return the gain of the newest effect of the history, which is `effect`.

        Where Adapt is a part of another strategy it is told of its own trials alone; the others'
        effects are in the history, and are added first.
        """
        if self._coverage is None:
            self._coverage = Coverage(self.tau)
        coverage, history = self._coverage, self._history
        covered = len(coverage)
        if history is None or len(history) == covered:
            raise ValueError("effect must be in the history before Adapt observes it")
        if len(history) > covered + 1:
            coverage.extend(history.effects[covered:-1])
        return coverage.add(effect)

    def __getstate__(self) -> dict[str, Any]:
        """Leave out the coverage: it is made anew from the history."""
        return {**self.__dict__, "_coverage": None}

    def __repr__(self) -> str:
        return (
            f"Adapt({list(self.strategies)!r}, tau={self.tau!r}, window={self.window!r}, "
            f"alpha={self.alpha!r}, head_start={self.head_start!r})"
        )
