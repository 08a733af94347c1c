"""benchmark: the library's own composition and its peers on the field's problems, as files."""

from __future__ import annotations

import csv
from typing import TYPE_CHECKING, NamedTuple

import numpy as np

from divbandit._checks import one_of, whole
from divbandit._files import write_csv
from divbandit.measures import CellCoverage, Coverage
from divbandit.paper import setting
from divbandit.paper.reproduce import folder_for, no_bar
from divbandit.plot import style
from divbandit.studies.benchmark.contenders import CONTENDERS, DEFAULT, explored
from divbandit.studies.benchmark.drawing import figure_of
from divbandit.studies.benchmark.peers import CELLS
from divbandit.studies.benchmark.problems import NAMES, PROBLEMS
from divbandit.studies.processes import over_processes

if TYPE_CHECKING:
    import os
    from collections.abc import Iterable, Sequence
    from pathlib import Path

    from typing_extensions import Self

    from divbandit.paper.reproduce import Bar
    from divbandit.studies.benchmark.problems import Problem

#: After which shares of the budget it is measured.
_MARKS = (0.02, 0.05, 0.1, 0.2, 0.5, 1.0)


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
    def run(self) -> tuple[str, str, int, int, int]:
        """The exploration that it is of."""
        return self[:5]


class _Run(NamedTuple):
    """An exploration to be made."""

    problem: str
    contender: str
    budget: int
    seed: int
    repetition: int


def benchmark(
    names: Sequence[str] = (),
    *,
    out: str | os.PathLike[str] = "benchmark",
    budget: int | None = None,
    repetitions: int = 5,
    seed: int = 0,
    jobs: int | None = None,
    bar: Bar | None = None,
) -> str:
    """Compare `default_strategy` with its peers: figures, a CSV of all numbers and a table.

    The contenders are random search, the paper's ADAPT, and pyribs' MAP-Elites with Gaussian and
    line variation, CMA-ME, CMA-MAE, novelty search, density descent and UCB1 over emitters; all
    make equally many evaluations. Two measures are taken: the exact area within tau of an effect,
    and the share of cells of the sensory space in which effects lie. Needs
    ``pip install 'divbandit[cli,ribs,mujoco]'``.

    Parameters
    ----------
    names : sequence of str
        Which problems; by default all.
    out : str or path
        The folder; made if it is not there. Explorations that are in its CSV already are not made
        again.
    budget : int, optional
        Evaluations of an exploration; by default each problem has its own.
    repetitions : int
        Explorations behind each mean; at least 1.
    seed : int
        All randomness comes from it.
    jobs : int, optional
        How many processes; by default one for each core. Only the times depend on it.
    bar : callable, optional
        Opens a progress bar, given a name and a number of steps.

    Returns
    -------
    str
        A table of the means.

    Raises
    ------
    TypeError, ValueError
        If an argument is not what it must be; nothing is written then.

    Examples
    --------
    >>> import tempfile
    >>> from divbandit.studies.benchmark import benchmark
    >>> with tempfile.TemporaryDirectory() as folder:
    ...     text = benchmark(["arm 20"], out=folder, budget=50, repetitions=1, jobs=1)
    >>> text.splitlines()[0]
    'arm 20, 50 evaluations        coverage (m²)      cells (%)        seconds'
    """
    for index, name in enumerate(names):
        one_of(f"names[{index}]", name, NAMES)
    if budget is not None:
        whole("budget", budget, low=50)
    folder = folder_for(out, repetitions=repetitions, seed=seed, jobs=jobs)
    problems = [problem for problem in PROBLEMS if not names or problem.name in names]
    runs = [
        _Run(problem.name, contender, budget or problem.budget, seed, repetition)
        for problem in problems
        for contender in CONTENDERS
        for repetition in range(repetitions)
    ]
    path = folder / "benchmark.csv"
    known = _read(path)
    there = {row.run for row in known}
    missing = [run for run in runs if run not in there]
    with (bar or no_bar)("benchmark", len(missing)) as progress, _Table(path, known) as table:
        over_processes(_made, missing, jobs=jobs, progress=progress, found=table.add)
    wanted = set(runs)
    rows = [row for row in table.rows if row.run in wanted]
    with style.printed():
        for problem in problems:
            stem = f"benchmark_{problem.name.lower().replace(' ', '_')}"
            style.save(figure_of(problem, _of(problem, rows)), folder / stem)
    return "\n\n".join(_text(problem, _of(problem, rows)) for problem in problems)


def _of(problem: Problem, rows: Iterable[Row]) -> dict[str, list[Row]]:
    """Return the rows of a problem by contender."""
    mine = [row for row in rows if row.problem == problem.name]
    return {name: [row for row in mine if row.contender == name] for name in CONTENDERS}


def _made(run: _Run) -> list[Row]:
    """Make an exploration, and measure it."""
    problem = PROBLEMS[NAMES.index(run.problem)]
    place = NAMES.index(run.problem), CONTENDERS.index(run.contender), run.repetition
    marks = [max(1, round(share * run.budget)) for share in _MARKS]
    rng = setting.seed_of(run.seed, 9, *place)
    effects, seconds = explored(run.contender, problem, marks, rng)
    space = problem.make().sensory_space
    assert space is not None  # noqa: S101 - all problems have one
    covered, cells = Coverage(problem.tau), CellCoverage(CELLS, space).start(2)
    rows = []
    for mark, second in zip(marks, seconds, strict=True):
        new = effects[len(covered) : mark]
        covered.extend(new)
        cells.extend(new)
        rows.append(Row(*run, mark, second, covered.measure, cells.measure))
    return rows


class _Table:
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


def _read(path: Path) -> list[Row]:
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


def _text(problem: Problem, rows: dict[str, list[Row]]) -> str:
    """Return what was reached in the end as text: means and deviations."""
    unit = f" ({problem.unit}²)" if problem.unit else ""
    budget = rows[DEFAULT][-1].budget
    head = f"{problem.name}, {budget} evaluations"
    lines = [f"{head:30}{'coverage' + unit:13}{'cells (%)':>15}{'seconds':>15}"]
    for name, mine in rows.items():
        last = np.array([row[-3:] for row in mine if row.evaluations == row.budget])
        (t, area, cells), (_, area_s, cells_s) = last.mean(axis=0), last.std(axis=0)
        share = f"{100 * cells:7.2f} ± {100 * cells_s:<6.2f}"
        lines.append(f"  {name:22}{area:10.4g} ± {area_s:<8.2g}{share}{t:9.3g}")
    return "\n".join(lines)
