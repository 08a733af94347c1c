"""Recipes: values of the library as names of classes and fields, for JSON."""

from __future__ import annotations

import importlib
from typing import Any

from divbandit._value import Value, arguments_of
from divbandit.box import Box

#: Where the classes of recipes may come from.
_PACKAGES = ("strategies", "goals", "inverse", "bandits", "measures", "adapters", "box")


class NoRecipeError(Exception):
    """A part cannot be written down; the text says which."""


def recipe_of(part: object) -> Any:  # noqa: ANN401 - what JSON can write
    """Return the recipe of a part, with the parts that it is made of.

    Raises
    ------
    NoRecipeError
        If one of them is user-defined.

    Examples
    --------
    >>> import divbandit as db
    >>> recipe_of(db.GoalBabbling(0.25))
    {'class': 'strategies.goal_babbling.GoalBabbling', 'arguments': {'d': 0.25}, 'number': 0}
    """
    return _Writer().write(part)


def made_from(recipe: Any) -> Any:  # noqa: ANN401 - what JSON can write, and any part
    """Return the part that a recipe describes.

    Raises
    ------
    ValueError
        If it is not a recipe of the library's parts.
    Exception
        What the parts raise when they are made.

    Examples
    --------
    >>> import divbandit as db
    >>> made_from(recipe_of(db.Mixture([db.MotorBabbling(), db.GoalBabbling(0.25)])))
    Mixture([MotorBabbling(), GoalBabbling(0.25)], weights=[1.0, 1.0])
    """
    return _Reader().read(recipe)


class _Writer:
    """Writes parts; one that stands in two places is written once, as it is started once."""

    def __init__(self) -> None:
        self._numbers: dict[int, int] = {}

    def write(self, value: object) -> Any:  # noqa: ANN401
        if value is None or isinstance(value, (bool, str, int, float)):
            return value
        # A named tuple is a part of its own kind, such as a policy of MABWiser.
        if isinstance(value, (list, tuple)) and not hasattr(value, "_fields"):
            return [self.write(item) for item in value]
        if id(value) in self._numbers:
            return {"same as": self._numbers[id(value)]}
        return self._write_part(value)

    def _write_part(self, value: object) -> Any:  # noqa: ANN401
        kind = type(value)
        prefix, name = __package__ + ".", f"{kind.__module__}.{kind.__qualname__}"
        if not name.startswith(prefix) or "<" in name:
            raise NoRecipeError(f"{kind.__name__} is user-defined")
        number = self._numbers[id(value)] = len(self._numbers)
        if isinstance(value, Box):
            arguments: dict[str, Any] = {"low": value.low.tolist(), "high": value.high.tolist()}
        elif isinstance(value, Value):
            arguments = {key: self.write(each) for key, each in arguments_of(value).items()}
        else:
            raise NoRecipeError(f"{kind.__name__} is not a value")
        return {"class": name.removeprefix(prefix), "arguments": arguments, "number": number}


class _Reader:
    """Makes parts; one that stood in two places is made once."""

    def __init__(self) -> None:
        self._made: dict[int, object] = {}

    def read(self, value: Any) -> Any:  # noqa: ANN401
        if isinstance(value, list):
            return [self.read(item) for item in value]
        if not isinstance(value, dict):
            return value
        if "same as" in value:
            return self._made[value["same as"]]
        package, _, name = str(value["class"]).rpartition(".")
        if package.split(".")[0] not in _PACKAGES:
            raise ValueError(f"class must be a part of the library, got {value['class']!r}")
        kind = getattr(importlib.import_module(f"{__package__}.{package}"), name)
        is_part = isinstance(kind, type) and issubclass(kind, (Value, Box))
        if not is_part or kind.__module__ != f"{__package__}.{package}":
            raise ValueError(f"class must be a part of the library, got {value['class']!r}")
        arguments = {key: self.read(argument) for key, argument in value["arguments"].items()}
        made = kind(**arguments)
        self._made[value["number"]] = made
        return made
