"""postures: the shapes that an arm took."""

from __future__ import annotations

import itertools
from typing import TYPE_CHECKING

import numpy as np

from divbandit._checks import positive
from divbandit.plot import style
from divbandit.plot.data import capsule, numbers

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from numpy.typing import ArrayLike, NDArray


def postures(
    data: ArrayLike,
    *,
    thickness: float | None = None,
    unit: str = "",
    ax: Axes | None = None,
) -> Axes:
    """Draw postures as chains of segments from the base to the tip.

    Parameters
    ----------
    data : array_like, shape (joints + 1, 2) or (k, joints + 1, 2)
        One posture or several, as `PlanarArm.posture` returns them; later ones are drawn darker.
    thickness : float, optional
        How thick the links are, in the units of the positions; positive. By default they are lines.
    unit : str
        The unit of the positions, for the labels of the axes.
    ax : matplotlib.axes.Axes, optional
        Where to draw; by default in a new figure.

    Returns
    -------
    matplotlib.axes.Axes

    Raises
    ------
    TypeError, ValueError
        If `data` has another shape, or `thickness` is not a positive number.

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
    thickness = None if thickness is None else positive("thickness", thickness)
    ax = style.axes(ax)
    for index, chain in enumerate(chains):
        strength = 0.35 + 0.65 * (index + 1) / len(chains)
        if thickness is not None:
            _links(chain, thickness, strength, ax)
            continue
        ax.plot(*chain.T, "o-", color=style.COLOURS[0], alpha=strength, ms=1.5, mew=0)
    orange = style.COLOURS[1]
    for points, marker, colour, name in (
        (chains[:, -1], "o", orange, "tip"),
        (chains[:1, 0], "s", "black", "base"),
    ):
        ax.plot(*points.T, marker, markersize=3, color=colour, zorder=3, label=name)
    return style.plane(ax, unit)


def _links(chain: NDArray[np.float64], thickness: float, strength: float, ax: Axes) -> None:
    """Draw links as thick as they are; where two overlap, at the joints, they are darker."""
    from matplotlib.collections import PolyCollection  # noqa: PLC0415

    ends = itertools.pairwise(chain)
    links = PolyCollection(
        [capsule(start, end, thickness) for start, end in ends],
        facecolors=style.COLOURS[0],
        edgecolors="none",
        alpha=0.7 * strength,
        zorder=2,
    )
    ax.add_collection(links)
    ax.autoscale_view()
