"""Ties: which are the best, where several are."""

from __future__ import annotations

from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from collections.abc import Sequence


def best(values: Sequence[float]) -> list[int]:
    """Return where the largest values are.

    Examples
    --------
    >>> best([1.0, 3.0, 2.0, 3.0])
    [1, 3]
    """
    largest = max(values)
    return [index for index, value in enumerate(values) if value == largest]
