"""Crossover: some coordinates of the nearest effect's command, the others of one nearby."""

from __future__ import annotations

from dataclasses import dataclass

from divbandit._checks import real, whole
from divbandit.inverse.kernel import MOST_NEIGHBOURS, KernelModel


@dataclass(frozen=True, init=False, repr=False)
class Crossover(KernelModel):
    """The command of the nearest effect, crossed with that of another nearby, perturbed.

    The other is one of the `k` effects nearest to the goal. Each coordinate of the command is the
    other's with a probability that is drawn for each command, uniform in [0, 1/2]: uniform
    crossover (Syswerda 1989, "Uniform Crossover in Genetic Algorithms", ICGA) of similar effects.
    Where coordinates contribute to the effect one by one, it puts together what is good in each.

    Each command costs two ``rng.random()`` a motor coordinate, and two before that.

    Parameters
    ----------
    k : int
        How many effects near the goal the other is one of; at least 1. All of them where fewer are
        known.
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
    >>> history = db.History(db.Box([0] * 4, [1] * 4))
    >>> history.append([0.25] * 4, [7.0])
    >>> history.append([0.75] * 4, [9.0])
    >>> db.inverse.Crossover(d=0.0).command([7.5], history, np.random.default_rng(0))
    array([0.75, 0.75, 0.25, 0.25])
    >>> babbling = db.GoalBabbling(inverse=db.inverse.Crossover())
    >>> run = db.explore(db.PlanarArm(20), babbling, n=100, rng=0)
    """

    k: int
    d: float

    def __init__(self, k: int = 100, d: float = 0.01) -> None:
        self._set(
            k=whole("k", k, low=1, high=MOST_NEIGHBOURS),
            d=real("d", d, low=0.0, high=1.0),
        )
