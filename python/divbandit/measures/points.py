"""Points that a measure written in Python is given, checked as the kernels check theirs."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

if TYPE_CHECKING:
    from numpy.typing import ArrayLike, NDArray


def many(name: str, value: ArrayLike, dim: int | None) -> NDArray[np.float64]:
    """Return `value` as finite points of shape (n, dim), or say what is wrong with it.

    Where `dim` is None any dimension will do.

    Examples
    --------
    >>> many("effects", [[0, 1], [2, 3], [4, 5]], 2).shape
    (3, 2)
    """
    array = _reals(name, value)
    if array.ndim != 2 or array.shape[1] < 1 or dim not in {None, array.shape[1]}:
        width = "s" if dim is None else dim
        raise ValueError(f"{name} must have shape (n, {width}), got {_shape(array)}")
    return _finite(name, array)


def one_or_many(name: str, value: ArrayLike, dim: int) -> NDArray[np.float64]:
    """Return `value` as a finite point of shape (dim,), or such points of shape (n, dim).

    Examples
    --------
    >>> one_or_many("effect", [2, 3], 2)
    array([2., 3.])
    """
    array = _reals(name, value)
    if array.ndim not in {1, 2} or array.shape[-1] != dim:
        raise ValueError(f"{name} must have shape ({dim},) or (n, {dim}), got {_shape(array)}")
    return _finite(name, array)


def element(name: str, row: int | None, column: int) -> str:
    """Say which number of a point is meant, or of one among many.

    Examples
    --------
    >>> element("effect", None, 1), element("effects", 7, 1)
    ('effect[1]', 'effects[7, 1]')
    """
    return f"{name}[{column}]" if row is None else f"{name}[{row}, {column}]"


def _reals(name: str, value: ArrayLike) -> NDArray[np.float64]:
    """Return an array of float64; booleans, text, complex numbers and objects are refused."""
    if isinstance(value, np.ma.MaskedArray):
        raise TypeError(f"{name} must be an array of real numbers, got a masked array")
    kind = type(value).__name__
    try:
        array = np.asarray(value)
    except (TypeError, ValueError):  # rows of several lengths
        raise TypeError(f"{name} must be an array of real numbers, got {kind}") from None
    if array.dtype.kind not in "fiu":
        raise TypeError(
            f"{name} must be an array of real numbers, got {kind} of dtype {array.dtype}"
        )
    with np.errstate(over="ignore"):  # a longer float becomes infinite, and is refused as that
        return array.astype(np.float64, copy=False)


def _finite(name: str, array: NDArray[np.float64]) -> NDArray[np.float64]:
    finite = np.isfinite(array)
    if not finite.all():
        *row, column = np.argwhere(~finite)[0].tolist()
        where = element(name, row[0] if row else None, column)
        raise ValueError(f"{where} must be finite, got {float(array[(*row, column)])}")
    return array


def _shape(array: NDArray[np.float64]) -> str:
    return "a single number (put it in a list)" if array.ndim == 0 else str(array.shape)
