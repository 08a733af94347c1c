"""Threads: function calls in several threads, which all end when they are stopped."""

from __future__ import annotations

import os
from concurrent.futures import Future, ThreadPoolExecutor
from concurrent.futures import thread as executors
from contextlib import suppress
from functools import partial
from queue import Empty, SimpleQueue
from threading import Event, Thread, current_thread
from typing import TYPE_CHECKING, Any, Generic, ParamSpec, TypeVar

from divbandit._core import undisturbed

if TYPE_CHECKING:
    from collections.abc import Callable

    from typing_extensions import Self

    from divbandit._core import Trial
    from divbandit.exploration import Explorer

Result = TypeVar("Result")
Arguments = ParamSpec("Arguments")

#: Seconds between checks while waiting: not every system lets Ctrl-C interrupt a long wait.
_GLANCE = 0.2


class StoppedError(RuntimeError):
    """A call was stopped before its end."""


class Threads(Generic[Result]):
    """Up to `jobs` threads that make calls; leaving the ``with`` statement ends them.

    Examples
    --------
    >>> with Threads(2) as threads:
    ...     for number in (-1, 2, -3):
    ...         threads.submit(abs, number)
    ...     sorted(threads.result() for _ in range(len(threads)))
    [1, 2, 3]
    """

    def __init__(self, jobs: int) -> None:
        self._stop, self._process, self._workers = Event(), os.getpid(), set[Thread]()
        self._executor = ThreadPoolExecutor(
            jobs, "divbandit", lambda: self._workers.add(current_thread())
        )
        self._done: SimpleQueue[Future[Result]] = SimpleQueue()
        self._pending = 0

    def __len__(self) -> int:
        """Return the number of calls whose results were not returned yet."""
        return self._pending

    def submit(
        self,
        function: Callable[Arguments, Result],
        *args: Arguments.args,
        **kwargs: Arguments.kwargs,
    ) -> None:
        """Call a function as soon as a thread is free."""
        future = undisturbed(partial(self._executor.submit, function, *args, **kwargs))
        undisturbed(future.add_done_callback, self._done.put)
        self._pending += 1

    def result(self) -> Result:
        """Wait for the next call to end, and return or raise its outcome."""
        done = None
        while done is None:
            if os.getpid() != self._process:
                raise RuntimeError("explore_many cannot go on in a forked process")
            with suppress(Empty):
                done = self._done.get(timeout=_GLANCE)
        self._pending -= 1
        result: Result = undisturbed(done.result)
        return result

    def check(self) -> None:
        """Raise a StoppedError if all is to end; long calls do this every now and then."""
        # At exit the executor waits for its threads; only this flag says that it does.
        if self._stop.is_set() or executors._shutdown:  # noqa: SLF001
            raise StoppedError("the exploration was stopped: the program is exiting")

    def __enter__(self) -> Self:
        return self

    def __exit__(self, *_: object) -> None:
        self._stop.set()
        # The executor itself would not wait for a thread whose start Ctrl-C interrupted.
        self._executor.shutdown(wait=False, cancel_futures=True)
        # An iterator may be dropped in any thread, even in one of these.
        if current_thread() not in self._workers:
            for worker in tuple(self._workers):
                worker.join()


class Check:
    """A callback that ends an exploration when all is to end."""

    every = "50ms"

    def __init__(self, threads: Threads[Any]) -> None:
        self._check = threads.check

    def __call__(self, _explorer: Explorer, _trial: Trial, /) -> None:
        """Raise a StoppedError if all is to end."""
        self._check()
