"""The benchmark's figures: both measures against evaluations, and coverage against seconds."""

from __future__ import annotations

from typing import TYPE_CHECKING

from divbandit.plot import style
from divbandit.studies.benchmark.table import summary

if TYPE_CHECKING:
    from matplotlib.figure import Figure

    from divbandit.studies.benchmark.problems import Problem
    from divbandit.studies.benchmark.table import Row


def figure_of(problem: Problem, rows: dict[str, list[Row]]) -> Figure:
    """Draw a problem: means with bands of a standard deviation, the library's own in bold."""
    import matplotlib.pyplot as plt  # noqa: PLC0415

    figure, axes = plt.subplots(1, 3, figsize=(style.PAGE, 2.5))
    for index, (name, mine) in enumerate(rows.items()):
        colour, pattern = style.line_of(index)
        marks, means, deviations = summary(mine)
        look = {"color": colour, "linewidth": 1.8 if index == 0 else 0.9}
        for ax, column in zip(axes[:2], (1, 2), strict=True):
            mean, deviation = means[:, column], deviations[:, column]
            ax.plot(marks, mean, pattern, label=name, **look)
            ax.fill_between(
                marks, mean - deviation, mean + deviation, color=colour, alpha=0.2, lw=0
            )
        axes[2].plot(means[:, 0], means[:, 1], pattern, **look)
    unit = f"{problem.unit}²" if problem.unit else ""
    axes[0].set(xlabel="evaluations", ylabel=style.with_unit("coverage", unit))
    axes[1].set(xlabel="evaluations", ylabel="occupied cells (%)")
    axes[2].set(xlabel="time (s)", ylabel=style.with_unit("coverage", unit), xscale="log")
    for letter, ax in zip("abc", axes, strict=True):
        ax.set_title(f"({letter}) {problem.name}" if letter == "a" else f"({letter})")
        ax.set_ylim(bottom=0)
    handles, labels = axes[0].get_legend_handles_labels()
    figure.legend(handles, labels, frameon=False, loc="outside lower center", ncols=5)
    return figure
