"""explore_many: many explorations at once, over the threads of one process."""

from __future__ import annotations

import sys
from collections.abc import Iterable
from threading import Event
from typing import TYPE_CHECKING, TypeVar, overload

from divbandit._checks import whole
from divbandit.experiments import seeds
from divbandit.experiments.task import Task
from divbandit.experiments.workers import Workers, available_cores
from divbandit.exploration.explore import explore_between

if TYPE_CHECKING:
    from collections.abc import Callable, Generator

    from numpy.random import SeedSequence

    from divbandit._checks import Rng
    from divbandit.exploration import Exploration

    #: Called whenever one more exploration is finished.
    Progress = Callable[[], object]

Kept = TypeVar("Kept")


class _Stopped(Exception):  # noqa: N818 - nothing went wrong
    """An exploration was stopped before its end."""


@overload
def explore_many(
    tasks: Iterable[Task],
    *,
    keep: None = None,
    rng: Rng = None,
    jobs: int | None = None,
    progress: Progress | None = None,
) -> Generator[tuple[int, Exploration], None, None]: ...


@overload
def explore_many(
    tasks: Iterable[Task],
    *,
    keep: Callable[[Exploration], Kept],
    rng: Rng = None,
    jobs: int | None = None,
    progress: Progress | None = None,
) -> Generator[tuple[int, Kept], None, None]: ...


def explore_many(
    tasks: Iterable[Task],
    *,
    keep: Callable[[Exploration], object] | None = None,
    rng: Rng = None,
    jobs: int | None = None,
    progress: Progress | None = None,
) -> Generator[tuple[int, object], None, None]:
    """Explore many tasks, several at a time, and yield what came of each as soon as it is there.

    Each exploration is the very one that `explore` makes of its task: neither `jobs` nor the order
    in which they end changes a bit of it. At most ``2 * jobs`` of them are under way, or finished
    and waiting to be yielded; tasks are drawn when there is room, so that there may be millions.
    So many are drawn, or all if there are fewer, before the first result is yielded.

    Parameters
    ----------
    tasks : iterable of Task
        Iterated over in the thread that iterates over the results, never by two at once.
    keep : callable, optional
        Called with each Exploration; what it returns is kept in its place, so that a million
        explorations do not need the memory of a million histories. Called in several threads at
        once. By default the whole Exploration is kept.
    rng : None, int, SeedSequence or Generator
        Seeds the tasks that have no ``rng`` of their own, each by its place: the task at place i
        has the seed ``SeedSequence(rng).spawn(i + 1)[i]``, that of the i-th child of a fresh
        sequence. A SeedSequence is not changed, so spawn one for this if you spawn from it
        yourself. From a Generator one number is drawn, here, as the seed.
    jobs : int, optional
        How many threads; by default as many as this process may use cores.
    progress : callable, optional
        Called without arguments, in the thread that iterates over the results, whenever one more
        exploration is finished.

    Yields
    ------
    place : int
        The place of the task among all, from 0.
    kept : Exploration, or what `keep` returned
        In no certain order: ``dict(explore_many(...))`` has them by place.

    Raises
    ------
    TypeError, ValueError
        If an argument is not what it must be. What is wrong with a task is raised when its turn
        comes.
    Exception
        What a task, `keep`, `progress` or the iterable `tasks` raises. The other explorations are
        stopped. From Python 3.11 on a note tells the place of the task.

    Notes
    -----
    Explorations of built-in parts alone are made by the engine, which lets go of Python's lock:
    they run side by side. Code in Python takes turns, but for what lets go of the lock itself, as
    an environment that waits for a simulator or a robot does. A free-threaded Python has no such
    lock: there all run side by side. (An iterator that is dropped in another thread than the one
    that made it may then end only when that one runs Python again; closing it does so at once.)

    Nothing begins before the first result is asked for. All that is under way ends between two
    steps when the iterator is closed or dropped, one of them fails or Ctrl-C comes while waiting
    for a result; a call of an environment or of `keep` that has begun is waited for.

    In a process that is forked meanwhile, the iterator ends in a RuntimeError: a fork has none of
    the threads.

    Explorations that share a Generator draw from it in whatever order they come to it: give each
    a seed instead.

    Examples
    --------
    >>> import divbandit as db
    >>> task = db.Task(db.PlanarArm(20), db.MotorBabbling(), n=500)
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
    return _explorations(tasks, keep, seeds.root(rng), jobs, progress)


def _explorations(
    tasks: Iterable[Task],
    keep: Callable[[Exploration], object] | None,
    parent: SeedSequence,
    jobs: int,
    progress: Progress | None,
) -> Generator[tuple[int, object], None, None]:
    stop = Event()

    def explored(item: tuple[int, Task]) -> tuple[int, object]:
        place, task = item
        try:
            return place, _explored(task, keep, seeds.child(parent, place), stop)
        except BaseException as error:
            if sys.version_info >= (3, 11):
                error.add_note(f"raised by the task at place {place} of explore_many")
            raise

    def finished() -> tuple[int, object]:
        result = workers.get()
        if progress is not None:
            progress()
        return result

    with Workers(explored, jobs, stop) as workers:
        for place, task in enumerate(tasks):
            if not isinstance(task, Task):
                raise TypeError(f"tasks must be Tasks, got {type(task).__name__} at place {place}")
            workers.put((place, task))
            if len(workers) == 2 * jobs:
                yield finished()
        while len(workers) > 0:
            yield finished()


def _explored(
    task: Task,
    keep: Callable[[Exploration], object] | None,
    seed: SeedSequence,
    stop: Event,
) -> object:
    def unless_stopped() -> None:
        if stop.is_set():
            raise _Stopped

    run = explore_between(
        task.environment,
        task.strategy,
        task.n,
        seed if task.rng is None else task.rng,
        task.engine,
        keep_commands=task.keep_commands,
        between=unless_stopped,
    )
    return run if keep is None else keep(run)
