"""Problems: the black boxes of the benchmark, each with its tau and its budgets."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

from divbandit import benchmarks
from divbandit.environments import PlanarArm, PushArm
from divbandit.environments.mujoco import pusher, reacher
from divbandit.studies.worlds import clutter, corridor

if TYPE_CHECKING:
    from collections.abc import Callable

    from divbandit.environments import Environment


@dataclass(frozen=True)
class Problem:
    """A black box to explore, with effects in the plane.

    Attributes
    ----------
    name : str
    make : callable
        Returns the environment.
    tau : float
        Radius of what an effect covers, in the units of the effects.
    budget : int
        How many evaluations, by default.
    tuned : bool
        Whether parameters of `default_strategy` were chosen on it.
    sigma : float
        Initial step of the peers' evolution strategies, a share of the motor ranges.
    unit : str
        Of the effects.
    """

    name: str
    make: Callable[[], Environment]
    tau: float
    budget: int
    tuned: bool = False
    sigma: float = 0.1
    unit: str = ""


#: The initial step of the field's experiments on linear projection, 0.5, as a share of the range.
_LINEAR = 0.5 / 20.48


def _linear(dim: int, budget: int) -> Problem:
    # A ball as wide as one of the 100 x 100 cells in which the field counts.
    return Problem(
        f"linear projection {dim}",
        lambda: benchmarks.LinearProjection(dim),
        tau=2.56 * dim / 100,
        budget=budget,
        tuned=True,
        sigma=_LINEAR,
    )


#: All, those first on which parameters were chosen.
PROBLEMS = (
    _linear(20, 100_000),
    _linear(100, 100_000),
    Problem("arm 20", lambda: PlanarArm(20), 0.02, 10_000, tuned=True, unit="m"),
    Problem("arm 100", lambda: PlanarArm(100, limit=1.5), 0.02, 10_000, tuned=True, unit="m"),
    Problem(
        "corridor",
        lambda: PlanarArm(20, obstacles=corridor()),
        0.02,
        10_000,
        tuned=True,
        unit="m",
    ),
    Problem(
        "cluttered room",
        lambda: PlanarArm(20, obstacles=clutter()),
        0.02,
        10_000,
        tuned=True,
        unit="m",
    ),
    Problem(
        "arm repertoire", lambda: benchmarks.ArmRepertoire(12), 0.01, 10_000, tuned=True, unit="m"
    ),
    Problem("pushing", lambda: PushArm(7), 0.02, 10_000, tuned=True, unit="m"),
    Problem("maze", benchmarks.Maze, 4.0, 5000),
    Problem("Reacher", reacher, 0.005, 1000, unit="m"),
    Problem("Pusher", pusher, 0.01, 500, unit="m"),
    Problem("Gray-Scott", lambda: benchmarks.GrayScott(32, 1000), 0.02, 500),
    Problem("Lenia", lambda: benchmarks.Lenia(32, 100), 0.02, 1000),
)

#: Their names.
NAMES = tuple(problem.name for problem in PROBLEMS)
