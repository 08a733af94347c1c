"""environments: ADAPT, its parts alone and their mixtures, in five black boxes."""

from __future__ import annotations

import csv
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from divbandit.bandits import Adapt, default_strategy
from divbandit.environments import PlanarArm
from divbandit.paper import setting
from divbandit.plot import ranking, scene, spread, style
from divbandit.strategies import GoalBabbling, Mixture, MotorBabbling
from divbandit.studies.cases import Case, Outcome, explored, outcomes
from divbandit.studies.worlds import worlds

if TYPE_CHECKING:
    from collections.abc import Sequence
    from pathlib import Path

    from matplotlib.figure import Figure
    from numpy.typing import NDArray

    from divbandit.experiments.explore_many import Progress
    from divbandit.strategies import Strategy
    from divbandit.studies.worlds import World

NAME = "environments"

#: Perturbation of the inverse model.
_D = 0.05
#: Shares of motor babbling in the mixtures.
_RATIOS = (0.1, 0.25, 0.5, 0.75, 0.9)
_ADAPT, _MOTOR, _GOAL, _OWN = "ADAPT", "motor babbling", "goal babbling", "recommended"


@dataclass(frozen=True)
class Row:
    """What one strategy reached in one world.

    Attributes
    ----------
    world : str
    name : str
        The strategy.
    outcome : Outcome
    steps : int
    example : numpy.ndarray of float64, shape (steps, 2), optional
        The effects of its first exploration, where these are shown.
    """

    world: str
    name: str
    outcome: Outcome
    steps: int
    example: NDArray[np.float64] | None = None


def contenders(tau: float) -> dict[str, Strategy]:
    """Return the strategies by name, of effects that cover discs of radius `tau`.

    Examples
    --------
    >>> list(contenders(0.02))[:4]
    ['ADAPT', 'motor babbling', 'goal babbling', 'recommended']
    """
    parts = [MotorBabbling(), GoalBabbling(_D)]
    mixtures = {
        f"{ratio:.0%} motor babbling": Mixture(parts, weights=[ratio, 1 - ratio])
        for ratio in _RATIOS
    }
    own = default_strategy(tau)
    return {_ADAPT: Adapt(parts, tau=tau), _MOTOR: parts[0], _GOAL: parts[1], _OWN: own, **mixtures}


def run(
    seed: int,
    *,
    steps: int = 10000,
    repetitions: int = 25,
    jobs: int | None = None,
    progress: Progress | None = None,
) -> list[Row]:
    """Explore each world with each strategy."""
    keys, cases = [], []
    for i, world in enumerate(worlds()):
        count = max(1, steps // world.costs)
        for j, (name, strategy) in enumerate(contenders(world.tau).items()):
            keys.append((world.name, name))
            place = (8, i, j)
            cases.append(Case(strategy, (count,), place, explored, world.environment, world.tau))
    reached = outcomes(cases, seed=seed, repetitions=repetitions, jobs=jobs, progress=progress)
    return [
        Row(*key, outcome, case.at[-1], _example(key[1], case, seed))
        for key, case, outcome in zip(keys, cases, reached, strict=True)
    ]


def _example(name: str, case: Case, seed: int) -> NDArray[np.float64] | None:
    """Return the effects of a case's first exploration, if it is to be shown."""
    if name not in (_ADAPT, _MOTOR):
        return None
    rng = setting.seed_of(seed, *case.place, 0)
    return case.method(case.environment, case.strategy, case.at[-1], rng)


def explorations(repetitions: int) -> int:
    """Return how many explorations `run` makes, less those that are made again to be shown."""
    return len(worlds()) * len(contenders(1.0)) * repetitions


def of_world(rows: Sequence[Row], name: str) -> dict[str, Row]:
    """Return the rows of one world by the strategy's name.

    Examples
    --------
    >>> import numpy as np
    >>> of_world([Row("corridor", "ADAPT", Outcome(np.array([[1.0]])), 10)], "corridor").keys()
    dict_keys(['ADAPT'])
    """
    return {row.name: row for row in rows if row.world == name}


def best_mixture(found: dict[str, Row]) -> Row:
    """Return the row of the best of all mixtures of a world, its parts alone among them.

    Examples
    --------
    >>> import numpy as np
    >>> def row(name, value):
    ...     return Row("corridor", name, Outcome(np.array([[value]])), 10)
    >>> rows = [row("ADAPT", 3.0), row("goal babbling", 1.0), row("50% motor babbling", 2.0)]
    >>> best_mixture({each.name: each for each in rows}).name
    '50% motor babbling'
    """
    mixtures = [row for name, row in found.items() if name not in (_ADAPT, _OWN)]
    return max(mixtures, key=lambda row: row.outcome.mean)


def draw(rows: Sequence[Row]) -> dict[str, Figure]:
    """Draw a figure for each world: what motor babbling and ADAPT reach, and all in a row."""
    return {
        f"{NAME}_{world.name.lower().replace(' ', '_')}": _figure(world, of_world(rows, world.name))
        for world in worlds()
    }


def _figure(world: World, found: dict[str, Row]) -> Figure:
    import matplotlib.pyplot as plt  # noqa: PLC0415

    size = (style.PAGE, 2.35)
    figure, axes = plt.subplots(1, 3, figsize=size, width_ratios=[1, 1, 1.1])
    for letter, ax, name in zip("ab", axes, (_MOTOR, _ADAPT), strict=False):
        effects = found[name].example
        if effects is not None:
            spread(effects, tau=world.tau, unit="m", ax=ax)
        if isinstance(world.environment, PlanarArm):
            scene(world.environment, unit="m", ax=ax)
        space = world.environment.sensory_space
        if space is not None:
            low, high = np.asarray(space.low), np.asarray(space.high)
            ax.set(xlim=(low[0], high[0]), ylim=(low[1], high[1]))
        ax.set_title(f"({letter}) {name}, {found[name].steps} steps")
    best = best_mixture(found)
    ranking(
        [(row.outcome.mean, row.outcome.deviation) for row in found.values()],
        labels=list(found),
        marks={"best mixture": best.outcome.mean},
        highlight=list(found).index(_ADAPT),
        unit="m²",
        ax=axes[2],
    )
    axes[2].set_title(f"(c) {world.name}")
    # Both scenes show the same things.
    shown = [ax.get_legend_handles_labels() for ax in axes[1:]]
    handles, labels = ([*first, *second] for first, second in zip(*shown, strict=True))
    figure.legend(handles, labels, loc="outside lower center", ncols=len(labels), frameon=False)
    return figure


def save(rows: Sequence[Row], path: Path) -> None:
    """Write what every single exploration reached as CSV."""
    with path.open("w", newline="", encoding="utf-8") as file:
        writer = csv.writer(file, lineterminator="\n")
        writer.writerow(["world", "name", "steps", "repetition", "coverage"])
        for row in rows:
            for repetition, value in enumerate(row.outcome.values[:, -1].tolist()):
                writer.writerow([row.world, row.name, row.steps, repetition, repr(value)])


def table(rows: Sequence[Row]) -> str:
    """Return what was reached as text: means, deviations, and shares of the best mixture's."""
    lines = []
    for world in worlds():
        found = of_world(rows, world.name)
        best = best_mixture(found).outcome.mean
        lines.append(f"{world.name}, {found[_ADAPT].steps} steps, m²")
        for name, row in found.items():
            outcome = row.outcome
            numbers = f"{outcome.mean:8.4f} ± {outcome.deviation:.4f}"
            lines.append(f"  {name:22}{numbers}{outcome.mean / best - 1:+8.1%}")
    return "\n".join(lines)
