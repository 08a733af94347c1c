"""composition: the library's own composition beside the paper's, and with one part changed."""

from __future__ import annotations

import csv
from dataclasses import dataclass
from typing import TYPE_CHECKING

from divbandit.bandits import Adapt, default_strategy
from divbandit.goals import UncoveredGoals, UntriedGoals
from divbandit.inverse import LocalJacobian, Nearest
from divbandit.paper import setting
from divbandit.plot import ranking, style
from divbandit.strategies import GoalBabbling, MotorBabbling
from divbandit.studies.cases import Case, Outcome, outcomes

if TYPE_CHECKING:
    from collections.abc import Sequence
    from pathlib import Path

    from matplotlib.figure import Figure

    from divbandit.experiments.explore_many import Progress
    from divbandit.goals import GoalSampler
    from divbandit.inverse import InverseModel
    from divbandit.strategies import Strategy

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
        _OWN: default_strategy(tau),
        "4 candidates": _bandit(four, model),
        "no counts of tries": _bandit(UncoveredGoals(tau), model),
        "goals anywhere": _bandit(None, model),
        "nearest neighbour": _bandit(goals, Nearest(_D)),
        "no motor babbling": GoalBabbling(goals=goals, inverse=model),
        "ADAPT's window, alpha, power": Adapt(
            [MotorBabbling(), GoalBabbling(goals=goals, inverse=model)], tau=tau
        ),
        "ADAPT's goals and inverse": _bandit(None, Nearest(_D)),
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
    at = (steps // 5, steps // 2, steps)
    named = compositions()
    cases = [Case(strategy, at, (7, index)) for index, strategy in enumerate(named.values())]
    reached = outcomes(cases, seed=seed, repetitions=repetitions, jobs=jobs, progress=progress)
    return [Row(name, at, outcome) for name, outcome in zip(named, reached, strict=True)]


def explorations(repetitions: int) -> int:
    """Return how many explorations `run` makes."""
    return len(compositions()) * repetitions


def draw(rows: Sequence[Row]) -> dict[str, Figure]:
    """Draw a panel for each number of steps, and in it a row for each composition."""
    import matplotlib.pyplot as plt  # noqa: PLC0415

    figure, axes = plt.subplots(1, 3, figsize=(style.PAGE, 2.3), sharey=True)
    for place, (letter, ax) in enumerate(zip("abc", axes, strict=True)):
        ranking(
            [(row.outcome.means[place], row.outcome.deviations[place]) for row in rows],
            labels=[row.name for row in rows],
            marks={"the paper's ADAPT": float(rows[0].outcome.means[place])},
            highlight=1,
            unit="m²",
            ax=ax,
        )
        ax.set_title(f"({letter}) {rows[0].at[place]} steps")
    handles, labels = axes[0].get_legend_handles_labels()
    figure.legend(handles, labels, frameon=False, loc="outside lower center")
    return {NAME: figure}


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
    heads = "".join(f"{f'n = {n}':>24}" for n in rows[0].at)
    lines = [f"{'m² (mean ± s.d., least)':30}{heads}"]
    for row in rows:
        numbers = zip(
            row.outcome.means, row.outcome.deviations, row.outcome.values.min(axis=0), strict=True
        )
        cells = [f"{f'{mean:.3f} ± {s:.3f}, {least:.3f}':>24}" for mean, s, least in numbers]
        lines.append(f"{row.name:30}" + "".join(cells))
    return "\n".join(lines)
