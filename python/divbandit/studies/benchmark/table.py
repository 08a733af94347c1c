"""The table of all numbers: a CSV that grows with each exploration, and is read to go on."""

from __future__ import annotations

import csv
from typing import TYPE_CHECKING, NamedTuple

import numpy as np

from divbandit._files import write_csv

if TYPE_CHECKING:
    from collections.abc import Sequence
    from pathlib import Path

    from numpy.typing import NDArray
    from typing_extensions import Self


class Run(NamedTuple):
    """An exploration."""

    problem: str
    contender: str
    budget: int
    seed: int
    repetition: int


class Row(NamedTuple):
    """What one exploration has reached at one time; the columns of the table of all numbers."""

    problem: str
    contender: str
    budget: int
    seed: int
    repetition: int
    evaluations: int
    seconds: float
    coverage: float
    cells: float

    @property
    def run(self) -> Run:
        """The exploration that it is of."""
        return Run(*self[:5])


class Table:
    """The CSV of all numbers, which grows with each exploration."""

    def __init__(self, path: Path, rows: list[Row]) -> None:
        self._path, self.rows = path, rows

    def __enter__(self) -> Self:
        write_csv(self._path, Row._fields, self.rows)
        self._file = self._path.open("a", newline="", encoding="utf-8")
        return self

    def add(self, rows: list[Row]) -> None:
        """Append what one exploration has reached."""
        self.rows += rows
        csv.writer(self._file, lineterminator="\n").writerows(rows)
        self._file.flush()

    def __exit__(self, *_: object) -> None:
        self._file.close()


def read(path: Path) -> list[Row]:
    """Return what is in a table already: explorations of which all rows are there."""
    if not path.exists():
        return []
    with path.open(newline="", encoding="utf-8") as file:
        head, *lines = csv.reader(file)
    if tuple(head) != Row._fields:
        raise ValueError(f"out must hold a table of this benchmark, or none, got {str(path)!r}")
    rows = [_row(line) for line in lines if len(line) == len(Row._fields)]
    ended = {row.run for row in rows if row.evaluations == row.budget}
    return [row for row in rows if row.run in ended]


def _row(line: list[str]) -> Row:
    """Return a line of the table as numbers."""
    problem, contender, *numbers = line
    budget, seed, repetition, evaluations = map(int, numbers[:4])
    seconds, coverage, cells = map(float, numbers[4:])
    return Row(problem, contender, budget, seed, repetition, evaluations, seconds, coverage, cells)


def summary(
    rows: Sequence[Row],
) -> tuple[list[int], NDArray[np.float64], NDArray[np.float64]]:
    """Return marks, and means and deviations there: of seconds, coverage and percent of cells."""
    marks = sorted({row.evaluations for row in rows})
    each = [np.array([row[-3:] for row in rows if row.evaluations == mark]) for mark in marks]
    scale = np.array([1, 1, 100])
    means = np.array([values.mean(axis=0) for values in each]) * scale
    return marks, means, np.array([values.std(axis=0) for values in each]) * scale
