"""scene: what an arm can touch, and what it can push."""

from __future__ import annotations

from collections.abc import Iterable
from typing import TYPE_CHECKING, Protocol

import numpy as np

from divbandit.environments import Disc, Polygon, Rectangle, Wall
from divbandit.environments.obstacles import Obstacle
from divbandit.plot import style
from divbandit.plot.data import capsule

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.patches import Patch


class Obstructed(Protocol):
    """An environment with obstacles, as `PlanarArm` is one."""

    @property
    def obstacles(self) -> tuple[Obstacle, ...]:
        """What is in the way."""


def scene(data: Obstructed | Iterable[Obstacle], *, unit: str = "", ax: Axes | None = None) -> Axes:
    """Draw obstacles and, where there is one, the ball where it lies at first.

    Effects and postures drawn into the same axes lie on top, what effects cover lies below.

    Parameters
    ----------
    data : environment with ``obstacles``, or iterable of Disc, Rectangle, Polygon and Wall
        An environment may have a ball, too: ``ball``, shape (2,), and ``ball_radius``.
    unit : str
        The unit of the positions, for the labels of the axes.
    ax : matplotlib.axes.Axes, optional
        Where to draw; by default in a new figure.

    Returns
    -------
    matplotlib.axes.Axes

    Raises
    ------
    TypeError
        If `data` neither has obstacles nor holds them.

    Examples
    --------
    >>> import divbandit as db
    >>> from divbandit import plot
    >>> from divbandit.environments import Disc, Wall
    >>> arm = db.PlanarArm(5, obstacles=[Disc([0.5, 0.4], 0.1), Wall([-1, 0.8], [1, 0.8])])
    >>> ax = plot.scene(arm, unit="m")
    >>> len(ax.patches), len(ax.lines)
    (1, 1)
    """
    obstacles = _obstacles_of(data)
    ball, ball_radius = (getattr(data, name, None) for name in ("ball", "ball_radius"))
    ax = style.axes(ax)
    for index, obstacle in enumerate(obstacles):
        label = "_nolegend_" if index else "obstacle"
        if isinstance(obstacle, Wall) and obstacle.thickness == 0:
            ends = np.stack([obstacle.start, obstacle.end])
            ax.plot(ends[:, 0], ends[:, 1], color=style.OBSTACLE, zorder=1, label=label)
        else:
            patch = _patch(obstacle)
            # The line makes visible what is thinner than it.
            patch.set(facecolor=style.OBSTACLE, edgecolor=style.OBSTACLE, linewidth=0.5)
            patch.set(zorder=1, label=label)
            ax.add_patch(patch)
    if ball is not None and ball_radius is not None:
        from matplotlib.patches import Circle  # noqa: PLC0415 - only figures need matplotlib

        circle = Circle(tuple(ball), ball_radius)
        circle.set(facecolor=style.BALL, edgecolor="black", linewidth=0.5, zorder=1, label="ball")
        ax.add_patch(circle)
    ax.autoscale_view()
    return style.plane(ax, unit)


def _obstacles_of(data: object) -> tuple[Obstacle, ...]:
    found = getattr(data, "obstacles", data)
    every = tuple(found) if isinstance(found, Iterable) else (found,)
    for each in every:
        if not isinstance(each, Obstacle):
            raise TypeError(
                "data must be an environment with obstacles, or obstacles: Disc, Rectangle, "
                f"Polygon or Wall, got {type(each).__name__}"
            )
    return every


def _patch(obstacle: Obstacle) -> Patch:
    """Return the shape of an obstacle that has an area."""
    from matplotlib import patches  # noqa: PLC0415 - only figures need matplotlib

    match obstacle:
        case Disc(center=(x, y)):
            return patches.Circle((x, y), obstacle.radius)
        case Rectangle(low=(x, y), high=(right, top)):
            return patches.Rectangle((x, y), right - x, top - y)
        case Polygon():
            return patches.Polygon(obstacle.points, closed=True)
        case Wall():
            return patches.Polygon(capsule(obstacle.start, obstacle.end, obstacle.thickness))
    raise TypeError(obstacle)
