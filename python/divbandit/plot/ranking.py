"""ranking: what each of several competitors reached, a row each."""

from __future__ import annotations

from typing import TYPE_CHECKING

from divbandit.plot import style
from divbandit.plot.data import means_and_deviations
from divbandit.plot.estimates import check_labels

if TYPE_CHECKING:
    from collections.abc import Mapping, Sequence

    from matplotlib.axes import Axes
    from numpy.typing import ArrayLike

#: Line patterns of the marks, in order.
_MARKS = ("-", ":", "--", "-.")


def ranking(
    data: ArrayLike,
    *,
    labels: Sequence[str],
    marks: Mapping[str, float] | None = None,
    highlight: int | None = None,
    unit: str = "",
    ax: Axes | None = None,
) -> Axes:
    """Draw a mean and its deviation in a row for each competitor, the first one on top.

    Parameters
    ----------
    data : array_like, shape (k, 2)
        Mean and standard deviation of what was covered, a row a competitor.
    labels : sequence of str
        Their names.
    marks : mapping from str to float, optional
        Values to compare with, by name: vertical lines.
    highlight : int, optional
        Which competitor to set off from the others.
    unit : str
        The unit of coverage, for the label of the axis.
    ax : matplotlib.axes.Axes, optional
        Where to draw; by default in a new figure.

    Returns
    -------
    matplotlib.axes.Axes

    Raises
    ------
    ValueError
        If `data` has another shape, or the number of labels differs.

    Examples
    --------
    >>> from divbandit import plot
    >>> ax = plot.ranking([[2.0, 0.1], [1.5, 0.2]], labels=["a", "b"], marks={"best": 2.1})
    >>> [text.get_text() for text in ax.get_yticklabels()]
    ['a', 'b']
    """
    points = means_and_deviations(data)
    check_labels(labels, len(points))
    ax = style.axes(ax)
    for pattern, (name, value) in zip(_MARKS, (marks or {}).items(), strict=False):
        ax.axvline(value, color="black", linestyle=pattern, linewidth=0.7, label=name, zorder=1)
    for place, (mean, deviation) in enumerate(points):
        set_off = place == highlight
        ax.errorbar(
            mean,
            place,
            xerr=deviation,
            color=style.COLOURS[1 if set_off else 0],
            marker="D" if set_off else "o",
            markersize=3.2,
            linewidth=0,
            elinewidth=1.0,
            capsize=0,
        )
    ax.set_yticks(range(len(points)), labels)
    ax.set_ylim(len(points) - 0.5, -0.5)
    ax.tick_params(axis="y", length=0)
    ax.locator_params(axis="x", nbins=5)
    ax.grid(axis="y", color="0.9", linewidth=0.5)
    ax.set_axisbelow(True)
    ax.set_xlabel(style.with_unit("coverage", unit))
    return ax
