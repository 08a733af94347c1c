"""Cases: explorations that are repeated with other seeds, and the coverages that they reach."""

from __future__ import annotations

from dataclasses import dataclass
from itertools import islice
from typing import TYPE_CHECKING, Any, TypeVar

import numpy as np

from divbandit.exploration import explore
from divbandit.measures import Coverage
from divbandit.paper import setting
from divbandit.studies.processes import over_processes

if TYPE_CHECKING:
    from collections.abc import Callable, Mapping

    from numpy.random import SeedSequence
    from numpy.typing import NDArray

    from divbandit.environments import Environment
    from divbandit.experiments.explore_many import Progress

    #: Explores an environment with a strategy for n steps and returns the effects.
    Method = Callable[[Environment, Any, int, SeedSequence], NDArray[np.float64]]

Key = TypeVar("Key")


def explored(
    environment: Environment,
    strategy: Any,  # noqa: ANN401 - other methods take other things
    n: int,
    rng: SeedSequence,
) -> NDArray[np.float64]:
    """Return the effects of an exploration.

    Examples
    --------
    >>> import numpy as np
    >>> import divbandit as db
    >>> explored(db.PlanarArm(3), db.MotorBabbling(), 5, np.random.SeedSequence(0)).shape
    (5, 2)
    """
    return explore(environment, strategy, n, rng=rng, keep_commands=False).effects


@dataclass(frozen=True)
class Case:
    """One thing to explore with.

    Attributes
    ----------
    strategy : Strategy, or what `method` takes for one
    at : tuple of int
        After which steps to measure the coverage; the last is the length of the exploration.
    place : tuple of int
        The place among all, from which the seed of each repetition comes.
    method : callable
        By default `explored`.
    environment : Environment
        By default the paper's arm.
    tau : float
        Radius of what an effect covers; by default the paper's.
    """

    strategy: Any
    at: tuple[int, ...]
    place: tuple[int, ...]
    method: Method = explored
    environment: Environment = setting.arm()  # noqa: RUF009 - never changes
    tau: float = setting.TAU

    def explore(self, seed: int, repetition: int) -> NDArray[np.float64]:
        """Return the effects of one repetition."""
        rng = setting.seed_of(seed, *self.place, repetition)
        return self.method(self.environment, self.strategy, self.at[-1], rng)


@dataclass(frozen=True)
class Outcome:
    """What the repetitions of a case reached.

    Attributes
    ----------
    case : Case
    seed : int
        That of all cases.
    values : numpy.ndarray of float64, shape (repetitions, k)
        The coverage of each after each of k steps, in square metres.
    """

    case: Case
    seed: int
    values: NDArray[np.float64]

    @property
    def summary(self) -> NDArray[np.float64]:
        """Mean and population standard deviation after each of the steps, shape (k, 2)."""
        return np.stack([self.values.mean(axis=0), self.values.std(axis=0)], axis=1)

    @property
    def mean(self) -> float:
        """The mean in the end."""
        return float(self.summary[-1, 0])

    @property
    def deviation(self) -> float:
        """The population standard deviation in the end."""
        return float(self.summary[-1, 1])

    @property
    def example(self) -> NDArray[np.float64]:
        """The effects of the first repetition, explored again."""
        return self.case.explore(self.seed, 0)


def outcomes(
    cases: Mapping[Key, Case],
    *,
    seed: int,
    repetitions: int,
    jobs: int | None = None,
    progress: Progress | None = None,
) -> dict[Key, Outcome]:
    """Explore each case `repetitions` times.

    Parameters
    ----------
    cases : mapping of Case
        By what tells them apart.
    seed : int
        All randomness comes from it and from the places of the cases.
    repetitions : int
        At least 1.
    jobs : int, optional
        How many processes; the outcomes do not depend on it.
    progress : callable, optional
        Called whenever one more exploration is finished.

    Examples
    --------
    >>> import divbandit as db
    >>> case = Case(db.MotorBabbling(), at=(50, 100), place=(0,))
    >>> outcomes({"motor": case}, seed=0, repetitions=3, jobs=1)["motor"].values.shape
    (3, 2)
    """
    items = [(case, seed, place) for case in cases.values() for place in range(repetitions)]
    reached = iter(over_processes(_reached, items, jobs=jobs, progress=progress))
    return {
        key: Outcome(case, seed, np.array(list(islice(reached, repetitions))))
        for key, case in cases.items()
    }


def _reached(item: tuple[Case, int, int]) -> list[float]:
    """Return the coverages that one exploration reaches."""
    case, seed, repetition = item
    effects = case.explore(seed, repetition)
    measured = Coverage(case.tau)
    reached = []
    for count in case.at:
        measured.extend(effects[len(measured) : count])
        reached.append(measured.measure)
    return reached
