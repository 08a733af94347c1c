"""Files of explorers: what was asked and told, from which all else follows."""

from __future__ import annotations

from contextlib import suppress
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np

from divbandit import _files
from divbandit._recipe import NoRecipeError, made_from, recipe_of
from divbandit.box import Box
from divbandit.exploration.journal import Event, events_of
from divbandit.exploration.replay import OtherwiseError, Past, replay
from divbandit.strategies.base import Strategy

if TYPE_CHECKING:
    import os
    from collections.abc import Mapping

    from numpy.random import Generator
    from numpy.typing import NDArray

    from divbandit.exploration.explorer import Explorer
    from divbandit.exploration.journal import Journal
    from divbandit.history import History

_FORMAT = "divbandit explorer"
_VERSION = 2

#: What to do with files of the first version, whose strategies had other parts.
_FIRST_VERSION = (
    "go on from what it observed: read its commands and effects with numpy.load, and give them to "
    "explorer.add_past"
)

#: The bit generators whose state a file can hold.
_BIT_GENERATORS = {
    kind.__name__: kind
    for kind in (
        np.random.PCG64,
        np.random.PCG64DXSM,
        np.random.MT19937,
        np.random.Philox,
        np.random.SFC64,
    )
}


class _Saved(NamedTuple):
    """What is in a file."""

    motor_space: Box
    sensory_space: Box | None
    #: None if it has user-defined parts.
    strategy: Strategy | None
    #: Its repr.
    name: str
    generator: Generator
    #: Its state when the file was written.
    state: dict[str, Any]
    past: Past


def write(
    path: str | os.PathLike[str],
    strategy: Strategy,
    history: History,
    journal: Journal,
    under_way: Mapping[int, NDArray[np.float64]],
    rng: Generator,
) -> None:
    """Write what happened to an explorer; `under_way` are the commands of its open trials."""
    kind = type(rng.bit_generator)
    if type(rng) is not np.random.Generator or kind not in _BIT_GENERATORS.values():
        raise ValueError(
            f"rng must be a Generator of one of NumPy's own bit generators to be saved, got {rng!r}"
        )
    if not history._log.keeps_commands:  # noqa: SLF001 - it is what is written
        raise ValueError(
            "commands must have been kept to be saved: explore(..., keep_commands=True) does"
        )
    recipe = None
    with suppress(NoRecipeError):
        recipe = recipe_of(strategy)
    events = np.array(journal.events, dtype=np.int64)
    told, added, numbers = _rows(events)
    commands = np.empty(
        (len(told) + len(history.failures) + len(under_way), history.motor_space.dim)
    )
    commands[numbers] = history.commands[told]
    for number, failure in zip(journal.failed, history.failures, strict=True):
        commands[number] = failure.command
    for number, command in under_way.items():
        commands[number] = command
    words = {
        "strategy": recipe,
        "name": repr(strategy),
        "generator": kind.__name__,
        "state": {"before": _plain(journal.generator_state), "after": _plain(rng_state(rng))},
        "reasons": [failure.reason for failure in history.failures],
    }
    space, goals = history.motor_space, history.sensory_space
    arrays: dict[str, NDArray[Any]] = {
        "motor_space": np.array([space.low, space.high]),
        "words": _files.from_json(words),
        "events": events,
        "commands": commands,
        "effects": history.effects,
        "added": history.commands[added],
    }
    if goals is not None:
        arrays["sensory_space"] = np.array([goals.low, goals.high])
    # Random commands can hardly be compressed, and a robot is saved after each trial.
    _files.write(path, _FORMAT, _VERSION, arrays, compress=False)


def read(path: str | os.PathLike[str], kind: type[Explorer], strategy: Strategy | None) -> Explorer:
    """Return the explorer that was written, in the state that it was in."""
    saved = _files.read(
        path, _FORMAT, _VERSION, _from_arrays, writer="Explorer.save", earlier={1: _FIRST_VERSION}
    )
    if strategy is None:
        if saved.strategy is None:
            raise ValueError(
                f"strategy must be given: the explorer's, {saved.name}, has user-defined parts, "
                "and so is not in the file"
            )
        strategy = saved.strategy
    explorer = kind(strategy, saved.motor_space, saved.sensory_space, rng=saved.generator)
    try:
        replay(explorer, saved.past)
    except OtherwiseError as error:
        raise ValueError(
            f"strategy must be one that repeats what the saved one, {saved.name}, did, but "
            f"{error}: it is another, depends on more than its observations and the generator, or "
            "the generator was also drawn from elsewhere"
        ) from error.__cause__
    explorer.rng.bit_generator.state = saved.state
    return explorer


def rng_state(rng: Generator) -> dict[str, Any]:
    """Return the state of a generator.

    Examples
    --------
    >>> sorted(rng_state(np.random.default_rng(0)))
    ['bit_generator', 'has_uint32', 'state', 'uinteger']
    """
    return dict(rng.bit_generator.state)


def _rows(
    events: NDArray[np.int64],
) -> tuple[NDArray[np.int64], NDArray[np.int64], NDArray[np.int64]]:
    """Return which rows of the history were told, which were added, and what trials were told."""
    told: list[int] = []
    added: list[int] = []
    numbers: list[int] = []
    asked = known = 0
    for event, number, how in events_of(events.tolist()):
        if event == Event.ASK and not how:
            asked += 1
        elif event == Event.RUN:
            told += range(known, known + number)
            numbers += range(asked, asked + number)
            asked, known = asked + number, known + number
        elif event == Event.TELL:
            told.append(known)
            numbers.append(number)
            known += 1
        elif event == Event.PAST:
            added += range(known, known + number)
            known += number
    return tuple(np.array(rows, dtype=np.int64) for rows in (told, added, numbers))  # type: ignore[return-value]


def _plain(value: Any) -> Any:  # noqa: ANN401 - a state may hold anything that JSON can, and arrays
    if isinstance(value, dict):
        return {key: _plain(item) for key, item in value.items()}
    if isinstance(value, np.ndarray):
        return {"dtype": value.dtype.name, "values": value.tolist()}
    return int(value) if isinstance(value, np.integer) else value


def _restored(value: Any) -> Any:  # noqa: ANN401
    if isinstance(value, dict) and set(value) == {"dtype", "values"}:
        return np.array(value["values"], dtype=value["dtype"])
    if isinstance(value, dict):
        return {key: _restored(item) for key, item in value.items()}
    return value


def _from_arrays(arrays: dict[str, NDArray[Any]]) -> _Saved:
    """Read the arrays of a file, which may hold anything."""
    words = _files.to_json(arrays, "words")
    motor_space = Box(*_files.array(arrays, "motor_space", np.float64, (2, None)))
    sensory_space = None
    if "sensory_space" in arrays:
        sensory_space = Box(*_files.array(arrays, "sensory_space", np.float64, (2, None)))
    m = motor_space.dim
    events = _files.array(arrays, "events", np.int64, (None,))
    bit_generator = _BIT_GENERATORS[words["generator"]]()
    after, before = (_restored(words["state"][when]) for when in ("after", "before"))
    for state in (after, before):  # the first is only tried
        bit_generator.state = state
    past = Past(
        list(events_of(events.tolist())),
        _files.array(arrays, "commands", np.float64, (None, m)),
        _files.array(arrays, "effects", np.float64, (None, None)),
        _files.array(arrays, "added", np.float64, (None, m)),
        [str(reason) for reason in words["reasons"]],
    )
    past.check()
    strategy = None if words["strategy"] is None else made_from(words["strategy"])
    if not isinstance(strategy, (Strategy, type(None))):
        raise TypeError(f"strategy must be a Strategy, got {type(strategy).__name__}")
    rng = np.random.Generator(bit_generator)
    return _Saved(motor_space, sensory_space, strategy, str(words["name"]), rng, after, past)
