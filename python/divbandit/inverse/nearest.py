"""Nearest: the command of the nearest effect, perturbed."""

from __future__ import annotations

from dataclasses import dataclass

from divbandit._checks import real
from divbandit.inverse.kernel import KernelModel


@dataclass(frozen=True, init=False, repr=False)
class Nearest(KernelModel):
    """Inverse_d: the command of the effect nearest to the goal (Benureau and Oudeyer 2015).

    Each of its coordinates is then uniform within the share `d` of its motor range around it,
    inside the motor space. What `GoalBabbling` does when it is given `d` alone.

    Parameters
    ----------
    d : float
        Perturbation, a share of the motor range, in [0, 1].

    Attributes
    ----------
    d : float

    Raises
    ------
    TypeError, ValueError
        If `d` is not a number in [0, 1].

    Examples
    --------
    >>> import numpy as np
    >>> import divbandit as db
    >>> history = db.History(db.Box([0], [1]))
    >>> history.append([0.25], [7.0])
    >>> db.inverse.Nearest(0.1).command([8.0], history, np.random.default_rng(0))
    array([0.27739234])
    """

    d: float

    def __init__(self, d: float = 0.05) -> None:
        self._set(d=real("d", d, low=0.0, high=1.0))
