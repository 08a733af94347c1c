"""over_processes: a function of many items, each in one of several processes."""

from __future__ import annotations

import signal
from concurrent.futures import FIRST_COMPLETED, Future, ProcessPoolExecutor, wait
from itertools import islice
from multiprocessing import get_context
from typing import TYPE_CHECKING, TypeVar

from divbandit.experiments.cores import available_cores

if TYPE_CHECKING:
    from collections.abc import Callable, Sequence

    from divbandit.experiments.explore_many import Progress

Item = TypeVar("Item")
Result = TypeVar("Result")


def over_processes(
    function: Callable[[Item], Result],
    items: Sequence[Item],
    *,
    jobs: int | None = None,
    progress: Progress | None = None,
) -> list[Result]:
    """Return ``[function(item) for item in items]``, worked out by several processes.

    Explorations with parts in Python take turns where they are threads of one process; here they
    run side by side. What `function` does must depend on its item alone.

    Parameters
    ----------
    function : callable
        Defined at the top of a module, so that processes find it.
    items : sequence
        Picklable.
    jobs : int, optional
        How many processes; by default one for each core. With 1 all is done in this one. With more,
        a script that gets here must be guarded by ``if __name__ == "__main__":``.
    progress : callable, optional
        Called without arguments whenever one more is done.

    Raises
    ------
    Exception
        What `function` raises, and Ctrl-C, once the calls under way have ended; no others begin.

    Examples
    --------
    >>> over_processes(abs, [-1, 2, -3], jobs=1)
    [1, 2, 3]
    """
    jobs = min(available_cores() if jobs is None else jobs, len(items))
    told = progress or (lambda: None)
    results: dict[int, Result] = {}
    if jobs <= 1:
        for place, item in enumerate(items):
            results[place] = function(item)
            told()
        return list(results.values())
    rest, running = iter(enumerate(items)), dict[Future[Result], int]()
    with ProcessPoolExecutor(jobs, get_context("spawn"), _leave_interrupts) as executor:
        while len(results) < len(items):
            # No call waits in the executor's queue, out of which it cannot be taken again.
            for place, item in islice(rest, jobs - len(running)):
                running[executor.submit(function, item)] = place
            for future in wait(running, return_when=FIRST_COMPLETED).done:
                results[running.pop(future)] = future.result()
                told()
    return [results[place] for place in range(len(items))]


def _leave_interrupts() -> None:
    """Let Ctrl-C end the process that waits for the others, which end after the call under way."""
    signal.signal(signal.SIGINT, signal.SIG_IGN)
