"""explore_many: many explorations at once, in threads and in processes."""

from __future__ import annotations

import sys
from collections.abc import Iterable
from dataclasses import replace
from typing import TYPE_CHECKING, TypeVar, overload

from divbandit._checks import whole
from divbandit.experiments import seeds
from divbandit.experiments.cores import available_cores
from divbandit.experiments.elsewhere import Elsewhere
from divbandit.experiments.task import Task
from divbandit.experiments.threads import Check, Threads
from divbandit.exploration.options import check_executor

if TYPE_CHECKING:
    from collections.abc import Callable, Generator
    from concurrent.futures import Executor

    from numpy.random import SeedSequence

    from divbandit._checks import Rng
    from divbandit.exploration import Exploration

    #: Called whenever an exploration is finished.
    Progress = Callable[[], object]

Kept = TypeVar("Kept")


@overload
def explore_many(
    tasks: Iterable[Task],
    *,
    keep: None = None,
    rng: Rng = None,
    jobs: int | None = None,
    executor: Executor | None = None,
    progress: Progress | None = None,
) -> Generator[tuple[int, Exploration], None, None]: ...


@overload
def explore_many(
    tasks: Iterable[Task],
    *,
    keep: Callable[[Exploration], Kept],
    rng: Rng = None,
    jobs: int | None = None,
    executor: Executor | None = None,
    progress: Progress | None = None,
) -> Generator[tuple[int, Kept], None, None]: ...


def explore_many(
    tasks: Iterable[Task],
    *,
    keep: Callable[[Exploration], object] | None = None,
    rng: Rng = None,
    jobs: int | None = None,
    executor: Executor | None = None,
    progress: Progress | None = None,
) -> Generator[tuple[int, object], None, None]:
    """Explore many tasks, several at a time, and yield each result as soon as it is there.

    Each exploration is bit by bit the one that `explore` makes of its task, whatever `jobs` is and
    in whatever order they end. At most ``2 * jobs`` explorations are running, waiting to run, or
    finished and not yet yielded; new tasks are drawn only when there is room, so that there may be
    millions. The first ``2 * jobs`` tasks are drawn before the first result is yielded.

    Parameters
    ----------
    tasks : iterable of Task
        Iterated over in the thread that iterates over the results.
    keep : callable, optional
        Called with each Exploration; what it returns is yielded instead, so that a million
        explorations do not need the memory of a million histories. It is called where the task is
        explored: in several threads at once, or in a worker process. By default the Exploration
        itself is yielded.
    rng : None, int, SeedSequence or Generator
        Seeds the tasks without ``rng``, each according to its place: the task at place i gets the
        seed ``SeedSequence(rng).spawn(i + 1)[i]``, the i-th child of a new sequence. A SeedSequence
        is not changed: if you also spawn from it, pass a child of it here. From a Generator one
        number is drawn, at this call, as the seed.
    jobs : int, optional
        How many explorations run at a time; by default the number of cores that this process may
        use. Those of built-in parts run in threads. A black box in Python, or a user-defined
        strategy, is explored in a worker process, if loky is installed
        (``pip install "divbandit[jobs]"``) and the task can be pickled: each has its own copy of
        the environment.
    executor : concurrent.futures.Executor, optional
        Where to explore instead: processes, a cluster's; `jobs` says how many explorations to keep
        under way.
    progress : callable, optional
        Called without arguments, in the thread that iterates over the results, whenever an
        exploration is finished.

    Yields
    ------
    place : int
        The place of the task, from 0.
    kept : Exploration, or what `keep` returned
        In no particular order: ``dict(explore_many(...))`` has them by place.

    Raises
    ------
    TypeError, ValueError
        If an argument is not what it must be. A wrong task raises when it is drawn or explored.
    Exception
        What a task, `keep`, `progress` or the iterable `tasks` raises. The other explorations are
        stopped. From Python 3.11 on a note gives the place of the task.
    RuntimeError
        If the program is exiting, or in a process that was forked during the iteration.

    Notes
    -----
    Explorations of built-in parts are made by the engine, which releases Python's global lock: they
    run in parallel, in threads. In threads Python code takes turns, except where it releases the
    lock itself; so it runs in processes where it can. A task whose ``rng`` is a Generator, which
    must be advanced here, is explored in a thread.

    Nothing starts before the first result is requested. All explorations stop between two steps
    when the iterator is closed or dropped, when one of them fails, on Ctrl-C while waiting for a
    result, and when the program exits. In a thread, a call of an environment or of `keep` is
    completed first; worker processes are ended.

    If several explorations share a Generator, the order of their draws is arbitrary: give each a
    seed instead.

    Examples
    --------
    >>> import divbandit as db
    >>> task = db.experiments.Task(db.PlanarArm(20), db.MotorBabbling(), n=500)
    >>> final = dict(db.explore_many(task.over(range(8)), keep=lambda run: run.coverage(0.02)[-1]))
    >>> sorted(final)
    [0, 1, 2, 3, 4, 5, 6, 7]
    >>> bool(final[3] == db.explore(db.PlanarArm(20), task.strategy, 500, rng=3).coverage(0.02)[-1])
    True
    """
    if not isinstance(tasks, Iterable):
        raise TypeError(f"tasks must be an iterable of Tasks, got {type(tasks).__name__}")
    for name, value in (("keep", keep), ("progress", progress)):
        if value is not None and not callable(value):
            raise TypeError(f"{name} must be callable or None, got {type(value).__name__}")
    jobs = available_cores() if jobs is None else whole("jobs", jobs, low=1)
    if executor is not None:
        check_executor(executor)
    return _explorations(tasks, keep, seeds.root(rng), Elsewhere(jobs, executor), jobs, progress)


def _explorations(
    tasks: Iterable[Task],
    keep: Callable[[Exploration], object] | None,
    parent: SeedSequence,
    elsewhere: Elsewhere,
    jobs: int,
    progress: Progress | None,
) -> Generator[tuple[int, object], None, None]:
    def explored(place: int, task: Task) -> tuple[int, object]:
        rng = seeds.child(parent, place) if task.rng is None else task.rng
        try:
            sent = elsewhere.takes(task, keep)
            if sent is not None:
                return place, elsewhere.explored(task, rng, keep, sent, threads.check)
            run = replace(task, rng=rng).explore(callbacks=[Check(threads)])
            return place, run if keep is None else keep(run)
        except BaseException as error:
            if sys.version_info >= (3, 11):
                error.add_note(f"raised by the task at place {place} of explore_many")
            raise

    def finished() -> tuple[int, object]:
        result = threads.result()
        if progress is not None:
            progress()
        return result

    with elsewhere, Threads[tuple[int, object]](jobs) as threads:
        for place, task in _numbered(tasks):
            threads.submit(explored, place, task)
            if len(threads) == 2 * jobs:
                yield finished()
        while len(threads) > 0:
            yield finished()


def _numbered(tasks: Iterable[Task]) -> Generator[tuple[int, Task], None, None]:
    for place, task in enumerate(tasks):
        if not isinstance(task, Task):
            raise TypeError(f"tasks must be Tasks, got {type(task).__name__} at place {place}")
        yield place, task
