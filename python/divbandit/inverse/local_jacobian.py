"""LocalJacobian: a short step towards the goal, in a linear model around the nearest effect."""

from __future__ import annotations

from dataclasses import dataclass

from divbandit._checks import positive, real, whole
from divbandit.inverse.kernel import MOST_NEIGHBOURS, KernelModel

#: Upper limit on the commands that are fitted: so many equations take a second or so.
_MOST_USED = 1000


@dataclass(frozen=True, init=False, repr=False)
class LocalJacobian(KernelModel):
    """The command of the nearest effect, moved a little towards the goal in a linear model.

    The model is of the environment around that command: by how much each effect coordinate changes
    with each motor coordinate. It is fitted to nearby commands: of the `k` effects nearest to the
    goal, the nearest itself excluded, the `used` whose commands are nearest to its command. So
    similar effects of quite different commands, common where commands have more coordinates than
    effects, do not spoil it. Of all linear models that agree with them, the one with the least sum
    of squares is taken; directions in which no neighbour lies thus remain unused.

    The step is the shortest one that the model says leads to the goal, and is shortened where it is
    longer than `reach`: a linear model is right only nearby. What is left is perturbed in
    proportion to the step, which keeps trying new directions for the model to learn from. Where no
    step can be computed, as with a single effect, the command is only perturbed.

    All lengths of commands are shares of the motor ranges: the units of commands and effects do not
    matter. Steps are root mean squares over the motor coordinates, but for those whose range is a
    point.

    Parameters
    ----------
    k : int
        How many effects near the goal to look at; at least 1. All of them where fewer are known.
    used : int
        How many commands to fit; at least 1. The cost of a command grows with its cube.
    ridge : float
        Regularisation, as a share of the neighbours' spread; positive. It is larger for those
        farther away, by the square of their distance.
    reach : float
        The longest step, a share of the motor range, in [0, 1].
    noise : float
        How far to perturb each motor coordinate, a share of the step's length, in [0, 1].

    Attributes
    ----------
    k, used, ridge, reach, noise
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
    >>> model = db.inverse.LocalJacobian(ridge=1e-9, reach=1.0, noise=0.0)
    >>> model.command([10.0], history, np.random.default_rng(0)).round(5)
    array([0.625])
    >>> goals, model = db.goals.UntriedGoals(0.02), db.inverse.LocalJacobian()
    >>> babbling = db.GoalBabbling(goals=goals, inverse=model)
    >>> run = db.explore(db.PlanarArm(20), babbling, n=100, rng=0)
    """

    k: int
    used: int
    ridge: float
    reach: float
    noise: float

    def __init__(
        self,
        k: int = 50,
        used: int = 10,
        *,
        ridge: float = 0.01,
        reach: float = 0.015,
        noise: float = 0.3,
    ) -> None:
        self._set(
            k=whole("k", k, low=1, high=MOST_NEIGHBOURS),
            used=whole("used", used, low=1, high=_MOST_USED),
            ridge=positive("ridge", ridge),
            reach=real("reach", reach, low=0.0, high=1.0),
            noise=real("noise", noise, low=0.0, high=1.0),
        )
