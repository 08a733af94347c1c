"""Adapt: the paper's algorithm, strategies chosen in proportion to their diversity."""

from __future__ import annotations

import copy
import math
from typing import TYPE_CHECKING, Any, cast

from divbandit._checks import real, whole
from divbandit._engine import NotBuiltInError
from divbandit.bandits.window import GainWindow
from divbandit.measures import Coverage
from divbandit.measures.template import copy_of, covering
from divbandit.strategies.composite import Composite, proportionally

if TYPE_CHECKING:
    from collections.abc import Iterable

    import numpy as np
    from numpy.random import Generator
    from numpy.typing import NDArray

    from divbandit._engine import Description
    from divbandit.box import Box
    from divbandit.history import History
    from divbandit.measures import Measure
    from divbandit.strategies.base import Strategy, Trial


#: The longest window: its gains are kept one by one.
_LONGEST = 1_000_000

#: The paper's radius of the discs.
_TAU = 0.02


class Adapt(Composite):
    """ADAPT(w, tau, alpha) (Benureau and Oudeyer 2015, figures 3 and 4).

    With probability alpha a strategy uniformly at random; otherwise strategy j with probability
    proportional to its diversity, the mean gain of the last w effects that it produced. The gain
    of an effect is the area that its disc of radius tau adds to those of all effects observed
    before it, whoever produced them; or what another measure of diversity makes of it.

    Parameters
    ----------
    strategies : iterable of Strategy
        Those to choose among; they may be bandits themselves.
    tau : float
        Radius of the discs, in the units of the effects; positive. The default is the paper's,
        for effects of the order of 1. Where it is far too small every effect gains a whole disc,
        where far too large none gains anything: then the diversities say nothing. Effects beyond
        the plane have balls instead of discs, in the dimensions that `Coverage` takes.
    window : int
        w, how many gains a strategy's diversity is averaged over; from 1 to a million.
    alpha : float
        Share of choices made uniformly at random, in [0, 1].
    head_start : int
        How many fictitious gains of a whole disc come first in each window, from 0 to `window`;
        of `measure`'s `largest_gain` where one is given. With 0 all strategies begin with
        diversity 0 and are chosen uniformly until one gains.
    measure : Measure, optional
        What gains are measured by in place of the discs' area, for instance
        ``db.GridCoverage(0.05, dim=3)``: an empty one, of which each exploration takes a copy.
        `tau` then says nothing, and must be left at its default. A strategy whose mean gain is
        negative, as with `Entropy`, counts as one of diversity 0 when Adapt chooses.

    Attributes
    ----------
    strategies : tuple of Strategy
    tau : float or None
        None where a measure was given.
    window, alpha, head_start
        As given.
    measure : Measure or None
        A copy of the one given, empty; None for the discs' area.

    Raises
    ------
    TypeError, ValueError
        If a strategy is none, a number is out of range, `measure` is no measure or not empty, or
        `tau` is given as well.

    Examples
    --------
    >>> import divbandit as db
    >>> adapt = db.Adapt([db.MotorBabbling(), db.GoalBabbling(0.05)], tau=0.02)
    >>> run = db.explore(db.PlanarArm(20), adapt, n=1000, rng=0)
    >>> run.diversities.shape
    (1000, 2)
    >>> adapt = db.Adapt(adapt.strategies, measure=db.GridCoverage(0.05))
    >>> run = db.explore(db.PlanarArm(20), adapt, n=1000, rng=0)
    >>> float(run.diversities[0, 0])
    1.0
    """

    def __init__(
        self,
        strategies: Iterable[Strategy],
        *,
        tau: float = _TAU,
        window: int = 50,
        alpha: float = 0.1,
        head_start: int = 1,
        measure: Measure | None = None,
    ) -> None:
        super().__init__(strategies)
        self.tau: float | None = None
        self.measure = None if measure is None else copy_of("measure", measure)
        if self.measure is None:
            self.tau = Coverage(tau).tau
        elif real("tau", tau) != _TAU:
            raise ValueError(f"tau must not be given together with a measure, got {tau!r}")
        self.window = whole("window", window, low=1, high=_LONGEST)
        self.alpha = real("alpha", alpha, low=0.0, high=1.0)
        self.head_start = whole("head_start", head_start, low=0, high=self.window)
        self._history: History | None = None
        self._forget(None)

    def _forget(self, dim: int | None) -> None:
        """Begin anew: nothing measured, only head starts in the windows.

        While the effects' dimension is not known, their head starts are discs.
        """
        if dim is None:
            dim = 2 if self.measure is None else self.measure.dim
        largest = self._empty(dim).largest_gain
        self._dim = dim
        self._measured: Measure | None = None
        self._windows = [
            GainWindow(self.window, head_start=largest, count=self.head_start)
            for _ in self.strategies
        ]
        self._diversities = [window.mean() for window in self._windows]

    def _empty(self, dim: int) -> Measure:
        """Return what effects of this dimension are to be measured by, or refuse them."""
        if self.measure is None:
            return covering("Adapt", cast("float", self.tau), dim)
        if dim != self.measure.dim:
            raise ValueError(
                f"measure must have the dimension of the effects, {dim}, got {self.measure.dim}"
            )
        return copy.deepcopy(self.measure)

    @property
    def diversities(self) -> tuple[float, ...]:
        """The diversity of each strategy, its mean gain; the next choice sees 0 for less."""
        return tuple(self._diversities)

    def check(self, motor_space: Box, effect_dim: int | None, *, has_goals: bool) -> None:
        """Require effects of a dimension that can be measured."""
        super().check(motor_space, effect_dim, has_goals=has_goals)
        if effect_dim is not None:
            self._empty(effect_dim)

    def choose(self, history: History, rng: Generator) -> int:
        """Draw a strategy: two ``rng.random()``.

        What Adapt remembers belongs to one history; asked about another, it begins anew.
        """
        if history is not self._history:
            try:
                self._forget(history.effect_dim)
            except ValueError:  # said by `check`, or when such an effect is to be measured
                self._forget(None)
            self._history = history
        uniformly = rng.random() < self.alpha
        u = rng.random()
        if uniformly:
            return int(u * len(self._windows))
        return proportionally([max(0.0, mean) for mean in self._diversities], u)

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
        history, measured = self._history, self._measured
        known = 0 if measured is None else len(measured)
        if history is None or len(history) == known:
            raise ValueError("effect must be in the history before Adapt observes it")
        if measured is None:
            dim = history.effects.shape[1]
            if dim != self._dim:  # the first effect told the dimension
                self._forget(dim)
            measured = self._measured = self._empty(dim)
        if len(history) > known + 1:
            measured.extend(history.effects[known:-1])
        gain = float(measured.add(effect))
        if not math.isfinite(gain):
            raise ValueError(f"measure must give finite gains, got {gain}")
        return gain

    def _describe(self, description: Description) -> int:
        parts = description.add_all(self.strategies)
        measure = self._empty(description.effect_dim)
        if type(measure) is not Coverage:
            raise NotBuiltInError("measure", type(measure).__name__)
        return description.engine.adapt(parts, measure, self.window, self.alpha, self.head_start)

    def __getstate__(self) -> dict[str, Any]:
        """Leave out what was measured: it is made anew from the history."""
        return {**self.__dict__, "_measured": None}

    def __repr__(self) -> str:
        by = f"tau={self.tau!r}" if self.measure is None else f"measure={self.measure!r}"
        return (
            f"Adapt({list(self.strategies)!r}, {by}, window={self.window!r}, "
            f"alpha={self.alpha!r}, head_start={self.head_start!r})"
        )
