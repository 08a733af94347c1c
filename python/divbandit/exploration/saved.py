"""Files of explorers: what was asked and told, from which all else follows.

A file begins with a block on the strategy, the spaces and the generator. Each block after it holds
what has happened since the one before: a saved file has one of them, a checkpoint grows.
"""

from __future__ import annotations

import io
import os
import zipfile
from contextlib import suppress
from pathlib import Path
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np

from divbandit import _files
from divbandit._core import undisturbed
from divbandit._recipe import NoRecipeError, made_from, recipe_of
from divbandit.box import Box
from divbandit.exploration.blocks import packed, unpacked
from divbandit.exploration.replay import OtherwiseError, Past, replay
from divbandit.strategies.base import Strategy

if TYPE_CHECKING:
    from numpy.random import Generator
    from numpy.typing import NDArray

    from divbandit._core import Trial
    from divbandit.exploration.explorer import Explorer
    from divbandit.exploration.watching import Every

    Arrays = dict[str, NDArray[Any]]
    PathLike = str | os.PathLike[str]

_FORMAT = "divbandit explorer"
_VERSION = 3

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


def write(path: PathLike, explorer: Explorer) -> None:
    """Write what happened to an explorer, replacing a file whole or not at all."""
    _replace(path, _head(explorer, grows=False) + _block(explorer)[0])


class Checkpoint:
    """A callback that saves the explorer every so often, by what has happened since.

    Attributes
    ----------
    every : int or str
        Evaluations, or a duration.
    """

    def __init__(self, path: PathLike, every: Every) -> None:
        self._path, self.every = path, every

    def start(self, explorer: Explorer, _: int | None, /) -> Growing:
        """Write a new file, replacing what was there, or go on with that of the last run."""
        before = explorer._growing  # noqa: SLF001 - kept there for this
        if before is None or not before.is_at(self._path):
            explorer._growing = before = Growing(self._path, explorer)  # noqa: SLF001
        return before


class Growing:
    """A file to which blocks are appended."""

    def __init__(self, path: PathLike, explorer: Explorer) -> None:
        self._explorer, self._path = explorer, Path(path).resolve()
        block, mark = _block(explorer)
        first = _head(explorer, grows=True) + block
        #: What is written, and how long the file is: they change in one step.
        self._state = mark, len(first)
        _replace(path, first)

    def __call__(self, explorer: Explorer, _: Trial | None, /) -> None:
        """Write what has happened since."""
        undisturbed(self._write, explorer)

    def _write(self, explorer: Explorer) -> None:
        mark, end = self._state
        journal = explorer._journal  # noqa: SLF001 - that is what is written
        if journal.size == mark[0] and len(explorer.history) == mark[1]:
            return
        block, mark = _block(explorer, mark)
        with self._path.open("r+b") as file:
            file.truncate(end)  # what an interrupted call has left
            file.seek(end)
            file.write(block)
        self._state = mark, end + len(block)

    def is_at(self, path: PathLike) -> bool:
        """Whether this is that file, as it was left."""
        try:
            return (
                self._path == Path(path).resolve() and self._path.stat().st_size == self._state[1]
            )
        except OSError:
            return False

    def close(self) -> None:
        """Write the rest."""
        self(self._explorer, None)


def _block(
    explorer: Explorer, mark: tuple[int, int, int] = (0, 0, 0)
) -> tuple[bytes, tuple[int, int, int]]:
    """Return a block of what has happened since a mark, and the next mark.

    A mark says how many events, rows of the history and failures are in the blocks so far.
    """
    first, row, failed = mark
    journal, log = explorer._journal, explorer.history._log  # noqa: SLF001 - that is what is written
    events, failures = journal.events(first), journal.failures(failed)
    m = explorer.history.motor_space.dim
    pending = journal.open
    words = {
        "state": _plain(state_of(explorer.rng)),
        "reasons": [reason for _, _, reason, *_ in failures],
    }
    arrays: Arrays = {
        "words": _files.from_json(words),
        "events": events,
        "commands": log.commands_from(row),
        "effects": log.effects_from(row),
        "failed": np.array([number for number, *_ in failures], dtype=np.int64),
        "failed_commands": _points([command for _, command, *_ in failures], m),
        "pending": np.array([trial.number for trial in pending], dtype=np.int64),
        "pending_commands": _points([trial.command for trial in pending], m),
    }
    mark = first + len(events), row + len(arrays["effects"]), failed + len(failures)
    return packed(arrays), mark


def _points(rows: list[NDArray[np.float64]], dim: int) -> NDArray[np.float64]:
    return np.array(rows, dtype=np.float64).reshape(len(rows), dim)


def _head(explorer: Explorer, *, grows: bool) -> bytes:
    """Return the first block: how it all began."""
    rng, strategy, history = explorer.rng, explorer._given, explorer.history  # noqa: SLF001
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
    words = {
        "strategy": recipe,
        "name": repr(strategy),
        "generator": kind.__name__,
        "state": _plain(explorer._began),  # noqa: SLF001
        "grows": grows,
    }
    arrays = {
        "format": np.array([_FORMAT, str(_VERSION)]),
        "words": _files.from_json(words),
        "motor_space": np.array([history.motor_space.low, history.motor_space.high]),
    }
    if history.sensory_space is not None:
        arrays["sensory_space"] = np.array([history.sensory_space.low, history.sensory_space.high])
    return packed(arrays)


def _replace(path: PathLike, content: bytes) -> None:
    with _files.replacing(path) as file:
        file.write(content)


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


def read(path: PathLike, kind: type[Explorer], strategy: Strategy | None) -> Explorer:
    """Return the explorer that was written, in the state that it was in."""
    data = Path(path).read_bytes()
    try:
        saved = _from_blocks(data)
    except Exception as error:  # a damaged file can break its readers in any way
        raise ValueError(
            f"path must be a file written by Explorer.save, got {os.fspath(path)!r}: {error}"
        ) from error
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


def state_of(rng: Generator) -> dict[str, Any] | None:
    """Return the state of a generator; None if its bit generator, a user's, does not tell.

    Examples
    --------
    >>> sorted(state_of(np.random.default_rng(0)))
    ['bit_generator', 'has_uint32', 'state', 'uinteger']
    """
    try:
        return dict(rng.bit_generator.state)
    except NotImplementedError:
        return None


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


def _from_blocks(data: bytes) -> _Saved:
    """Read the blocks of a file, which may hold anything."""
    if data[:2] == b"PK":
        raise ValueError(_other_file(data))
    blocks = list(unpacked(data))
    if len(blocks) < 2:
        raise ValueError("it is another file, or a part of one")
    (head, _), *rest = blocks
    words = _files.to_json(head, "words")
    name, version = (str(word) for word in head["format"])
    if (name, version) != (_FORMAT, str(_VERSION)):
        raise ValueError(f"format must be {_FORMAT!r} {_VERSION}, got {name!r} {version}")
    if not words["grows"] and (len(rest) > 1 or rest[-1][1] != len(data)):
        raise ValueError("it is not whole")
    motor_space = Box(*_files.array(head, "motor_space", np.float64, (2, None)))
    sensory_space = None
    if "sensory_space" in head:
        sensory_space = Box(*_files.array(head, "sensory_space", np.float64, (2, None)))
    past, last = _past([arrays for arrays, _ in rest], motor_space.dim)
    bit_generator = _BIT_GENERATORS[words["generator"]]()
    before, after = _restored(words["state"]), _restored(last["state"])
    for state in (after, before):  # the first is only tried
        bit_generator.state = state
    strategy = None if words["strategy"] is None else made_from(words["strategy"])
    if not isinstance(strategy, (Strategy, type(None))):
        raise TypeError(f"strategy must be a Strategy, got {type(strategy).__name__}")
    rng = np.random.Generator(bit_generator)
    return _Saved(motor_space, sensory_space, strategy, str(words["name"]), rng, after, past)


def _past(blocks: list[Arrays], m: int) -> tuple[Past, dict[str, Any]]:
    """Return what the blocks say has happened, and the words of the last one."""
    words = [_files.to_json(block, "words") for block in blocks]

    def joined(name: str, dtype: type[np.generic], *shape: int | None) -> NDArray[Any]:
        parts = [_files.array(block, name, dtype, (None, *shape)) for block in blocks]
        filled = [part for part in parts if len(part)]
        return np.concatenate(filled) if filled else parts[0]

    last = blocks[-1]
    past = Past.of(
        joined("events", np.int64),
        joined("commands", np.float64, m),
        joined("effects", np.float64, None),
        (joined("failed", np.int64), joined("failed_commands", np.float64, m)),
        (
            _files.array(last, "pending", np.int64, (None,)),
            _files.array(last, "pending_commands", np.float64, (None, m)),
        ),
        [str(reason) for each in words for reason in each["reasons"]],
    )
    return past, words[-1]


def _other_file(data: bytes) -> str:
    """Say what to do with a file in NumPy's npz: of an Exploration, or of an earlier version."""
    try:
        with np.load(io.BytesIO(data), allow_pickle=False) as arrays:
            name, version = (str(word) for word in arrays["format"][:2])
    except (zipfile.BadZipFile, KeyError, ValueError, OSError):
        return "it is another file, or a part of one"
    if name == _FORMAT:
        return (
            f"format must be {_FORMAT!r} {_VERSION}, got {name!r} {version}; go on from what it "
            "observed: read its commands and effects with numpy.load, and give them to "
            "Explorer(..., past=(commands, effects))"
        )
    return (
        "it is an Exploration: go on from it with "
        "Explorer(strategy, ..., past=Exploration.load(path))"
    )
