"""over_processes: a function of many items, each in one of several processes."""

from __future__ import annotations

from functools import partial
from queue import SimpleQueue
from typing import TYPE_CHECKING, Any, TypeVar

from divbandit._core import undisturbed
from divbandit._workers import Workers
from divbandit.experiments.cores import available_cores

if TYPE_CHECKING:
    from collections.abc import Callable, Sequence
    from concurrent.futures import Future

    from divbandit._workers import Call
    from divbandit.experiments.explore_many import Progress

Item = TypeVar("Item")
Result = TypeVar("Result")


def over_processes(
    function: Callable[[Item], Result],
    items: Sequence[Item],
    *,
    jobs: int | None = None,
    progress: Progress | None = None,
    found: Callable[[Result], None] = lambda _: None,
) -> list[Result]:
    """Return ``[function(item) for item in items]``, worked out by several processes.

    Explorations with parts in Python take turns where they are threads of one process; here they
    run side by side. What `function` does must depend on its item alone.

    Parameters
    ----------
    function : callable
        Picklable.
    items : sequence
        Picklable.
    jobs : int, optional
        How many processes; by default one for each core. With 1 all is done in this one.
    progress : callable, optional
        Called without arguments whenever one more is done.
    found : callable
        Called with each result as soon as it is there, in the order in which they come in.

    Raises
    ------
    Exception
        What `function` raises, and Ctrl-C; calls under way in other processes are ended.

    Examples
    --------
    >>> over_processes(abs, [-1, 2, -3], jobs=1)
    [1, 2, 3]
    """
    jobs = min(available_cores() if jobs is None else jobs, len(items))
    told = progress or (lambda: None)
    results: list[Result] = []
    if jobs <= 1:
        for item in items:
            results.append(function(item))
            found(results[-1])
            told()
        return results
    workers = Workers(function, jobs, None, user="a study")
    done: SimpleQueue[Future[Result]] = SimpleQueue()
    try:
        workers.start()
        futures = [undisturbed(workers.submit, partial(_call_with, item)) for item in items]
        for future in futures:
            undisturbed(future.add_done_callback, done.put)
        for _ in items:
            found(undisturbed(done.get().result))
            told()
        return [undisturbed(future.result) for future in futures]
    finally:
        workers.close()


def _call_with(item: object, call: Call) -> Any:  # noqa: ANN401 - what the function returns
    return call(item)
