"""LineVariation: a command on the line through those of two effects, perturbed."""

from __future__ import annotations

from dataclasses import dataclass

from divbandit._checks import real
from divbandit.inverse.kernel import KernelModel


@dataclass(frozen=True, init=False, repr=False)
class LineVariation(KernelModel):
    """The command of the nearest effect, moved along the line through it and another's, perturbed.

    The other effect is any of those observed. The step is a normal number times the difference of
    the two commands, so that it is long in directions in which commands that are known differ, and
    short where they agree (Vassiliades and Mouret 2018, "Discovering the Elite Hypervolume by
    Leveraging Interspecies Correlation", GECCO; theirs is perturbed by normal numbers).

    Each command costs one ``rng.random()`` a motor coordinate, and two before that.

    Parameters
    ----------
    d : float
        Perturbation, a share of the motor range, in [0, 1].
    along : float
        Standard deviation of the step, a share of the difference; not negative.

    Attributes
    ----------
    d, along
        As given.

    Raises
    ------
    TypeError, ValueError
        If a number is out of range.

    Examples
    --------
    >>> import numpy as np
    >>> import divbandit as db
    >>> history = db.History(db.Box([0, 0], [1, 1]))
    >>> history.append([0.25, 0.5], [7.0])
    >>> history.append([0.75, 0.5], [9.0])
    >>> db.inverse.LineVariation(d=0.0).command([7.5], history, np.random.default_rng(0)).round(3)
    array([0.189, 0.5  ])
    >>> babbling = db.GoalBabbling(inverse=db.inverse.LineVariation())
    >>> run = db.explore(db.PlanarArm(20), babbling, n=100, rng=0)
    """

    d: float
    along: float

    def __init__(self, d: float = 0.005, *, along: float = 0.2) -> None:
        self._set(d=real("d", d, low=0.0, high=1.0), along=real("along", along, low=0.0))
