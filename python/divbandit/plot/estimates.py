"""estimates: a bandit's estimates of its strategies, over time."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from divbandit.plot import style
from divbandit.plot.data import estimates_of

if TYPE_CHECKING:
    from collections.abc import Sequence

    from matplotlib.axes import Axes
    from numpy.typing import ArrayLike

    from divbandit.exploration import Exploration


def estimates(
    data: Exploration | ArrayLike,
    *,
    labels: Sequence[str] | None = None,
    unit: str = "",
    ax: Axes | None = None,
) -> Axes:
    """Draw a bandit's estimate of each strategy against the steps.

    Parameters
    ----------
    data : Exploration or array_like, shape (n, q)
        The estimates before each choice.
    labels : sequence of str, optional
        The strategies' names.
    unit : str
        The unit of a reward, for the label of the axis.
    ax : matplotlib.axes.Axes, optional
        Where to draw; by default in a new figure.

    Returns
    -------
    matplotlib.axes.Axes

    Raises
    ------
    ValueError
        If `data` has another shape or is an exploration without a bandit.

    Examples
    --------
    >>> import divbandit as db
    >>> from divbandit import plot
    >>> adapt = db.Adapt([db.MotorBabbling(), db.GoalBabbling(0.05)], tau=0.02)
    >>> run = db.explore(db.PlanarArm(20), adapt, n=100, rng=0)
    >>> ax = plot.estimates(run, labels=["motor babbling", "goal babbling"])
    >>> len(ax.lines)
    2
    """
    believed = estimates_of(data)
    check_labels(labels, believed.shape[1])
    ax = style.axes(ax)
    curves(ax, believed, labels)
    ax.set_ylim(bottom=0)
    ax.set_ylabel(style.with_unit("estimate", unit))
    return ax


def curves(ax: Axes, values: np.ndarray, labels: Sequence[str] | None) -> None:
    """Draw one line a strategy against the steps, with a legend if they have names."""
    steps = np.arange(1, len(values) + 1)
    for index in range(values.shape[1]):
        colour, pattern = style.line_of(index)
        label = None if labels is None else labels[index]
        ax.plot(steps, values[:, index], pattern, color=colour, label=label)
    ax.set_xlim(0, len(values))
    ax.set_xlabel("step")
    if labels is not None:
        ax.legend(frameon=False)


def check_labels(labels: Sequence[str] | None, count: int) -> None:
    """Require a name for each of `count` strategies, or none at all."""
    if labels is not None and len(labels) != count:
        raise ValueError(f"labels must name {count} strategies, got {len(labels)}")
