"""spread: where the effects lie, and the area that they cover."""

from __future__ import annotations

from typing import TYPE_CHECKING

from divbandit.measures import Coverage
from divbandit.plot import style
from divbandit.plot.data import effects_of

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from numpy.typing import ArrayLike

    from divbandit.exploration import Exploration


def spread(
    data: Exploration | ArrayLike,
    *,
    tau: float | None = None,
    unit: str = "",
    ax: Axes | None = None,
) -> Axes:
    """Draw effects as dots and, given `tau`, the union of the discs around them.

    Parameters
    ----------
    data : Exploration or array_like, shape (n, 2)
        The effects.
    tau : float, optional
        Radius of the discs, in the units of the effects; positive.
    unit : str
        The unit of the effects, for the labels of the axes.
    ax : matplotlib.axes.Axes, optional
        Where to draw; by default in a new figure.

    Returns
    -------
    matplotlib.axes.Axes

    Raises
    ------
    TypeError, ValueError
        If the effects are not in the plane, or `tau` is not a positive number.

    Examples
    --------
    >>> import divbandit as db
    >>> from divbandit import plot
    >>> run = db.explore(db.PlanarArm(20), db.MotorBabbling(), n=100, rng=0)
    >>> plot.spread(run, tau=0.02, unit="m").get_xlabel()
    'x (m)'
    """
    effects = effects_of(data)
    tau = None if tau is None else Coverage(tau).tau
    ax = style.axes(ax)
    if tau is not None:
        from matplotlib.collections import EllipseCollection  # noqa: PLC0415

        size = [2 * tau] * len(effects)
        discs = EllipseCollection(
            size,
            size,
            [0.0] * len(effects),
            units="xy",
            offsets=effects,
            offset_transform=ax.transData,
            facecolors=style.COVERED,
            edgecolors="none",
            rasterized=True,
        )
        ax.add_collection(discs)
    width = 0.8 if tau is None else 0.5
    ax.plot(*effects.T, "o", color=style.EFFECT, ms=width, mew=0, rasterized=True)
    return style.plane(ax, unit)
