"""Peers: the algorithms of pyribs on a problem, with the settings of its documentation.

Solutions are commands as shares of the motor ranges, from 0 to 1. The objective is flat: only new
effects count.
"""

from __future__ import annotations

from time import perf_counter
from typing import TYPE_CHECKING, Any

import numpy as np

from divbandit._library import library
from divbandit.box import Box, box_or_none

if TYPE_CHECKING:
    from collections.abc import Sequence

    from numpy.random import SeedSequence
    from numpy.typing import NDArray

    from divbandit.environments import Environment

#: How many cells archives have along each coordinate of the effects.
CELLS = 100

#: The algorithms, by name.
PEERS = (
    "MAP-Elites, Gaussian",
    "MAP-Elites, line",
    "CMA-ME",
    "CMA-MAE",
    "novelty search",
    "density descent",
    "emitters by UCB1",
)

#: Solutions that an emitter proposes at a time.
_BATCH = 36
#: The archive's step towards a new objective in CMA-MAE.
_ALPHA = 0.01
#: The evolution strategies of CMA-MAE and density descent.
_ANNEALING = {"selection_rule": "mu", "restart_rule": "basic"}
#: Gaussian variation, as a share of the motor ranges.
_GAUSSIAN = 0.02
#: Of the density that is descended, a share of the effects' range.
_BANDWIDTH = 0.05
#: The documentation's number of emitters makes sense from this budget on.
_LARGE = 50_000


class _Ribs:
    """What pyribs needs to know of a problem."""

    def __init__(
        self, environment: Environment, n: int, rng: SeedSequence, tau: float, sigma: float
    ) -> None:
        motor = Box.of(environment.motor_space, name="motor_space")
        effects = box_or_none("sensory_space", environment.sensory_space)
        if effects is None:
            raise ValueError("environment must have a sensory space, which archives cut into cells")
        self.archives, self.emitters, self.schedulers = (
            library(f"ribs.{name}", user="the benchmark")
            for name in ("archives", "emitters", "schedulers")
        )
        self.m, self.s = motor.dim, effects.dim
        self.ranges = list(zip(effects.low.tolist(), effects.high.tolist(), strict=True))
        self.low, self.high = motor.low, motor.high
        self.sigma, self.tau = sigma, tau
        self.count = 15 if n >= _LARGE else 5
        self.seeds = iter(rng.generate_state(64).tolist())

    def grid(self, **options: Any) -> Any:  # noqa: ANN401 - pyribs'
        """Return an archive of cells."""
        return self.archives.GridArchive(
            solution_dim=self.m,
            dims=[CELLS] * self.s,
            ranges=self.ranges,
            seed=next(self.seeds),
            **options,
        )

    def variation(self, archive: Any, kind: str, **options: Any) -> list[Any]:  # noqa: ANN401
        """Return emitters that vary elites, the first of which are random."""
        made = []
        for _ in range(self.count):
            seed = next(self.seeds)
            first = np.random.default_rng(seed).random((_BATCH, self.m))
            options["bounds"] = [(0.0, 1.0)] * self.m
            made.append(self._emitter(archive, kind, seed, initial_solutions=first, **options))
        return made

    def evolution(self, archive: Any, ranker: str, **options: Any) -> list[Any]:  # noqa: ANN401
        """Return evolution strategies, which start in the middle.

        They have no bounds, as commands are clipped: with bounds they draw until all coordinates
        are within, which in 100 dimensions may take for ever.
        """
        kind, options = "EvolutionStrategy", {"sigma0": self.sigma, "ranker": ranker, **options}
        options["x0"] = [0.5] * self.m
        seeds = (next(self.seeds) for _ in range(self.count))
        return [self._emitter(archive, kind, seed, **options) for seed in seeds]

    def _emitter(self, archive: Any, kind: str, seed: int, **options: Any) -> Any:  # noqa: ANN401
        make = getattr(self.emitters, f"{kind}Emitter")
        return make(archive, batch_size=_BATCH, seed=seed, **options)

    def scheduler(self, name: str) -> Any:  # noqa: ANN401
        """Return the scheduler of an algorithm."""
        make, result = self.schedulers.Scheduler, dict[str, Any]()
        archive = self.grid()
        if name == "MAP-Elites, Gaussian":
            each = self.variation(archive, "Gaussian", sigma=_GAUSSIAN)
        elif name == "MAP-Elites, line":
            each = self.variation(archive, "IsoLine")
        elif name == "CMA-ME":
            each = self.evolution(archive, "2imp")
        elif name == "CMA-MAE":
            archive = self.grid(learning_rate=_ALPHA, threshold_min=0.0)
            each = self.evolution(archive, "imp", **_ANNEALING)
        elif name == "novelty search":
            archive = self.archives.ProximityArchive(
                solution_dim=self.m,
                measure_dim=self.s,
                k_neighbors=15,
                novelty_threshold=self.tau,
                seed=next(self.seeds),
            )
            each = self.evolution(archive, "nov")
        elif name == "density descent":
            # Emitters restart from elites, and are ranked by the density.
            result["result_archive"] = archive
            each = self.evolution(archive, "density", **_ANNEALING)
            width = max(high - low for low, high in self.ranges)
            archive = self.archives.DensityArchive(
                measure_dim=self.s, bandwidth=_BANDWIDTH * width, seed=next(self.seeds)
            )
        else:
            each = [
                *self.variation(archive, "Gaussian", sigma=_GAUSSIAN),
                *self.variation(archive, "IsoLine"),
                *self.evolution(archive, "2imp"),
            ]
            return self.schedulers.BanditScheduler(archive, each, num_active=self.count)
        return make(archive, each, **result)


def explored_by(
    name: str,
    environment: Environment,
    marks: Sequence[int],
    rng: SeedSequence,
    *,
    tau: float,
    sigma: float,
) -> tuple[NDArray[np.float64], list[float]]:
    """Return the effects of an exploration by an algorithm of pyribs, and the seconds to each mark.

    Parameters
    ----------
    name : str
        One of `PEERS`.
    environment : Environment
        With a sensory space; it takes many commands at once.
    marks : sequence of int
        After how many evaluations to look at the clock; the last is their number.
    rng : SeedSequence
    tau, sigma : float
        Those of the problem.

    Examples
    --------
    >>> import numpy as np
    >>> import divbandit as db
    >>> seed = np.random.SeedSequence(0)
    >>> options = {"tau": 0.1, "sigma": 0.1}
    >>> effects, _ = explored_by("CMA-ME", db.PlanarArm(3), [100, 200], seed, **options)
    >>> effects.shape
    (200, 2)
    """
    began = perf_counter()
    ribs = _Ribs(environment, marks[-1], rng, tau, sigma)
    scheduler = ribs.scheduler(name)
    found: list[NDArray[np.float64]] = []
    made, seconds = 0, []
    for mark in marks:
        while made < mark:
            shares = scheduler.ask()
            commands = np.clip(ribs.low + (ribs.high - ribs.low) * shares, ribs.low, ribs.high)
            effects = np.array([environment(command) for command in commands])
            scheduler.tell(np.ones(len(effects)), effects)
            found.append(effects)
            made += len(effects)
        seconds.append(perf_counter() - began)
    return np.concatenate(found)[: marks[-1]], seconds
