"""mixtures: the diversity that fixed mixtures reach, and what a bandit reaches beside them."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from divbandit.plot import style
from divbandit.plot.data import shaped

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from numpy.typing import ArrayLike


def mixtures(
    data: ArrayLike,
    *,
    adapt: tuple[float, float] | None = None,
    archive: ArrayLike | None = None,
    unit: str = "",
    ax: Axes | None = None,
) -> Axes:
    """Draw final diversity against the share of the first strategy in a mixture.

    Parameters
    ----------
    data : array_like, shape (k, 3)
        Ratio, mean and standard deviation of the final diversity, a row a mixture.
    adapt : (mean, standard deviation), optional
        What the bandit reaches: a dotted line with its band.
    archive : array_like, shape (k, 2), optional
        Ratio and mean found elsewhere, drawn as crosses.
    unit : str
        The unit of diversity, for the label of the axis.
    ax : matplotlib.axes.Axes, optional
        Where to draw; by default in a new figure.

    Returns
    -------
    matplotlib.axes.Axes

    Raises
    ------
    ValueError
        If an array has another shape.

    Examples
    --------
    >>> from divbandit import plot
    >>> ax = plot.mixtures([[0, 1.0, 0.1], [1, 2.0, 0.1]], adapt=(2.1, 0.1))
    >>> ax.get_xlabel()
    'motor babbling ratio'
    """
    points = shaped("data", data, "k", 3)
    found = np.empty((0, 2)) if archive is None else shaped("archive", archive, "k", 2)
    if adapt is not None:
        shaped("adapt", adapt, 2)
    ax = style.axes(ax)
    ax.errorbar(
        points[:, 0],
        points[:, 1],
        yerr=points[:, 2],
        color=style.COLOURS[0],
        marker="o",
        markersize=2.5,
        linewidth=0.8,
        elinewidth=0.6,
        capsize=1.5,
        label="mixture, ± 1 s.d.",
    )
    if adapt is not None:
        mean, deviation = adapt
        colour = style.COLOURS[1]
        ax.axhspan(mean - deviation, mean + deviation, color=colour, alpha=0.2, linewidth=0)
        ax.axhline(mean, color=colour, linestyle=":", label="ADAPT, ± 1 s.d.")
    if len(found):
        ax.plot(*found.T, "kx", ms=2.5, mew=0.6, label="archived mixture", zorder=3)
    ax.set(xlim=(-0.03, 1.03), xlabel="motor babbling ratio")
    ax.set(ylim=(0, None), ylabel=style.with_unit("diversity", unit))
    return ax
