"""Files of arrays: NumPy's npz with its format's name and version in it, and nothing pickled.

And tables of text, as CSV.
"""

from __future__ import annotations

import csv
import json
import os
import secrets
import zipfile
from contextlib import contextmanager
from pathlib import Path
from typing import TYPE_CHECKING, Any, BinaryIO, TypeVar, cast

import numpy as np

if TYPE_CHECKING:
    from collections.abc import Callable, Iterable, Iterator, Sequence

    from numpy.typing import NDArray

    PathLike = str | os.PathLike[str]
    Arrays = dict[str, NDArray[Any]]

Built = TypeVar("Built")


def write(path: PathLike, kind: str, version: int, arrays: Arrays) -> None:
    """Write arrays to a file, replacing it whole or not at all."""
    # The names come first, so that nothing can go missing unnoticed.
    arrays = {"format": np.array([kind, str(version), *arrays]), **arrays}
    with replacing(path) as file:
        np.savez_compressed(file, **cast("Any", arrays))


@contextmanager
def replacing(path: PathLike) -> Iterator[BinaryIO]:
    """Open a file that replaces another when it is complete."""
    target = Path(path).resolve()  # what a link points to, not the link
    temporary = target.with_name(f".{secrets.token_hex(8)}.tmp")
    try:
        with temporary.open("xb") as file:
            yield file
        temporary.replace(target)
    except OSError as error:
        error.filename = os.fspath(path)
        raise
    finally:
        temporary.unlink(missing_ok=True)


def read(
    path: PathLike,
    kind: str,
    version: int,
    build: Callable[[Arrays], Built],
    *,
    writer: str,
    earlier: dict[int, str | None] | None = None,
) -> Built:
    """Return what `build` makes of the arrays of a file that `write` wrote.

    Of `earlier` versions `build` reads those with None, too; the text of another says what to do
    with its files. Whatever else the file is, and whatever `build` finds wrong, becomes a
    ValueError that names the file and what should have written it.
    """
    with Path(path).open("rb") as file:
        try:
            if not zipfile.is_zipfile(file):
                raise ValueError("it is another file, or a part of one")  # noqa: TRY301
            file.seek(0)
            with np.load(file, allow_pickle=False) as saved:
                arrays = dict(saved.items())
            _check_format(arrays, kind, version, earlier or {})
            return build(arrays)
        except Exception as error:  # a damaged file can break its readers in any way
            raise ValueError(
                f"path must be a file written by {writer}, got {os.fspath(path)!r}: {error}"
            ) from error


def _check_format(arrays: Arrays, kind: str, version: int, earlier: dict[int, str | None]) -> None:
    if "format" not in arrays:
        raise ValueError("it does not say its format")
    name, got, *names = (str(word) for word in arrays["format"])
    advice = earlier.get(int(got), "") if name == kind and int(got) != version else None
    if name != kind or advice is not None:
        advice = f"; {advice}" if advice else ""
        raise ValueError(f"format must be {kind!r} {version}, got {name!r} {got}{advice}")
    if {"format", *names} != set(arrays):
        raise ValueError(f"arrays must be {names}, got {sorted(arrays)}")


def from_json(value: object) -> NDArray[np.uint8]:
    """Return what can be written as JSON as an array of bytes."""
    return np.frombuffer(json.dumps(value, allow_nan=False).encode(), dtype=np.uint8)


def to_json(arrays: Arrays, name: str) -> Any:  # noqa: ANN401 - whatever was written
    """Return what `from_json` was given."""
    return json.loads(array(arrays, name, np.uint8, (None,)).tobytes())


def array(
    arrays: Arrays, name: str, dtype: type[np.generic], shape: tuple[int | None, ...]
) -> NDArray[Any]:
    """Return an array of a file if it has the type and shape (None: any) that it must have."""
    array = arrays[name]
    fits = array.ndim == len(shape) and all(
        want in (None, got) for want, got in zip(shape, array.shape, strict=True)
    )
    if array.dtype != dtype or not fits:
        raise ValueError(
            f"{name} must be {dtype.__name__} of shape {shape}, got {array.dtype} {array.shape}"
        )
    return array


def write_csv(path: Path, columns: Sequence[str], rows: Iterable[Sequence[object]]) -> None:
    """Write a table with its head as CSV."""
    with path.open("w", newline="", encoding="utf-8") as file:
        writer = csv.writer(file, lineterminator="\n")
        writer.writerow(columns)
        writer.writerows(rows)
