"""Contenders: what explores the problems - the paper's, the library's own, and their peers."""

from __future__ import annotations

from time import perf_counter
from typing import TYPE_CHECKING

from divbandit.bandits import Adapt, default_strategy
from divbandit.exploration import Explorer
from divbandit.strategies import GoalBabbling, MotorBabbling
from divbandit.studies.benchmark.peers import PEERS, explored_by

if TYPE_CHECKING:
    from collections.abc import Sequence

    import numpy as np
    from numpy.random import SeedSequence
    from numpy.typing import NDArray

    from divbandit.environments import Environment
    from divbandit.strategies import Strategy
    from divbandit.studies.benchmark.problems import Problem

#: The library's own composition.
DEFAULT = "default_strategy"
#: The paper's bandit over motor babbling and goal babbling.
ADAPT = "ADAPT"

#: Their names, the library's own first.
CONTENDERS = (DEFAULT, ADAPT, "random search", *PEERS)


def strategy_of(name: str, tau: float) -> Strategy:
    """Return one of the strategies of the library.

    Examples
    --------
    >>> strategy_of("random search", 0.02)
    MotorBabbling()
    """
    if name == DEFAULT:
        return default_strategy(tau)
    if name == ADAPT:
        return Adapt([MotorBabbling(), GoalBabbling(0.05)], tau=tau)
    return MotorBabbling()


def explored(
    name: str, problem: Problem, environment: Environment, marks: Sequence[int], rng: SeedSequence
) -> tuple[NDArray[np.float64], list[float]]:
    """Return the effects of an exploration, and the seconds that it took to each mark.

    Examples
    --------
    >>> import numpy as np
    >>> from divbandit.studies.benchmark.problems import PROBLEMS
    >>> problem, rng = PROBLEMS[2], np.random.SeedSequence(0)
    >>> effects, seconds = explored("ADAPT", problem, problem.make(), [50, 100], rng)
    >>> effects.shape, len(seconds)
    ((100, 2), 2)
    """
    if name in PEERS:
        return explored_by(name, environment, marks, rng, tau=problem.tau, sigma=problem.sigma)
    explorer = Explorer(
        strategy_of(name, problem.tau),
        environment.motor_space,
        environment.sensory_space,
        rng=rng,
    )
    began, seconds = perf_counter(), []
    for mark in marks:
        explorer.run(environment, mark - explorer.evaluations)
        seconds.append(perf_counter() - began)
    return explorer.history.effects, seconds
