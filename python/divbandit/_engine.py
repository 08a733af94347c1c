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

    def __init__(self, where: str, kind: str) -> None:
        super().__init__(where, kind)
        self.where, self.kind = where, kind


class Description:
    """An environment and strategies, told to the engine.

    Parameters
    ----------
    environment : object
    motor_space : Box
        That of the environment.
    sensory_space : Box, optional

    Attributes
    ----------
    engine : object
        What was told, ready to explore.
    effect_dim : int

    Raises
    ------
    NotBuiltInError
        If the environment is not built in, or a space is not what it began with.

    Examples
    --------
    >>> import numpy as np
    >>> import divbandit as db
    >>> arm = db.PlanarArm(3)
    >>> description = Description(arm, arm.motor_space, arm.sensory_space)
    >>> place = description.add("strategy", db.MotorBabbling())
    >>> arrays = description.engine.explore(place, 10, np.random.default_rng(0), True, None)
    >>> arrays[0].shape
    (10, 3)
    """

    def __init__(self, environment: object, motor_space: Box, sensory_space: Box | None) -> None:
        describe = _own_description("environment", environment)
        spaces = {"environment.motor_space": motor_space}
        if sensory_space is not None:
            spaces["environment.sensory_space"] = sensory_space
        bounds = [bounds_of(where, box) for where, box in spaces.items()]
        self.engine = _core.Engine(bounds[0], bounds[1] if len(bounds) > 1 else None)
        self._places: dict[int, int] = {}
        dims = describe(self)
        for (where, box), dim in zip(spaces.items(), dims, strict=False):
            if box.dim != dim:  # its owner has put it in place of the right one
                raise NotBuiltInError(where, f"Box of dimension {box.dim} in place of {dim}")
        self.effect_dim: int = dims[1]

    def add(self, where: str, strategy: object) -> int:
        """Return the number of a strategy, which is told if it was not before.

        Raises
        ------
        NotBuiltInError
            If it, or a part of it, is not built in, or has attributes that its class refuses, set
            by hand: Python says what comes of them.

        Examples
        --------
        >>> import divbandit as db
        >>> arm = db.PlanarArm(3)
        >>> description = Description(arm, arm.motor_space, arm.sensory_space)
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
            except (TypeError, ValueError, OverflowError) as error:
                kind = f"{type(strategy).__name__} changed by hand: {error}"
                raise NotBuiltInError(where, kind) from None
        return self._places[id(strategy)]

    def detail(self, where: str, part: object) -> Any:  # noqa: ANN401 - whatever describes it
        """Return what a built-in part of a strategy, that is none itself, says of itself.

        Raises
        ------
        NotBuiltInError
            If it is not built in.

        Examples
        --------
        >>> import divbandit as db
        >>> arm = db.PlanarArm(3)
        >>> description = Description(arm, arm.motor_space, arm.sensory_space)
        >>> description.detail("inverse", db.NearestNeighbor(0.2))
        0.2
        """
        describe = _own_description(where, part)
        try:
            return describe(self)
        except NotBuiltInError as inner:
            inner.where = f"{where}.{inner.where}"
            raise

    def add_all(self, strategies: Iterable[object]) -> list[int]:
        """Return the numbers of a composite's strategies.

        Examples
        --------
        >>> import divbandit as db
        >>> arm = db.PlanarArm(3)
        >>> description = Description(arm, arm.motor_space, arm.sensory_space)
        >>> description.add_all([db.MotorBabbling(), db.GoalBabbling()])
        [0, 1]
        """
        return [self.add(f"strategies[{i}]", strategy) for i, strategy in enumerate(strategies)]


def bounds_of(where: str, box: Box) -> _core.Bounds:
    """Return the bounds of a plain Box.

    Examples
    --------
    >>> import divbandit as db
    >>> bounds_of("goals", db.Box([0], [1])).high
    array([1.])
    """
    if type(box) is not Box:
        raise NotBuiltInError(where, type(box).__name__)
    return box.bounds


def _own_description(where: str, part: Any) -> Any:  # noqa: ANN401 - any part
    """Return a part's `_describe`, unless it was inherited or some method replaced."""
    kind = type(part)
    if "_describe" not in vars(kind):
        raise NotBuiltInError(where, kind.__name__)
    without_replacements(where, part)
    return part._describe  # noqa: SLF001 - made for this


def without_replacements(where: str, part: object) -> None:
    """Raise a NotBuiltInError if an object has put something in a method's place.

    Examples
    --------
    >>> import divbandit as db
    >>> without_replacements("strategy", db.MotorBabbling())
    """
    for name, value in vars(part).items():
        if hasattr(type(part), name):
            raise NotBuiltInError(f"{where}.{name}", type(value).__name__)
