"""Description: what a built-in environment and strategy say of themselves to the engine.

The engine, in Rust, runs explorations that are made of built-in parts alone. Each such part has
a method `_describe` that tells a `Description` what it is, in a line or two; parts of one's own
have none. That a class is built in says nothing of those derived from it, nor of an object one
of whose methods was replaced: these are not described.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from divbandit import _core
from divbandit.box import Box

if TYPE_CHECKING:
    from collections.abc import Iterable


class NotBuiltInError(Exception):
    """Some part cannot be described: `where` says which, `kind` what it is."""

    def __init__(self, where: str, part: object) -> None:
        super().__init__(where, part)
        self.where = where
        self.kind = type(part).__name__


class Description:
    """An environment and strategies, told to the engine.

    Parameters
    ----------
    environment : object
        With its ``motor_space`` and ``sensory_space``.

    Attributes
    ----------
    engine : object
        What was told, ready to explore.
    effect_dim : int

    Raises
    ------
    NotBuiltInError
        If the environment is not built in, or was given other kinds of spaces.

    Examples
    --------
    >>> import numpy as np
    >>> import divbandit as db
    >>> description = Description(db.PlanarArm(3))
    >>> place = description.add("strategy", db.MotorBabbling())
    >>> arrays = description.engine.explore(place, 10, np.random.default_rng(0), True, None)
    >>> arrays[0].shape
    (10, 3)
    """

    def __init__(self, environment: Any) -> None:  # noqa: ANN401 - any black box
        describe = _own_description("environment", environment)
        spaces = {
            f"environment.{name}": getattr(environment, name)
            for name in ("motor_space", "sensory_space")
        }
        self.engine = _core.Engine(*(bounds_of(where, box) for where, box in spaces.items()))
        self._places: dict[int, int] = {}
        dims = describe(self)
        for (where, box), dim in zip(spaces.items(), dims, strict=True):
            if box.dim != dim:  # one that its owner has put in place of the right one
                raise NotBuiltInError(where, box)
        self.effect_dim: int = dims[1]

    def add(self, where: str, strategy: object) -> int:
        """Return the number of a strategy, which is told if it was not before.

        Raises
        ------
        NotBuiltInError
            If it, or a part of it, is not built in.

        Examples
        --------
        >>> import divbandit as db
        >>> description = Description(db.PlanarArm(3))
        >>> babbling = db.MotorBabbling()
        >>> description.add("a", babbling), description.add("b", babbling)
        (0, 0)
        """
        if id(strategy) not in self._places:
            describe = _own_description(where, strategy)
            try:
                self._places[id(strategy)] = describe(self)
            except NotBuiltInError as inner:
                inner.where = f"{where}.{inner.where}"
                raise
        return self._places[id(strategy)]

    def add_all(self, strategies: Iterable[object]) -> list[int]:
        """Return the numbers of a composite's strategies.

        Examples
        --------
        >>> import divbandit as db
        >>> Description(db.PlanarArm(3)).add_all([db.MotorBabbling(), db.GoalBabbling()])
        [0, 1]
        """
        return [self.add(f"strategies[{i}]", strategy) for i, strategy in enumerate(strategies)]


def bounds_of(where: str, box: object) -> _core.Bounds:
    """Return the bounds of a plain Box.

    Examples
    --------
    >>> import divbandit as db
    >>> bounds_of("goals", db.Box([0], [1])).high
    array([1.])
    """
    if type(box) is not Box:
        raise NotBuiltInError(where, box)
    return box.bounds


def _own_description(where: str, part: Any) -> Any:  # noqa: ANN401 - any part
    """Return a part's `_describe`, unless it was inherited or some method replaced."""
    kind = type(part)
    if "_describe" not in vars(kind) or any(hasattr(kind, name) for name in vars(part)):
        raise NotBuiltInError(where, part)
    return part._describe  # noqa: SLF001 - made for this
