"""Durations, as they are written: "30s", "1.5 h", or a number of seconds."""

from __future__ import annotations

import re
from numbers import Real

from divbandit._checks import positive

#: Seconds in each unit.
_UNITS = {"ms": 0.001, "s": 1.0, "min": 60.0, "h": 3600.0, "d": 86400.0}

_WRITTEN = re.compile(rf"\s*([0-9]+\.?[0-9]*|\.[0-9]+)\s*({'|'.join(_UNITS)})\s*")

#: What a duration can be, for messages.
_EXAMPLES = 'such as "250ms", "30s", "10min", "1.5 h" or "1d"'


def seconds(name: str, value: object) -> float:
    """Return a duration in seconds, positive and finite, or say what is wrong with it.

    Examples
    --------
    >>> seconds("every", "1.5 h"), seconds("every", "250ms"), seconds("every", 30)
    (5400.0, 0.25, 30.0)
    >>> seconds("every", "2 hours")
    Traceback (most recent call last):
        ...
    ValueError: every must be a duration such as "250ms", "30s", "10min", "1.5 h" or "1d", got '2 hours'
    """  # noqa: E501 - a message is one line
    if isinstance(value, str):
        written = _WRITTEN.fullmatch(value)
        if written is None:
            raise ValueError(f"{name} must be a duration {_EXAMPLES}, got {value!r}")
        number = float(written[1]) * _UNITS[written[2]]
        if not 0.0 < number < float("inf"):
            raise ValueError(f"{name} must be a positive, finite duration, got {value!r}")
        return number
    if isinstance(value, bool) or not isinstance(value, Real):
        kind = type(value).__name__
        raise TypeError(
            f"{name} must be a duration {_EXAMPLES}, or a number of seconds, got {kind}"
        )
    return positive(name, value)
