"""run_all: one function over many tasks, on several cores, results in order."""

from __future__ import annotations

import multiprocessing
import os
from concurrent.futures import ProcessPoolExecutor
from typing import TYPE_CHECKING, TypeVar

from divbandit._checks import whole

if TYPE_CHECKING:
    from collections.abc import Callable, Iterable, Sequence

    Progress = Callable[[], object]

Task = TypeVar("Task")
Result = TypeVar("Result")


def run_all(
    function: Callable[[Task], Result],
    tasks: Sequence[Task],
    *,
    jobs: int | None = None,
    progress: Progress | None = None,
) -> list[Result]:
    """Return ``[function(task) for task in tasks]``, computed by `jobs` processes.

    A task carries its own seed, so that the results do not depend on `jobs`. As always with
    processes, a script that calls this does so under ``if __name__ == "__main__":``.

    Parameters
    ----------
    function : callable
        Defined at the top level of a module, so that processes can find it.
    tasks : sequence
        What to call it with; must be picklable where `jobs` is more than 1.
    jobs : int, optional
        How many processes; by default as many as this process may use cores.
    progress : callable, optional
        Called without arguments whenever one more result is there.

    Raises
    ------
    TypeError, ValueError
        If `jobs` is not a whole number of at least 1. What a task raises is raised here.

    Examples
    --------
    >>> from divbandit.experiments import run_all
    >>> run_all(abs, [-1, 2, -3], jobs=1)
    [1, 2, 3]
    """
    jobs = available_cores() if jobs is None else whole("jobs", jobs, low=1)
    if jobs == 1 or len(tasks) < 2:
        return _collected(map(function, tasks), progress)
    # Forking a process that has threads, as NumPy's libraries do, may hang the child.
    way = "forkserver" if "forkserver" in multiprocessing.get_all_start_methods() else "spawn"
    context = multiprocessing.get_context(way)
    with ProcessPoolExecutor(min(jobs, len(tasks)), mp_context=context) as pool:
        # Chunks keep the processes busy; small ones let the progress be seen.
        chunk = max(1, min(8, len(tasks) // (4 * jobs)))
        try:
            return _collected(pool.map(function, tasks, chunksize=chunk), progress)
        except BaseException:
            pool.shutdown(wait=False, cancel_futures=True)
            raise


def available_cores() -> int:
    """Return how many cores this process may use."""
    if hasattr(os, "sched_getaffinity"):
        return len(os.sched_getaffinity(0))
    return os.cpu_count() or 1


def _collected(results: Iterable[Result], progress: Progress | None) -> list[Result]:
    collected = []
    for result in results:
        collected.append(result)
        if progress is not None:
            progress()
    return collected
