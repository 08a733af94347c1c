"""KNearest: a command between those of the nearest effects, perturbed."""

from __future__ import annotations

from dataclasses import dataclass

from divbandit._checks import real, whole
from divbandit.inverse.kernel import MOST_NEIGHBOURS, KernelModel


@dataclass(frozen=True, init=False, repr=False)
class KNearest(KernelModel):
    """The weighted mean of the commands of the `k` effects nearest to the goal, perturbed.

    A command's weight is 1 over the distance of its effect from the goal (Shepard 1968); effects at
    the goal itself share all the weight. With `k` of 1 it is `Nearest`. Commands that reach similar
    places in different ways may have a mean that reaches another place: a small `k` mixes fewer.

    Parameters
    ----------
    k : int
        How many effects; at least 1. All of them where fewer are known.
    d : float
        Perturbation, a share of the motor range, in [0, 1].

    Attributes
    ----------
    k, d
        As given.

    Raises
    ------
    TypeError, ValueError
        If a number is out of range.

    Examples
    --------
    >>> import numpy as np
    >>> import divbandit as db
    >>> history = db.History(db.Box([0], [1]))
    >>> history.append([0.25], [7.0])
    >>> history.append([0.75], [11.0])
    >>> db.inverse.KNearest(2, d=0.0).command([8.0], history, np.random.default_rng(0))
    array([0.375])
    >>> babbling = db.GoalBabbling(inverse=db.inverse.KNearest(3, 0.05))
    >>> run = db.explore(db.PlanarArm(20), babbling, n=100, rng=0)
    """

    k: int
    d: float

    def __init__(self, k: int = 3, d: float = 0.05) -> None:
        self._set(
            k=whole("k", k, low=1, high=MOST_NEIGHBOURS),
            d=real("d", d, low=0.0, high=1.0),
        )
