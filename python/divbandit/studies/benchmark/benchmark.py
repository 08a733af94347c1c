"""benchmark: the library's own composition and its peers on the field's problems, as files."""

from __future__ import annotations

from typing import TYPE_CHECKING

from divbandit._checks import one_of, whole
from divbandit.measures import CellCoverage, Coverage
from divbandit.paper import setting
from divbandit.paper.reproduce import folder_for, no_bar
from divbandit.plot import style
from divbandit.studies.benchmark.contenders import CONTENDERS, DEFAULT, explored
from divbandit.studies.benchmark.drawing import figure_of
from divbandit.studies.benchmark.peers import CELLS
from divbandit.studies.benchmark.problems import NAMES, PROBLEMS
from divbandit.studies.benchmark.table import Row, Run, Table, read, summary
from divbandit.studies.processes import over_processes

if TYPE_CHECKING:
    import os
    from collections.abc import Iterable, Sequence

    from divbandit.paper.reproduce import Bar
    from divbandit.studies.benchmark.problems import Problem

#: After which shares of the budget it is measured.
_MARKS = (0.02, 0.05, 0.1, 0.2, 0.5, 1.0)


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
        again, not even where the library has changed since.
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
        Run(problem.name, contender, budget or problem.budget, seed, repetition)
        for problem in problems
        for contender in CONTENDERS
        for repetition in range(repetitions)
    ]
    path = folder / "benchmark.csv"
    known = read(path)
    there = {row.run for row in known}
    missing = [run for run in runs if run not in there]
    with (bar or no_bar)("benchmark", len(missing)) as progress, Table(path, known) as table:
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


def _made(run: Run) -> list[Row]:
    """Make an exploration, and measure it."""
    problem = PROBLEMS[NAMES.index(run.problem)]
    place = NAMES.index(run.problem), CONTENDERS.index(run.contender), run.repetition
    marks = [max(1, round(share * run.budget)) for share in _MARKS]
    rng = setting.seed_of(run.seed, 9, *place)
    environment = problem.make()
    space = environment.sensory_space
    assert space is not None  # noqa: S101 - all problems have one
    effects, seconds = explored(run.contender, problem, environment, marks, rng)
    covered, cells = Coverage(problem.tau), CellCoverage(CELLS, space).start(2)
    rows = []
    for mark, second in zip(marks, seconds, strict=True):
        new = effects[len(covered) : mark]
        covered.extend(new)
        cells.extend(new)
        rows.append(Row(*run, mark, second, covered.measure, cells.measure))
    return rows


def _text(problem: Problem, rows: dict[str, list[Row]]) -> str:
    """Return what was reached in the end as text: means and deviations."""
    unit = f" ({problem.unit}²)" if problem.unit else ""
    budget = rows[DEFAULT][-1].budget
    head = f"{problem.name}, {budget} evaluations"
    lines = [f"{head:30}{'coverage' + unit:13}{'cells (%)':>15}{'seconds':>15}"]
    for name, mine in rows.items():
        (t, area, cells), (_, area_s, cells_s) = (each[-1] for each in summary(mine)[1:])
        share = f"{cells:7.2f} ± {cells_s:<6.2f}"
        lines.append(f"  {name:22}{area:10.4g} ± {area_s:<8.2g}{share}{t:9.3g}")
    return "\n".join(lines)
