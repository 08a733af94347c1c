"""Figure 3: what ADAPT believes and chooses over time, for each perturbation d."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from divbandit.experiments import Task, explore_many
from divbandit.measures import coverage
from divbandit.paper import setting
from divbandit.paper.figure1 import frame
from divbandit.plot import estimates, spread, style, usage
from divbandit.plot.data import estimates_of, usage_of

if TYPE_CHECKING:
    from collections.abc import Sequence

    from matplotlib.axes import Axes
    from matplotlib.figure import Figure
    from numpy.typing import NDArray

    from divbandit.experiments.explore_many import Progress
    from divbandit.exploration import Exploration


@dataclass(frozen=True)
class Row:
    """One d: an exploration to look at, and the usage of motor babbling as a mean over many."""

    d: float
    exploration: Exploration
    mean_usage: NDArray[np.float64]
    repetitions: int


def run(
    seed: int,
    *,
    n: int = 5000,
    repetitions: int = 25,
    jobs: int | None = None,
    progress: Progress | None = None,
) -> list[Row]:
    """Explore the arm with ADAPT, `repetitions` times for each d."""
    tasks = (
        Task(setting.arm(), setting.adapt(d), n, rng=setting.seed_of(seed, 3, index, repetition))
        for index, d in enumerate(setting.PERTURBATIONS)
        for repetition in range(repetitions)
    )
    shown: dict[int, Exploration] = {}
    shares = np.empty((len(setting.PERTURBATIONS), repetitions, n))
    for place, exploration in explore_many(tasks, jobs=jobs, progress=progress):
        index, repetition = divmod(place, repetitions)
        shares[index, repetition] = usage_of(exploration.choices, strategies=2)[:, 0]
        if repetition == 0:
            shown[index] = exploration
    return [
        Row(d, shown[index], shares[index].mean(axis=0), repetitions)
        for index, d in enumerate(setting.PERTURBATIONS)
    ]


def draw(rows: Sequence[Row]) -> Figure:
    """Draw, for each d, the spread with the covered area, the diversities and the usage."""
    import matplotlib.pyplot as plt  # noqa: PLC0415

    figure, grid = plt.subplots(
        3, 3, figsize=(style.PAGE, 6.6), gridspec_kw={"width_ratios": [1, 1.25, 1.25]}
    )
    for letter, (left, middle, right), row in zip("abc", grid, rows, strict=True):
        spread(row.exploration, tau=setting.TAU, unit="m", ax=left)
        covered = coverage(row.exploration.effects, setting.TAU)
        frame(left)
        left.set_title(f"({letter}) d = {row.d}: {covered:.2f} m² covered")

        estimates(1e4 * estimates_of(row.exploration), labels=setting.LABELS, ax=middle)
        middle.set_ylabel("diversity: mean gain (cm²)")
        middle.set_title(f"diversity, d = {row.d}")

        usage(row.exploration, labels=setting.LABELS, ax=right)
        right.set_title(f"usage, d = {row.d}")
        _emphasise_means(right, row)
        for ax in (middle, right):
            if row is not rows[0]:
                ax.get_legend().remove()
    return figure


def _emphasise_means(ax: Axes, row: Row) -> None:
    """Draw the mean usages over a run's own, which become thin."""
    from matplotlib.lines import Line2D  # noqa: PLC0415

    for line in ax.lines:
        line.set(linewidth=0.5, alpha=0.55, label=None)
    steps = np.arange(1, len(row.mean_usage) + 1)
    shares = (row.mean_usage, 1 - row.mean_usage)
    for share, colour in zip(shares, style.COLOURS, strict=False):
        ax.plot(steps, 100 * share, color=colour, linewidth=1.6)
    key = [
        Line2D([], [], color="black", linewidth=0.5, label="this run"),
        Line2D([], [], color="black", linewidth=1.6, label=f"mean of {row.repetitions} runs"),
    ]
    ax.legend(handles=key, frameon=False)
