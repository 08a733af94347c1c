"""BallCoverage: the volume of the union of balls around effects."""

from __future__ import annotations

from dataclasses import dataclass

from divbandit._value import Value
from divbandit.measures.coverage import Coverage


@dataclass(frozen=True, init=False, repr=False)
class BallCoverage(Value):
    """The measure of the union of the balls of radius tau around the effects: C_tau.

    The diversity of Benureau and Oudeyer (2015), and what `Adapt` rewards. Exact up to dimension
    3, estimated beyond; the running measure is a `Coverage`.

    Parameters
    ----------
    tau : float
        Radius of the balls, in the units of the effects, in [1e-100, 1e100].
    accuracy : float
        For estimates: upper limit on the standard error of a gain, as a share of a ball's measure,
        in (0, 1).

    Raises
    ------
    TypeError, ValueError
        If an argument is not a number in its range.

    See Also
    --------
    Coverage : what it starts, which can also be used by itself.
    GridCoverage : coarser, and as fast in many dimensions as in one.

    Examples
    --------
    >>> from divbandit.measures import BallCoverage
    >>> BallCoverage(1.0).start(1).extend([[0], [5], [6]])
    array([2., 2., 1.])
    """

    tau: float
    accuracy: float

    def __init__(self, tau: float, *, accuracy: float = 1e-3) -> None:
        checked = Coverage(tau, accuracy=accuracy)
        self._set(tau=checked.tau, accuracy=checked.accuracy)

    def start(self, dim: int) -> Coverage:
        """Return the measure of no effects.

        Estimates have a seed of their own: an exploration's draws do not depend on its measure.

        Parameters
        ----------
        dim : int
            Dimension of the effects, from 1 to 32.

        Raises
        ------
        TypeError, ValueError
            If the measure of a ball of this dimension is beyond the range of floats.

        Examples
        --------
        >>> from divbandit.measures import BallCoverage
        >>> BallCoverage(0.5).start(2)
        <Coverage of 0 effects in R^2, tau=0.5, measure=0.0>
        """
        return Coverage(self.tau, dim=dim, accuracy=self.accuracy, rng=0)
