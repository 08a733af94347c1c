"""postures: how an arm lay."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from divbandit.plot import style
from divbandit.plot.data import numbers

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from numpy.typing import ArrayLike


def postures(data: ArrayLike, *, unit: str = "", ax: Axes | None = None) -> Axes:
    """Draw postures as chains of segments from the base to the tip.

    Parameters
    ----------
    data : array_like, shape (joints + 1, 2) or (k, joints + 1, 2)
        One posture or several, as `PlanarArm.posture` returns them; later ones are drawn darker.
    unit : str
        The unit of the positions, for the labels of the axes.
    ax : matplotlib.axes.Axes, optional
        Where to draw; by default in a new figure.

    Returns
    -------
    matplotlib.axes.Axes

    Raises
    ------
    ValueError
        If `data` has another shape.

    Examples
    --------
    >>> import divbandit as db
    >>> from divbandit import plot
    >>> ax = plot.postures(db.PlanarArm(5).posture([0.3] * 5), unit="m")
    >>> len(ax.lines)
    3
    """
    chains = numbers("data", data)
    chains = chains[None] if chains.ndim == 2 else chains
    if chains.ndim != 3 or chains.shape[2] != 2 or chains.size == 0:
        raise ValueError(f"data must have shape (k, joints + 1, 2), got {np.shape(data)}")
    ax = style.axes(ax)
    for index, chain in enumerate(chains):
        strength = 0.35 + 0.65 * (index + 1) / len(chains)
        ax.plot(
            chain[:, 0],
            chain[:, 1],
            color=style.COLOURS[0],
            alpha=strength,
            marker="o",
            markersize=1.5,
            markeredgewidth=0,
        )
    orange = style.COLOURS[1]
    for points, marker, colour, name in (
        (chains[:, -1], "o", orange, "tip"),
        (chains[:1, 0], "s", "black", "base"),
    ):
        ax.plot(
            points[:, 0],
            points[:, 1],
            linestyle="none",
            marker=marker,
            markersize=3,
            color=colour,
            zorder=3,
            label=name,
        )
    ax.set_aspect("equal")
    ax.set_xlabel(style.with_unit("x", unit))
    ax.set_ylabel(style.with_unit("y", unit))
    return ax
