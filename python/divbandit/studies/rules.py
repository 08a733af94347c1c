"""rules: every bandit in figure 4's three settings, beside the best of the fixed mixtures."""

from __future__ import annotations

import csv
from dataclasses import dataclass
from typing import TYPE_CHECKING

from divbandit.paper import setting
from divbandit.plot import ranking, style
from divbandit.strategies import GoalBabbling, MotorBabbling
from divbandit.studies.cases import Case, Outcome, outcomes
from divbandit.studies.contenders import CONTENDERS, GREEDY
from divbandit.studies.hindsight import hindsight

if TYPE_CHECKING:
    from collections.abc import Sequence
    from pathlib import Path

    from matplotlib.figure import Figure

    from divbandit.experiments.explore_many import Progress

NAME = "rules"

#: How far below the best mixture a good bandit may stay.
ALLOWED = 0.015

_MIXTURE, _HINDSIGHT = "mixture", "hindsight"


@dataclass(frozen=True)
class Row:
    """What one bandit, or a mixture, or hindsight, reached in one setting.

    Attributes
    ----------
    d : float
        The perturbation of goal babbling.
    name : str
    parts : str
        Its estimator and policy, or a mixture's share of motor babbling.
    outcome : Outcome
    """

    d: float
    name: str
    parts: str
    outcome: Outcome


@dataclass(frozen=True)
class Panel:
    """One setting: what was reached, and what it is measured by."""

    d: float
    bandits: tuple[Row, ...]
    best: Row  #: of the fixed mixtures
    hindsight: Row

    def relative(self, row: Row) -> float:
        """Return how far a row's mean is above the best mixture's, as a share of it."""
        return row.outcome.mean / self.best.outcome.mean - 1


def run(
    seed: int,
    *,
    steps: int = 10000,
    repetitions: int = 25,
    jobs: int | None = None,
    progress: Progress | None = None,
) -> list[Row]:
    """Explore the arm with each bandit, each of the 21 mixtures and hindsight, for each d.

    The mixtures have figure 4's seeds: at full size they are its points.
    """
    keys, cases = [], []
    for i, d in enumerate(setting.PERTURBATIONS):
        strategies = [MotorBabbling(), GoalBabbling(d)]
        for j, contender in enumerate(CONTENDERS):
            keys.append((d, contender.name, f"{contender.estimator!r}, {contender.policy!r}"))
            cases.append(Case(contender.over(strategies), (steps,), (5, i, j)))
        for j, ratio in enumerate(setting.RATIOS):
            keys.append((d, _MIXTURE, repr(ratio)))
            cases.append(Case(setting.mixture(d, ratio), (steps,), (4, i, 1 + j)))
        keys.append((d, _HINDSIGHT, "both are tried, the better one is kept"))
        cases.append(Case(strategies, (steps,), (5, i, len(CONTENDERS)), method=hindsight))
    reached = outcomes(cases, seed=seed, repetitions=repetitions, jobs=jobs, progress=progress)
    return [Row(*key, outcome) for key, outcome in zip(keys, reached, strict=True)]


def explorations(repetitions: int) -> int:
    """Return how many explorations `run` makes."""
    count = len(CONTENDERS) + len(setting.RATIOS) + 1
    return len(setting.PERTURBATIONS) * count * repetitions


def panels(rows: Sequence[Row]) -> list[Panel]:
    """Sort rows by setting, and find the best mixture of each."""
    found = []
    for d in setting.PERTURBATIONS:
        of_d = [row for row in rows if row.d == d]
        bandits = tuple(row for row in of_d if row.name not in (_MIXTURE, _HINDSIGHT))
        best = max((row for row in of_d if row.name == _MIXTURE), key=lambda row: row.outcome.mean)
        found.append(Panel(d, bandits, best, next(row for row in of_d if row.name == _HINDSIGHT)))
    return found


def draw(rows: Sequence[Row]) -> dict[str, Figure]:
    """Draw a panel for each d and in it a row for each bandit."""
    import matplotlib.pyplot as plt  # noqa: PLC0415

    figure, row_of_axes = plt.subplots(1, 3, figsize=(style.PAGE, 3.1), sharey=True)
    for letter, ax, panel in zip("abc", row_of_axes, panels(rows), strict=True):
        best = panel.best.outcome.mean
        ranking(
            [(row.outcome.mean, row.outcome.deviation) for row in panel.bandits],
            labels=[row.name for row in panel.bandits],
            marks={
                "best fixed mixture": best,
                "1.5 % below it": (1 - ALLOWED) * best,
                "greedy in hindsight": panel.hindsight.outcome.mean,
            },
            highlight=CONTENDERS.index(GREEDY),
            unit="m²",
            ax=ax,
        )
        ax.set_title(f"({letter}) d = {panel.d}")
    handles, labels = row_of_axes[0].get_legend_handles_labels()
    figure.legend(handles, labels, frameon=False, loc="outside lower center", ncols=len(labels))
    return {NAME: figure}


def save(rows: Sequence[Row], path: Path) -> None:
    """Write what every single exploration reached as CSV."""
    with path.open("w", newline="", encoding="utf-8") as file:
        writer = csv.writer(file, lineterminator="\n")
        writer.writerow(["d", "name", "parts", "repetition", "coverage"])
        for row in rows:
            for repetition, value in enumerate(row.outcome.values[:, -1].tolist()):
                writer.writerow([row.d, row.name, row.parts, repetition, repr(value)])


def table(rows: Sequence[Row]) -> str:
    """Return what was reached as text: means, deviations, and shares of the best mixture's."""
    sorted_rows = panels(rows)
    head = "".join(f"{f'd = {panel.d}':>24}" for panel in sorted_rows)
    lines = [f"{'coverage in m²':22}{head}{'worst':>8}  estimator, policy"]
    for index, contender in enumerate(CONTENDERS):
        of_all = [panel.bandits[index] for panel in sorted_rows]
        shares = [panel.relative(row) for panel, row in zip(sorted_rows, of_all, strict=True)]
        numbers = "".join(map(_numbers, of_all, shares))
        lines.append(f"{contender.name:22}{numbers}{min(shares):+8.1%}  {of_all[0].parts}")
    mixtures = "".join(_numbers(panel.best, 0.0) for panel in sorted_rows)
    ratios = ", ".join(panel.best.parts for panel in sorted_rows)
    lines.append(f"{'best fixed mixture':22}{mixtures}{'':8}  motor babbling {ratios}")
    numbers = "".join(_numbers(p.hindsight, p.relative(p.hindsight)) for p in sorted_rows)
    lines.append(f"{'greedy in hindsight':22}{numbers}{'':8}  {sorted_rows[0].hindsight.parts}")
    return "\n".join(lines)


def _numbers(row: Row, share: float) -> str:
    return f"{f'{row.outcome.mean:.3f} ± {row.outcome.deviation:.3f}':>16}{share:+8.1%}"
