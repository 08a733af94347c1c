"""CoverageGain: credit for the area that an effect newly covers, as in the paper."""

from __future__ import annotations

from typing import TYPE_CHECKING

from divbandit.bandits.credits.measured import Measured
from divbandit.measures import Coverage
from divbandit.measures.template import covering

if TYPE_CHECKING:
    from divbandit.measures import Measure


class CoverageGain(Measured):
    """The gain of an effect: what its ball adds to the union of those before it.

    Benureau and Oudeyer 2015: the diversity of one effect, an area in the plane, in square units
    of the effects. Exact up to dimension 3, estimated beyond; see `Coverage`.

    Parameters
    ----------
    tau : float
        Radius of the balls, in the units of the effects; positive. The default is the paper's,
        for effects of the order of 1.

    Attributes
    ----------
    tau : float

    Raises
    ------
    TypeError, ValueError
        If `tau` is no positive number. Later, if effects have a dimension that `Coverage` does
        not take.

    Examples
    --------
    >>> import divbandit as db
    >>> from divbandit.bandits import CoverageGain, Proportional, Window
    >>> babblings = [db.MotorBabbling(), db.GoalBabbling(0.05)]
    >>> parts = {"credit": CoverageGain(0.02), "memory": Window(50), "rule": Proportional(0.1)}
    >>> run = db.explore(db.PlanarArm(20), db.Bandit(babblings, **parts), n=100, rng=0)
    >>> adapt = db.explore(db.PlanarArm(20), db.Adapt(babblings), n=100, rng=0)
    >>> bool((run.commands == adapt.commands).all())
    True
    """

    def __init__(self, tau: float = 0.02) -> None:
        super().__init__()
        self.tau = Coverage(tau).tau
        self._asking = "CoverageGain"

    @classmethod
    def asked_by(cls, name: str, tau: float) -> CoverageGain:
        """Return one whose errors speak of `name`, which is made of it.

        Examples
        --------
        >>> import divbandit as db
        >>> try:
        ...     db.bandits.CoverageGain.asked_by("Adapt", 0.02).largest(40)
        ... except ValueError as error:
        ...     print(str(error).split(":")[0])
        effects must be of a dimension that Adapt takes, got 40
        """
        credit = cls(tau)
        credit._asking = name
        return credit

    def empty(self, dim: int) -> Measure:
        """Return an empty Coverage for effects of this dimension, or refuse them.

        Examples
        --------
        >>> import divbandit as db
        >>> db.bandits.CoverageGain(0.5).empty(3).dim
        3
        """
        return covering(self._asking, self.tau, dim)

    def __repr__(self) -> str:
        return f"CoverageGain({self.tau!r})"
