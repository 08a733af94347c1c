"""composition: the library's own composition beside the paper's, and with one part changed."""

from __future__ import annotations

import csv
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from divbandit.bandits import Adapt
from divbandit.paper import setting
from divbandit.plot import series, style
from divbandit.strategies import GoalBabbling, MotorBabbling
from divbandit.strategies.goals import UncoveredGoals, UntriedGoals
from divbandit.strategies.inverse import LocalJacobian, NearestNeighbor
from divbandit.studies.cases import Case, Outcome, outcomes

if TYPE_CHECKING:
    from collections.abc import Sequence
    from pathlib import Path

    from matplotlib.figure import Figure

    from divbandit.experiments.explore_many import Progress
    from divbandit.strategies import Strategy
    from divbandit.strategies.goals import GoalSampler
    from divbandit.strategies.inverse import InverseModel

NAME = "composition"

_OWN = "recommended"
#: Perturbation where the inverse model is the paper's.
_D = 0.05


@dataclass(frozen=True)
class Row:
    """What one composition reached.

    Attributes
    ----------
    name : str
    at : tuple of int
        After how many steps.
    outcome : Outcome
        Its values have a column for each of `at`.
    """

    name: str
    at: tuple[int, ...]
    outcome: Outcome


def compositions() -> dict[str, Strategy]:
    """Return the compositions by name: the paper's first, then the library's own.

    Examples
    --------
    >>> list(compositions())[:2]
    ['ADAPT', 'recommended']
    """
    tau = setting.TAU
    goals, model = UntriedGoals(tau), LocalJacobian()
    four = UntriedGoals(tau, candidates=4)
    return {
        "ADAPT": setting.adapt(_D),
        _OWN: _bandit(goals, model),
        "4 candidates": _bandit(four, model),
        "no counts of tries": _bandit(UncoveredGoals(tau), model),
        "goals anywhere": _bandit(None, model),
        "nearest neighbour": _bandit(goals, NearestNeighbor(_D)),
        "no motor babbling": GoalBabbling(goals=goals, inverse=model),
        "ADAPT's window, alpha, power": Adapt(
            [MotorBabbling(), GoalBabbling(goals=goals, inverse=model)], tau=tau
        ),
        "ADAPT's goals and inverse": _bandit(None, NearestNeighbor(_D)),
    }


def _bandit(goals: GoalSampler | None, model: InverseModel) -> Strategy:
    babblings = [MotorBabbling(), GoalBabbling(goals=goals, inverse=model)]
    return Adapt(babblings, tau=setting.TAU, window=200, alpha=0.05, power=8.0)


def run(
    seed: int,
    *,
    steps: int = 10000,
    repetitions: int = 25,
    jobs: int | None = None,
    progress: Progress | None = None,
) -> list[Row]:
    """Explore the arm with each composition; look after a fifth of the steps, half and all."""
    at = _told(steps)
    named = compositions()
    cases = [Case(strategy, at, (7, index)) for index, strategy in enumerate(named.values())]
    reached = outcomes(cases, seed=seed, repetitions=repetitions, jobs=jobs, progress=progress)
    return [Row(name, at, outcome) for name, outcome in zip(named, reached, strict=True)]


def _told(steps: int) -> tuple[int, ...]:
    """Return after which steps to tell: from a fiftieth of them, doubled, and three more.

    Examples
    --------
    >>> _told(10000)
    (200, 400, 800, 1600, 2000, 3200, 5000, 6400, 10000)
    """
    doubled = {steps // 50 * 2**k for k in range(6)}
    return tuple(sorted({at for at in doubled if at} | {steps // 5, steps // 2, steps}))


def explorations(repetitions: int) -> int:
    """Return how many explorations `run` makes."""
    return len(compositions()) * repetitions


def draw(rows: Sequence[Row]) -> Figure:
    """Draw the growth of each composition, and what each reached in the end."""
    import matplotlib.pyplot as plt  # noqa: PLC0415

    figure, ax = plt.subplots(figsize=(0.75 * style.PAGE, 3.0))
    at = rows[0].at
    series(
        at,
        [np.stack([row.outcome.means, row.outcome.deviations], axis=1) for row in rows],
        labels=[row.name for row in rows],
        unit="m²",
        ax=ax,
    )
    ax.set_xlabel("step")
    ax.set_ylim(bottom=0)
    handles, labels = ax.get_legend_handles_labels()
    best_first = sorted(range(len(rows)), key=lambda index: -rows[index].outcome.mean)
    figure.legend(
        [handles[index] for index in best_first],
        [labels[index] for index in best_first],
        frameon=False,
        loc="outside right center",
    )
    return figure


def save(rows: Sequence[Row], path: Path) -> None:
    """Write what every single exploration reached as CSV."""
    with path.open("w", newline="", encoding="utf-8") as file:
        writer = csv.writer(file, lineterminator="\n")
        writer.writerow(["name", "repetition", "step", "coverage"])
        for row in rows:
            for repetition, values in enumerate(row.outcome.values.tolist()):
                for step, value in zip(row.at, values, strict=True):
                    writer.writerow([row.name, repetition, step, repr(value)])


def table(rows: Sequence[Row]) -> str:
    """Return mean, standard deviation and least of what was reached, as text."""
    steps = rows[0].at[-1]
    shown = (steps // 5, steps // 2, steps)
    lines = [f"{'m² (mean ± s.d., least)':30}" + "".join(f"{f'n = {n}':>24}" for n in shown)]
    for row in rows:
        cells = []
        for n in shown:
            place = row.at.index(n)
            least = row.outcome.values[:, place].min()
            mean, deviation = row.outcome.means[place], row.outcome.deviations[place]
            cells.append(f"{f'{mean:.3f} ± {deviation:.3f}, {least:.3f}':>24}")
        lines.append(f"{row.name:30}" + "".join(cells))
    return "\n".join(lines)
