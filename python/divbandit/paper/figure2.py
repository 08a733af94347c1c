"""Figure 2: random goal babbling, whose reach depends on the perturbation d."""

from __future__ import annotations

from typing import TYPE_CHECKING

from divbandit.experiments import Task, explore_many
from divbandit.paper import setting
from divbandit.paper.figure1 import panel
from divbandit.plot import style

if TYPE_CHECKING:
    from collections.abc import Sequence

    from matplotlib.figure import Figure

    from divbandit.experiments.explore_many import Progress
    from divbandit.exploration import Exploration


def run(
    seed: int, *, n: int = 5000, jobs: int | None = None, progress: Progress | None = None
) -> list[Exploration]:
    """Explore the arm by goal babbling, once for each d."""
    tasks = [
        Task(setting.arm(), setting.goal_babbling(d), n, rng=setting.seed_of(seed, 2, index))
        for index, d in enumerate(setting.PERTURBATIONS)
    ]
    runs = dict(explore_many(tasks, jobs=jobs, progress=progress))
    return [runs[index] for index in range(len(tasks))]


def draw(explorations: Sequence[Exploration]) -> Figure:
    """Draw the effects and the last five postures, a panel for each d."""
    import matplotlib.pyplot as plt  # noqa: PLC0415

    figure, row = plt.subplots(1, 3, figsize=(style.PAGE, 2.65), sharey=True)
    panels = zip("abc", row, setting.PERTURBATIONS, explorations, strict=True)
    for letter, ax, d, exploration in panels:
        panel(ax, exploration)
        ax.set_title(f"({letter}) goal babbling, d = {d}")
        ax.label_outer()
    row[0].legend(*row[0].get_legend_handles_labels(), frameon=False, loc="lower left")
    return figure
