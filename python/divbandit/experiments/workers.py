"""Workers: threads that do what is put to them, until they are stopped."""

from __future__ import annotations

import os
import sys
import threading
from concurrent.futures import Future
from queue import Empty, SimpleQueue
from typing import TYPE_CHECKING, Generic, TypeVar

if TYPE_CHECKING:
    from collections.abc import Callable

    from typing_extensions import Self

Item = TypeVar("Item")
Result = TypeVar("Result")

#: Seconds after which those who wait look around: not every system lets Ctrl-C end a long wait.
_GLANCE = 0.2


class Workers(Generic[Item, Result]):
    """Up to `jobs` threads that call a function with what is put to them.

    Used in a ``with`` statement, by one thread at a time. Leaving it sets `stop`, drops what was
    not begun and waits for the threads to end. They end as well when the program wants to exit
    and nobody is left who could leave it.

    Parameters
    ----------
    function : callable
        Called in any of the threads. If it takes long, it looks at `stop` itself.
    jobs : int
        How many threads at most; each is started when there is something for it to do.
    stop : threading.Event
        Set when no more is wanted.

    Examples
    --------
    >>> import threading
    >>> with Workers(abs, 2, threading.Event()) as workers:
    ...     for number in (-1, 2, -3):
    ...         workers.put(number)
    ...     sorted(workers.get() for _ in range(3))
    [1, 2, 3]
    """

    def __init__(
        self, function: Callable[[Item], Result], jobs: int, stop: threading.Event
    ) -> None:
        self._function, self._jobs, self._stop = function, jobs, stop
        self._todo: SimpleQueue[tuple[Item, Future[Result]] | None] = SimpleQueue()
        self._done: SimpleQueue[Future[Result]] = SimpleQueue()
        self._threads: list[threading.Thread] = []
        self._open = 0
        self._user = threading.current_thread()

    def __len__(self) -> int:
        """Return how many were put and not got yet."""
        return self._open

    def put(self, item: Item) -> None:
        """Have `item` worked on as soon as a thread is free."""
        self._user = threading.current_thread()
        self._open += 1
        self._todo.put((item, Future()))
        if not self._threads:
            self._start(self._watch)
        if len(self._threads) <= self._jobs:  # one of them watches
            self._start(self._work)

    def get(self) -> Result:
        """Wait until one more is done, and return or raise what came of it.

        Raises
        ------
        RuntimeError
            If nobody works any more: the program is exiting, or this is a fork of the process
            whose threads did.
        """
        self._user = threading.current_thread()
        while True:
            try:
                done = self._done.get(timeout=_GLANCE)
            except Empty:
                if self._stop.is_set():
                    raise RuntimeError("nothing more is done: the program is exiting") from None
                if not any(thread.is_alive() for thread in self._threads):
                    raise RuntimeError(
                        "nothing more is done: the threads are those of the process that was forked"
                    ) from None
                continue
            self._open -= 1
            return done.result()

    def __enter__(self) -> Self:
        return self

    def __exit__(self, *_: object) -> None:
        self._stop.set()
        for thread in self._threads:
            # Whoever drops an iterator may be any thread. A Ctrl-C may have come in the middle of
            # starting one, which then ends by itself. And where a free-threaded Python drops it
            # at exit, all have ended, but modules are empty by then.
            if thread.is_alive() and thread is not threading.current_thread():
                thread.join()

    def _start(self, target: Callable[[], None]) -> None:
        if sys.is_finalizing():  # before Python 3.12 the start would be waited for, for ever
            raise RuntimeError("no thread can be started: the program is exiting")
        # No daemon: one that is inside the compiled module must not be cut off when Python ends.
        thread = threading.Thread(target=target, name="divbandit", daemon=False)
        self._threads.append(thread)
        thread.start()

    def _work(self) -> None:
        while not self._stop.is_set() and (put := self._todo.get()) is not None:
            item, done = put
            if not self._stop.is_set():
                try:
                    done.set_result(self._function(item))
                except BaseException as error:  # noqa: BLE001 - raised where it is got
                    done.set_exception(error)
                self._done.put(done)
            del put, item, done  # may be large, and the next may be long in coming

    def _watch(self) -> None:
        while not self._stop.wait(_GLANCE):
            if not (threading.main_thread().is_alive() or self._is_awaited()):
                self._stop.set()
        for _ in self._threads:
            self._todo.put(None)

    def _is_awaited(self) -> bool:
        """Say whether the program, before it exits, waits for the thread that used this last."""
        return self._user.is_alive() and not self._user.daemon


def available_cores() -> int:
    """Return how many cores this process may use.

    Examples
    --------
    >>> available_cores() >= 1
    True
    """
    if hasattr(os, "sched_getaffinity"):
        return len(os.sched_getaffinity(0))
    return os.cpu_count() or 1
