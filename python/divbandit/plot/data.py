"""What the figures show, as plain arrays."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from divbandit._checks import whole
from divbandit.exploration import Exploration

if TYPE_CHECKING:
    from numpy.typing import ArrayLike, NDArray


def effects_of(data: Exploration | ArrayLike) -> NDArray[np.float64]:
    """Return the effects of an exploration, or `data` itself, as effects in the plane.

    Examples
    --------
    >>> effects_of([[0, 1], [2, 3]]).shape
    (2, 2)
    """
    if not isinstance(data, Exploration):
        return shaped("data", data, "n", 2)
    if data.effects.shape[1] > 2:
        raise ValueError(
            f"data must have shape (n, 2), got {data.effects.shape}: "
            "two coordinates of the effects are run.effects[:, :2]"
        )
    return shaped("data", data.effects, "n", 2)


def numbers(name: str, values: ArrayLike) -> NDArray[np.float64]:
    """Return `values` as an array of floats, or name the argument that is none.

    Examples
    --------
    >>> numbers("data", [1, 2])
    array([1., 2.])
    """
    try:
        return np.asarray(values, dtype=float)
    except (TypeError, ValueError) as error:
        raise type(error)(f"{name} must be an array of numbers: {error}") from None


def shaped(name: str, values: ArrayLike, *shape: int | str) -> NDArray[np.float64]:
    """Return `values` as an array of floats of a shape, in which lengths with a name may be any.

    Examples
    --------
    >>> shaped("data", [[1, 2]], "n", 2)
    array([[1., 2.]])
    >>> shaped("data", [1, 2], "n", 2)
    Traceback (most recent call last):
        ...
    ValueError: data must have shape (n, 2), got (2,)
    """
    found = numbers(name, values)
    wrong = (want not in (got, str(want)) for want, got in zip(shape, found.shape, strict=False))
    if found.ndim != len(shape) or any(wrong):
        wanted = ", ".join(map(str, shape))
        raise ValueError(f"{name} must have shape ({wanted}), got {found.shape}")
    return found


def capsule(start: ArrayLike, end: ArrayLike, thickness: float) -> NDArray[np.float64]:
    """Return the outline of a segment with rounded ends, half of its thickness on either side.

    Examples
    --------
    >>> outline = capsule([0, 0], [1, 0], 0.2)
    >>> outline.shape, outline.min(axis=0).round(12), outline.max(axis=0).round(12)
    ((34, 2), array([-0.1, -0.1]), array([1.1, 0.1]))
    """
    start, end = numbers("start", start), numbers("end", end)
    along = end - start
    heading = np.arctan2(along[1], along[0])
    turns = heading + np.linspace(-np.pi / 2, np.pi / 2, 17)
    half = 0.5 * thickness * np.stack([np.cos(turns), np.sin(turns)], axis=-1)
    outline: NDArray[np.float64] = np.concatenate([end + half, start - half])
    return outline


def means_and_deviations(data: ArrayLike) -> NDArray[np.float64]:
    """Return means with their standard deviations, shape (k, 2).

    Examples
    --------
    >>> means_and_deviations([[2.0, 0.1], [1.5, 0.2]]).shape
    (2, 2)
    """
    points = shaped("data", data, "k", 2)
    if not (points[:, 1] >= 0).all():
        raise ValueError(f"data must hold means and standard deviations, got {data!r}")
    return points


def estimates_of(data: Exploration | ArrayLike) -> NDArray[np.float64]:
    """Return a bandit's estimates before each choice, shape (n, q).

    Examples
    --------
    >>> estimates_of([[0.1, 0.2], [0.1, 0.3]]).shape
    (2, 2)
    """
    if isinstance(data, Exploration):
        if data.estimates is None:
            raise ValueError("data must be the exploration of a bandit: it has no estimates")
        return data.estimates
    return shaped("data", data, "n", "q")


def usage_of(
    data: Exploration | ArrayLike, *, window: int = 100, strategies: int | None = None
) -> NDArray[np.float64]:
    """Return the share of each strategy among the choices around each step.

    Parameters
    ----------
    data : Exploration or array_like of int, shape (n,)
        The choices.
    window : int
        Steps over which the centred mean is taken; near both ends, over those that exist.
    strategies : int, optional
        How many strategies there are; by default those that were chosen or have estimates.

    Returns
    -------
    numpy.ndarray of float64, shape (n, strategies)
        In [0, 1]; each row sums to 1, or is NaN where there are evaluations of the past alone.

    Raises
    ------
    TypeError, ValueError
        If the choices are not indices, or `window` is not at least 1.

    Examples
    --------
    >>> usage_of([0, 0, 1, 1], window=2)
    array([[1. , 0. ],
           [1. , 0. ],
           [0.5, 0.5],
           [0. , 1. ]])
    """
    window = whole("window", window, low=1)
    choices = data.choices if isinstance(data, Exploration) else np.asarray(data)
    indices = choices.ndim == 1 and choices.size > 0 and choices.dtype.kind in "iu"
    if not indices:
        got = f"{choices.dtype} of shape {choices.shape}"
        raise ValueError(f"data must hold choices, indices of shape (n,), got {got}")
    if choices.min() < 0 and not isinstance(data, Exploration):
        where = int(choices.argmin())
        raise ValueError(f"data must hold indices of strategies, got {choices[where]} at {where}")
    least = max(int(choices.max()) + 1, 1)
    if strategies is None:
        known = data.estimates if isinstance(data, Exploration) else None
        strategies = least if known is None else known.shape[1]
    strategies = whole("strategies", strategies, low=least)
    counts = np.zeros((len(choices) + 1, strategies))
    counts[1:] = np.cumsum(choices[:, None] == np.arange(strategies), axis=0)
    steps = np.arange(len(choices))
    first = np.maximum(steps - window // 2, 0)
    last = np.minimum(steps - window // 2 + window, len(choices))
    chosen = counts[last] - counts[first]
    with np.errstate(invalid="ignore"):
        shares: NDArray[np.float64] = chosen / chosen.sum(axis=1, keepdims=True)
    return shares
