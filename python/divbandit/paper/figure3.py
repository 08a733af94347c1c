"""Figure 3: what ADAPT believes and chooses over time, for each perturbation d."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from divbandit.experiments import run_all
from divbandit.exploration import Exploration, explore
from divbandit.measures import coverage
from divbandit.paper import setting
from divbandit.plot import diversity, spread, style, usage
from divbandit.plot.data import diversities_of, usage_of

if TYPE_CHECKING:
    from collections.abc import Sequence

    from matplotlib.figure import Figure
    from numpy.typing import NDArray

    from divbandit.experiments.parallel import Progress


@dataclass(frozen=True)
class Row:
    """One d: an exploration to look at, and the usage of motor babbling as a mean over many."""

    d: float
    exploration: Exploration
    mean_usage: NDArray[np.float64]


def run(
    seed: int,
    *,
    n: int = 5000,
    repetitions: int = 25,
    jobs: int | None = None,
    progress: Progress | None = None,
) -> list[Row]:
    """Explore the arm with ADAPT, `repetitions` times for each d."""
    tasks = [
        (seed, index, repetition, n)
        for index in range(len(setting.PERTURBATIONS))
        for repetition in range(repetitions)
    ]
    choices = run_all(_choices, tasks, jobs=jobs, progress=progress)
    rows = []
    for index, d in enumerate(setting.PERTURBATIONS):
        of_d = choices[index * repetitions : (index + 1) * repetitions]
        shares = [usage_of(chosen, strategies=2)[:, 0] for chosen in of_d]
        rows.append(Row(d, _explore((seed, index, 0, n)), np.mean(shares, axis=0)))
    return rows


def _explore(task: tuple[int, int, int, int]) -> Exploration:
    seed, index, repetition, n = task
    strategy = setting.adapt(setting.PERTURBATIONS[index])
    return explore(setting.arm(), strategy, n, rng=setting.seed_of(seed, 3, index, repetition))


def _choices(task: tuple[int, int, int, int]) -> NDArray[np.int64]:
    return _explore(task).choices


def draw(rows: Sequence[Row]) -> Figure:
    """Draw, for each d, the spread with the covered area, the diversities and the usage."""
    import matplotlib.pyplot as plt  # noqa: PLC0415

    figure, grid = plt.subplots(
        3, 3, figsize=(style.PAGE, 6.6), gridspec_kw={"width_ratios": [1, 1.25, 1.25]}
    )
    for (left, middle, right), row in zip(grid, rows, strict=True):
        spread(row.exploration, tau=setting.TAU, unit="m", ax=left)
        covered = coverage(row.exploration.effects, setting.TAU)
        left.set(xlim=(-1.05, 1.05), ylim=(-1.05, 1.05))
        left.set_title(f"d = {row.d}: {covered:.2f} m² covered")

        diversity(1e4 * diversities_of(row.exploration), labels=setting.LABELS, ax=middle)
        middle.set_ylabel("diversity (cm² per effect)")

        usage(row.exploration, labels=setting.LABELS, ax=right)
        for line in right.lines:
            line.set(linewidth=0.5, alpha=0.55)
        steps = np.arange(1, len(row.mean_usage) + 1)
        shares = (row.mean_usage, 1 - row.mean_usage)
        for share, colour in zip(shares, style.COLOURS, strict=False):
            right.plot(steps, 100 * share, color=colour, linewidth=1.6)
        for ax in (middle, right):
            if row is not rows[0]:
                ax.get_legend().remove()
    grid[0, 1].set_title("diversity of each strategy")
    grid[0, 2].set_title("usage (thick: mean over repetitions)")
    return figure
