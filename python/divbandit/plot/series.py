"""series: what each of several competitors reached, as something else was varied."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

from divbandit.plot import style
from divbandit.plot.data import means_and_deviations, shaped
from divbandit.plot.estimates import check_labels

if TYPE_CHECKING:
    from collections.abc import Sequence

    from matplotlib.axes import Axes
    from numpy.typing import ArrayLike

#: Markers, in order.
_MARKERS = ("o", "D", "s", "^", "v", "P", "X", "<", ">", "p")
#: The other properties of all lines.
_LINE: Any = {"linewidth": 0.9, "markersize": 2.8, "markeredgewidth": 0}


def series(
    places: ArrayLike,
    data: ArrayLike,
    *,
    labels: Sequence[str],
    baseline: ArrayLike | None = None,
    baseline_label: str = "",
    unit: str = "",
    ax: Axes | None = None,
) -> Axes:
    """Draw a line of means with their deviations for each competitor.

    Parameters
    ----------
    places : array_like, shape (k,)
        What was varied; positive, as its axis is logarithmic.
    data : array_like, shape (q, k, 2)
        Mean and standard deviation of what was covered, by competitor and place.
    labels : sequence of str
        The competitors' names.
    baseline : array_like, shape (k,), optional
        Means to compare with, drawn in black without deviations.
    baseline_label : str
        What these are.
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
        If the arrays do not fit each other, or a place is not positive.

    Examples
    --------
    >>> from divbandit import plot
    >>> ax = plot.series([2, 4], [[[1.0, 0.1], [2.0, 0.1]]], labels=["ADAPT"], unit="m²")
    >>> ax.get_xscale(), ax.get_ylabel()
    ('log', 'coverage (m²)')
    """
    x = shaped("places", places, "k")
    if not (x > 0).all():
        raise ValueError(f"places must be positive numbers, got {places!r}")
    values = shaped("data", data, "q", len(x), 2)
    check_labels(labels, len(values))
    compared = None if baseline is None else shaped("baseline", baseline, len(x))
    ax = style.axes(ax)
    if compared is not None:
        ax.plot(x, compared, color="black", linestyle="--", linewidth=0.8, label=baseline_label)
    # Side by side, so that deviations of neighbours can be told apart.
    shifts = 2.0 ** (0.02 * (np.arange(len(values)) - (len(values) - 1) / 2))
    for index, (each, label) in enumerate(zip(values, labels, strict=True)):
        colour, pattern = style.line_of(index)
        place = x * shifts[index]
        deviations = means_and_deviations(each)[:, 1]
        ax.errorbar(place, each[:, 0], deviations, fmt="none", color=colour, elinewidth=0.5)
        marker = _MARKERS[index % len(_MARKERS)]
        ax.plot(place, each[:, 0], pattern, color=colour, marker=marker, label=label, **_LINE)
    ax.set_xscale("log", base=2)
    ax.set_xticks(x, [f"{place:g}" for place in x])
    ax.minorticks_off()
    ax.set_ylabel(style.with_unit("coverage", unit))
    return ax
