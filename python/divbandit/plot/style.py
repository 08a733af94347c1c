"""Colours, sizes and axes that all figures share.

The colours are those of Okabe and Ito, told apart by colour-blind readers.
"""

from __future__ import annotations

from contextlib import contextmanager
from itertools import chain
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from collections.abc import Iterable, Iterator
    from pathlib import Path

    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

#: One colour a strategy, in order.
COLOURS = ("#0072B2", "#D55E00", "#009E73", "#CC79A7", "#56B4E9", "#E69F00")
#: One pattern for each round through the colours.
PATTERNS = ("-", "--", ":", "-.")
#: The covered area, under everything else.
COVERED = "#A9D1EC"
#: Single effects.
EFFECT = "#222222"
#: Obstacles, under effects and postures.
OBSTACLE = "#999999"
#: A ball where it lies at first.
BALL = "#F0E442"
#: Widths of a column and of a page of two, in inches.
COLUMN, PAGE = 3.5, 7.16


def axes(ax: Axes | None) -> Axes:
    """Return `ax`, or the axes of a new figure."""
    if ax is not None:
        return ax
    try:
        import matplotlib.pyplot as plt  # noqa: PLC0415 - only figures need matplotlib
    except ImportError as error:
        raise ImportError("figures need matplotlib: pip install 'divbandit[plot]'") from error
    return plt.subplots()[1]


def line_of(index: int) -> tuple[str, str]:
    """Return the colour and the pattern of the line of strategy `index`."""
    pattern = PATTERNS[index // len(COLOURS) % len(PATTERNS)]
    return COLOURS[index % len(COLOURS)], pattern


def with_unit(label: str, unit: str) -> str:
    """Return an axis label with its unit, if there is one."""
    return f"{label} ({unit})" if unit else label


def plane(ax: Axes, unit: str) -> Axes:
    """Make axes those of positions, x and y on the same scale, and return them."""
    ax.set_aspect("equal")
    ax.set(xlabel=with_unit("x", unit), ylabel=with_unit("y", unit))
    return ax


def legend_below(figure: Figure, every: Iterable[Axes]) -> None:
    """Name, below a figure and in one row, what is drawn in some of its axes."""
    shown = [ax.get_legend_handles_labels() for ax in every]
    handles, labels = (list(chain.from_iterable(each)) for each in zip(*shown, strict=True))
    figure.legend(handles, labels, frameon=False, loc="outside lower center", ncols=len(labels))


@contextmanager
def printed() -> Iterator[None]:
    """Set matplotlib's sizes for a figure at its printed size, and make files reproducible."""
    import matplotlib as mpl  # noqa: PLC0415 - only figures need matplotlib

    sizes: Any = {
        "axes.labelsize": 7,
        "axes.linewidth": 0.5,
        "axes.titlesize": 8,
        "figure.constrained_layout.use": True,
        "font.size": 7,
        "legend.fontsize": 6.5,
        "lines.linewidth": 1.0,
        "savefig.dpi": 300,
        "svg.hashsalt": "divbandit",
        "xtick.labelsize": 6.5,
        "xtick.major.width": 0.5,
        "ytick.labelsize": 6.5,
        "ytick.major.width": 0.5,
    }
    with mpl.rc_context(sizes):
        yield


def save(figure: Figure, stem: Path) -> None:
    """Write a figure as PNG and SVG, the same bytes for the same figure, and close it."""
    import matplotlib.pyplot as plt  # noqa: PLC0415 - only figures need matplotlib

    figure.savefig(stem.with_suffix(".png"))
    figure.savefig(stem.with_suffix(".svg"), metadata={"Date": None})
    plt.close(figure)
