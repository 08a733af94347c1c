"""Gain: credit for what an effect adds to any measure of diversity."""

from __future__ import annotations

import copy
from typing import TYPE_CHECKING

from divbandit.bandits.credits.measured import Measured
from divbandit.measures.template import copy_of

if TYPE_CHECKING:
    from divbandit.measures import Measure


class Gain(Measured):
    """The gain of an effect by a measure: by how much it makes all of them more diverse.

    Parameters
    ----------
    measure : Measure
        An empty one, for instance ``db.GridCoverage(0.05)``; it is copied.

    Attributes
    ----------
    measure : Measure
        A copy of the one given, empty.

    Raises
    ------
    TypeError, ValueError
        If `measure` is no measure or not empty. Later, if effects have another dimension.

    Examples
    --------
    >>> import divbandit as db
    >>> from divbandit.bandits import Gain, Proportional, Window
    >>> babblings = [db.MotorBabbling(), db.GoalBabbling(0.05)]
    >>> credit = Gain(db.GridCoverage(0.05))
    >>> bandit = db.Bandit(babblings, credit=credit, memory=Window(50), rule=Proportional())
    >>> run = db.explore(db.PlanarArm(20), bandit, n=100, rng=0)
    >>> float(run.diversities[0, 0])
    1.0
    """

    def __init__(self, measure: Measure) -> None:
        super().__init__()
        self.measure = copy_of("measure", measure)

    @property
    def dim(self) -> int:
        """Dimension of the effects."""
        return self.measure.dim

    def empty(self, dim: int) -> Measure:
        """Return a copy of the measure, or refuse effects of another dimension than its own.

        Examples
        --------
        >>> import divbandit as db
        >>> db.bandits.Gain(db.GridCoverage(0.5)).empty(3)
        Traceback (most recent call last):
            ...
        ValueError: measure must have the dimension of the effects, 3, got 2
        """
        if dim != self.measure.dim:
            raise ValueError(
                f"measure must have the dimension of the effects, {dim}, got {self.measure.dim}"
            )
        return copy.deepcopy(self.measure)

    def __repr__(self) -> str:
        return f"Gain({self.measure!r})"
