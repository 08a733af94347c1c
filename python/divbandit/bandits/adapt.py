"""Adapt: the paper's algorithm, strategies chosen in proportion to their diversity."""

from __future__ import annotations

import copy
from typing import TYPE_CHECKING, cast

from divbandit._checks import real, whole
from divbandit._engine import NotBuiltInError
from divbandit.bandits.bandit import Bandit
from divbandit.bandits.credits import CoverageGain, Gain
from divbandit.bandits.memories import Window
from divbandit.bandits.memories.base import LONGEST
from divbandit.bandits.rules import Proportional
from divbandit.measures import Coverage
from divbandit.measures.template import copy_of
from divbandit.strategies.composite import Composite

if TYPE_CHECKING:
    from collections.abc import Iterable

    from divbandit._engine import Description
    from divbandit.measures import Measure
    from divbandit.strategies.base import Strategy


#: The paper's radius of the discs.
_TAU = 0.02


class Adapt(Bandit):
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
    power : float
        Not negative. Strategies are chosen in proportion to this power of their diversity; 1 is the
        paper's.

    Attributes
    ----------
    strategies : tuple of Strategy
    tau : float or None
        None where a measure was given.
    window, alpha, head_start, power
        As given.
    measure : Measure or None
        A copy of the one given, empty; None for the discs' area.
    credit, memory, rule
        The parts that this `Bandit` is made of.

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
        power: float = 1.0,
    ) -> None:
        Composite.__init__(self, strategies)
        self.tau: float | None = None
        self.measure = None if measure is None else copy_of("measure", measure)
        if self.measure is None:
            self.tau = Coverage(tau).tau
        elif real("tau", tau) != _TAU:
            raise ValueError(f"tau must not be given together with a measure, got {tau!r}")
        self.window = whole("window", window, low=1, high=LONGEST)
        self._alpha = real("alpha", alpha, low=0.0, high=1.0)
        self.head_start = whole("head_start", head_start, low=0, high=self.window)
        self.power = real("power", power, low=0.0)
        self._begin(None)

    @property
    def alpha(self) -> float:
        """Share of choices made uniformly at random."""
        return self._alpha

    @alpha.setter
    def alpha(self, alpha: float) -> None:
        self._alpha = alpha
        rule = copy.copy(self._rule)  # which a copy of this object may share
        rule.alpha = alpha
        rule.begin(len(self.strategies), self._largest)
        self._rule = rule

    @property
    def credit(self) -> CoverageGain | Gain:  # type: ignore[override]
        """`CoverageGain` of tau, or `Gain` by the measure."""
        if self.measure is None:
            return CoverageGain.asked_by("Adapt", cast("float", self.tau))
        return Gain(self.measure)

    @property
    def memory(self) -> Window:  # type: ignore[override]
        """`Window`, with the head start."""
        return Window(self.window, head_start=self.head_start)

    @property
    def rule(self) -> Proportional:  # type: ignore[override]
        """`Proportional`, with alpha and power."""
        return Proportional(self.alpha, power=self.power)

    def _describe(self, description: Description) -> int:
        parts = description.add_all(self.strategies)
        measure = self.credit.empty(description.effect_dim)
        if type(measure) is not Coverage:
            raise NotBuiltInError("measure", type(measure).__name__)
        return description.engine.adapt(
            parts, measure, self.window, self.alpha, self.head_start, self.power
        )

    def __repr__(self) -> str:
        by = f"tau={self.tau!r}" if self.measure is None else f"measure={self.measure!r}"
        power = "" if self.power == 1.0 else f", power={self.power!r}"
        return (
            f"Adapt({list(self.strategies)!r}, {by}, window={self.window!r}, "
            f"alpha={self.alpha!r}, head_start={self.head_start!r}{power})"
        )
