"""usage: how often each strategy was chosen, over time."""

from __future__ import annotations

from typing import TYPE_CHECKING

from divbandit.plot import style
from divbandit.plot.data import usage_of
from divbandit.plot.estimates import check_labels, curves

if TYPE_CHECKING:
    from collections.abc import Sequence

    from matplotlib.axes import Axes
    from numpy.typing import ArrayLike

    from divbandit.exploration import Exploration


def usage(
    data: Exploration | ArrayLike,
    *,
    window: int = 100,
    labels: Sequence[str] | None = None,
    ax: Axes | None = None,
) -> Axes:
    """Draw each strategy's share of the choices, a centred mean, against the steps.

    Parameters
    ----------
    data : Exploration or array_like of int, shape (n,)
        The choices.
    window : int
        Steps over which the mean is taken.
    labels : sequence of str, optional
        The strategies' names.
    ax : matplotlib.axes.Axes, optional
        Where to draw; by default in a new figure.

    Returns
    -------
    matplotlib.axes.Axes

    Raises
    ------
    TypeError, ValueError
        If the choices are not indices, or `window` is not at least 1.

    Examples
    --------
    >>> from divbandit import plot
    >>> plot.usage([0, 1, 1, 0], window=2, labels=["a", "b"]).get_ylabel()
    'usage (%)'
    """
    shares = usage_of(data, window=window)
    if labels is not None and len(labels) > shares.shape[1]:
        shares = usage_of(data, window=window, strategies=len(labels))
    check_labels(labels, shares.shape[1])
    ax = style.axes(ax)
    curves(ax, 100 * shares, labels)
    ax.set_ylim(0, 100)
    ax.set_ylabel("usage (%)")
    return ax
