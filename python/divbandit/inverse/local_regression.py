"""LocalRegression: a linear map from effects to commands around the goal, perturbed."""

from __future__ import annotations

from dataclasses import dataclass

from divbandit._checks import positive, real, whole
from divbandit.inverse.kernel import MOST_NEIGHBOURS, KernelModel


@dataclass(frozen=True, init=False, repr=False)
class LocalRegression(KernelModel):
    """Locally weighted linear regression from effects to commands, evaluated at the goal.

    The `k` effects nearest to the goal are weighted by (1 - (r / b)^2)^2, where r is the distance
    from the goal and b a quarter more than the farthest's, and a linear map with an intercept is
    fitted to their commands (Atkeson, Moore and Schaal 1997). Its value at the goal is clipped to
    the motor space and perturbed.

    A ridge keeps the map's slopes finite where effects are too few or lie on a line; if all effects
    are equal, only the mean of the commands is left.

    Parameters
    ----------
    k : int
        How many effects; at least 1. All of them where fewer are known.
    d : float
        Perturbation, a share of the motor range, in [0, 1].
    ridge : float
        What is added to the variance of each effect coordinate, as a share of their mean; positive.
        The larger, the smaller the slopes.
    reach : float
        How far from the effects' weighted mean the map is followed, in spreads, roots of the mean
        squared distance from it; positive. Towards a goal beyond it is followed as far as that:
        otherwise goals out of reach would lead to commands in the corners of M.

    Attributes
    ----------
    k, d, ridge, reach
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
    >>> history.append([0.5], [9.0])
    >>> model = db.inverse.LocalRegression(d=0.0, ridge=1e-9, reach=3.0)
    >>> model.command([10.0], history, np.random.default_rng(0)).round(6)
    array([0.625])
    >>> babbling = db.GoalBabbling(inverse=db.inverse.LocalRegression(10, 0.05))
    >>> run = db.explore(db.PlanarArm(20), babbling, n=100, rng=0)
    """

    k: int
    d: float
    ridge: float
    reach: float

    def __init__(
        self, k: int = 10, d: float = 0.05, *, ridge: float = 1e-3, reach: float = 1.0
    ) -> None:
        self._set(
            k=whole("k", k, low=1, high=MOST_NEIGHBOURS),
            d=real("d", d, low=0.0, high=1.0),
            ridge=positive("ridge", ridge),
            reach=positive("reach", reach),
        )
