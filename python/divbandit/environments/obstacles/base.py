"""Obstacle: what all obstacles have in common."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

if TYPE_CHECKING:
    from collections.abc import Iterable

    from divbandit import _core


class Obstacle:
    """One of `Disc`, `Rectangle`, `Polygon` and `Wall`; all in metres.

    Each keeps the arguments it was made with as attributes that cannot be changed. Two of the same
    kind with the same arguments are equal.

    Examples
    --------
    >>> import divbandit as db
    >>> db.Disc([0.5, 0.5], 0.1) == db.Disc([0.5, 0.5], 0.1)
    True
    """

    _kernel: _core.Obstacle

    def _arguments(self) -> tuple[Any, ...]:
        raise NotImplementedError

    def __setattr__(self, name: str, value: object) -> None:
        if "_kernel" in vars(self):
            raise AttributeError(f"{type(self).__name__}.{name} cannot be changed")
        super().__setattr__(name, value)

    def __eq__(self, other: object) -> bool:
        if type(other) is not type(self):
            return NotImplemented
        return self._key() == other._key()

    def __hash__(self) -> int:
        return hash(self._key())

    def _key(self) -> tuple[object, ...]:
        return type(self), *(np.asarray(each).tobytes() for each in self._arguments())

    def __reduce__(self) -> tuple[object, ...]:
        return type(self), self._arguments()

    def __repr__(self) -> str:
        each = [repr(np.asarray(argument).tolist()) for argument in self._arguments()]
        return f"{type(self).__name__}({', '.join(each)})"


def checked(obstacles: Iterable[Obstacle]) -> tuple[Obstacle, ...]:
    """Return obstacles as a tuple.

    Raises
    ------
    TypeError
        If one of them is none.

    Examples
    --------
    >>> import divbandit as db
    >>> checked([db.Wall([0, 1], [1, 1])])
    (Wall([0.0, 1.0], [1.0, 1.0], thickness=0.0),)
    """
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
