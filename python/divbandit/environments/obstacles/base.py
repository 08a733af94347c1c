"""Obstacle: what all obstacles have in common."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

from divbandit._value import Value

if TYPE_CHECKING:
    from collections.abc import Iterable

    from divbandit import _core


@dataclass(frozen=True, init=False, repr=False)
class Obstacle(Value):
    """Base class of `Disc`, `Rectangle`, `Polygon` and `Wall`; all lengths are in metres.

    Examples
    --------
    >>> from divbandit.environments import Disc
    >>> Disc([0.5, 0.5], 0.1) == Disc([0.5, 0.5], 0.1)
    True
    """

    if TYPE_CHECKING:
        _kernel: _core.Obstacle


def checked(obstacles: Iterable[Obstacle]) -> tuple[Obstacle, ...]:
    """Return obstacles as a tuple, or raise a TypeError."""
    try:
        every = tuple(obstacles)
    except TypeError:
        kind = type(obstacles).__name__
        raise TypeError(f"obstacles must be a list of obstacles, got {kind}") from None
    for index, each in enumerate(every):
        if not isinstance(each, Obstacle):
            raise TypeError(
                f"obstacles[{index}] must be a Disc, Rectangle, Polygon or Wall, "
                f"got {type(each).__name__}"
            )
    return every


def kernels(obstacles: Iterable[Obstacle]) -> list[_core.Obstacle]:
    """Return the compiled counterparts of obstacles."""
    return [each._kernel for each in obstacles]  # noqa: SLF001 - kept for this
