"""Value: an immutable part, which its fields define: the arguments of its constructor."""

from __future__ import annotations

from dataclasses import fields
from inspect import Parameter, signature
from typing import Any

from divbandit._library import named


class Value:
    """A part of the library: an immutable description, made of the arguments of its constructor.

    A class derives from this and is a dataclass, ``@dataclass(frozen=True, init=False,
    repr=False)``, so that two with equal fields are equal, and hash alike where the fields can be
    hashed. Its constructor checks its arguments and hands them to `_set`. What runs is another
    object, the one that `start` returns.

    Examples
    --------
    >>> from dataclasses import replace
    >>> import divbandit as db
    >>> babbling = db.GoalBabbling(0.25)
    >>> babbling, replace(babbling, d=0.5), babbling == db.GoalBabbling(0.25)
    (GoalBabbling(0.25), GoalBabbling(0.5), True)
    >>> babbling.d = 0.5
    Traceback (most recent call last):
        ...
    dataclasses.FrozenInstanceError: cannot assign to field 'd'
    """

    __slots__ = ()

    def _set(self, **attributes: object) -> None:
        """Set fields, and what is derived from them; for constructors alone."""
        for name, value in attributes.items():
            object.__setattr__(self, name, value)

    def __repr__(self) -> str:
        given = arguments_of(self)
        words: list[str] = []
        by_name = False  # from the first argument left out
        for name, parameter in signature(type(self)).parameters.items():
            by_name = by_name or name not in given or parameter.kind is Parameter.KEYWORD_ONLY
            if name in given:
                word = _written(given[name])
                words.append(f"{name}={word}" if by_name else word)
        return f"{type(self).__name__}({', '.join(words)})"

    def __reduce__(self) -> tuple[Any, ...]:
        return _made, (type(self), {each: getattr(self, each) for each in field_names(self)})


def field_names(value: Value) -> list[str]:
    """Return the names of a value's fields, in the order of its constructor's arguments."""
    return [each.name for each in fields(value)]  # type: ignore[arg-type] # a dataclass


def arguments_of(value: Value) -> dict[str, Any]:
    """Return the fields of a value that are not their constructor's defaults.

    Examples
    --------
    >>> import divbandit as db
    >>> arguments_of(db.Adapt([db.MotorBabbling()], window=20))
    {'strategies': (MotorBabbling(),), 'tau': 0.02, 'window': 20}
    """
    found = {}
    for name, parameter in signature(type(value)).parameters.items():
        argument, default = getattr(value, name), parameter.default
        if type(argument) is not type(default) or argument != default:
            found[name] = argument
    return found


def _written(argument: object) -> str:
    """Return an argument as it is written in a call."""
    if type(argument) in {tuple, list}:
        return f"[{', '.join(map(_written, argument))}]"  # type: ignore[call-overload]
    return (
        named(argument)
        if callable(argument) and not isinstance(argument, Value)
        else repr(argument)
    )


def _made(kind: type[Value], arguments: dict[str, Any]) -> Value:
    return kind(**arguments)
