"""Workers: processes that evaluate a black box, and are replaced when they die or take too long.

Each of them answers a thread of its own, so that it is always plain which evaluation a death has
cost. It leads a process group, so that programs it has started end with it.
"""

from __future__ import annotations

import os
import signal
from concurrent.futures import CancelledError, ThreadPoolExecutor
from contextlib import suppress
from multiprocessing import Pipe, Process
from multiprocessing.connection import wait
from queue import SimpleQueue
from threading import Lock, Thread
from time import monotonic, sleep
from typing import TYPE_CHECKING, Any

from divbandit._core import undisturbed
from divbandit.exploration.evaluating import Outcome, evaluate

if TYPE_CHECKING:
    from collections.abc import Sequence
    from concurrent.futures import Future
    from multiprocessing.connection import Connection

    import numpy as np
    from numpy.typing import NDArray

    from divbandit.environments import Environment

    Commands = Sequence[NDArray[np.float64]]

#: Seconds between looks at whether a process lives: a copy of it that it has left behind keeps its
#: pipes open.
_GLANCE = 0.2

#: Seconds that an idle worker has to end by itself.
_GRACE = 1.0


class Workers:
    """A number of worker processes, between `start` and `close`.

    Parameters
    ----------
    environment : Environment
        Sent to each worker once: it must be picklable where processes are not forked.
    jobs : int
        How many there are.
    timeout : float or None
        The longest time for an evaluation, in seconds.
    """

    def __init__(self, environment: Environment, jobs: int, timeout: float | None) -> None:
        self._workers = [_Worker(environment, timeout) for _ in range(jobs)]
        self._idle: SimpleQueue[_Worker] = SimpleQueue()
        self._threads = ThreadPoolExecutor(jobs)

    def start(self) -> None:
        """Start all of them; `close` ends them also if this raises."""
        for worker in self._workers:
            undisturbed(worker.start)
            self._idle.put(worker)

    def submit(self, commands: Commands, dim: int | None) -> Future[list[Outcome]]:
        """Let the next worker that is idle `evaluate`."""
        return self._threads.submit(self._evaluate, commands, dim)

    def _evaluate(self, commands: Commands, dim: int | None) -> list[Outcome]:
        worker = self._idle.get()
        try:
            return worker.evaluate(commands, dim)
        finally:
            self._idle.put(worker)

    def close(self) -> None:
        """End all of them, and what they have started."""
        undisturbed(self._close)

    def _close(self) -> None:
        self._threads.shutdown(wait=False, cancel_futures=True)
        with suppress(Exception):  # none is idle any more
            while True:
                self._idle.get_nowait().dismiss()
        until = monotonic() + _GRACE
        for worker in self._workers:
            worker.close(until)
        self._threads.shutdown()


class _Worker:
    """A process, and another one when it has ended."""

    def __init__(self, environment: Environment, timeout: float | None) -> None:
        self._environment, self._timeout = environment, timeout
        self._lock = Lock()  # of what follows, but for who evaluates
        self._process: Process | None = None
        self._pipe: Connection[Any, Any]
        self._is_closed = self._is_dismissed = False
        self._sent = 0  # messages

    def start(self) -> None:
        """Start a process, in place of the one before."""
        with self._lock:
            self._kill()
            if self._is_closed:
                raise CancelledError
            self._pipe, theirs = Pipe()
            # No daemon: a black box may start processes, too.
            process = Process(target=_work, args=(self._environment, theirs), daemon=False)
            process.start()
            self._process = process
            theirs.close()
            with suppress(OSError, AttributeError):
                os.setpgid(process.pid or 0, process.pid or 0)  # it does so too, but when?

    def evaluate(self, commands: Commands, dim: int | None) -> list[Outcome]:
        """Return what comes of commands; a death, or a time-out, is the fault of one of them."""
        lost = self._answer(commands, dim)
        if isinstance(lost, list):
            return lost
        self.start()
        if len(commands) == 1:
            return [Outcome.of(lost)]
        return [outcome for command in commands for outcome in self.evaluate([command], dim)]

    def _answer(self, commands: Commands, dim: int | None) -> list[Outcome] | Exception:
        """Return the answer of the process, or why there is none."""
        process = self._process
        if process is None or not process.is_alive():  # it has died when there was nothing to do
            self.start()
            process = self._process
        assert process is not None  # noqa: S101 - for mypy
        self._sent += 1
        end = None if self._timeout is None else monotonic() + self._timeout * len(commands)
        with suppress(EOFError, OSError):  # it has ended
            self._pipe.send((self._sent, commands, dim))
            while process.is_alive() or self._pipe.poll():
                left = _GLANCE if end is None else min(_GLANCE, end - monotonic())
                if self._pipe in wait([self._pipe, process.sentinel], max(0, left)):
                    try:
                        number, outcomes = self._pipe.recv()
                    except (EOFError, OSError):
                        raise
                    except Exception as error:  # noqa: BLE001 - it cannot be read in this process
                        return error
                    if number == self._sent:
                        return list(outcomes)
                elif left <= 0:
                    return TimeoutError(f"no effect within timeout = {self._timeout:g} s")
        _await_end(process, monotonic() + _GRACE)
        return RuntimeError(f"the worker process ended (exit code {process.exitcode})")

    def dismiss(self) -> None:
        """Tell the process, which is idle, to end."""
        with suppress(OSError, AttributeError):
            self._pipe.send(None)
            self._is_dismissed = True

    def close(self, until: float) -> None:
        """End the process; one that was dismissed may do so itself until then."""
        with self._lock:
            self._is_closed = True
            if self._process is not None and self._is_dismissed:
                _await_end(self._process, until)
            self._kill()

    def _kill(self) -> None:
        """End the process, and all that it has started."""
        if self._process is not None:
            with suppress(OSError, AttributeError, TypeError):
                os.killpg(self._process.pid, signal.SIGKILL)  # type: ignore[arg-type]
            self._process.kill()
            self._process.join()


def _await_end(process: Process, until: float) -> None:
    """Wait for a process; `join` with a time-out would wait for its copies, too."""
    while process.is_alive() and monotonic() < until:
        process.join(0.02)


def _work(environment: Environment, pipe: Connection[Any, Any]) -> None:
    """Answer messages: what a worker does."""
    signal.signal(signal.SIGINT, signal.SIG_IGN)  # Ctrl-C is for the process that it works for
    with suppress(OSError, AttributeError):
        os.setpgid(0, 0)
    Thread(target=_end_with, args=(os.getppid(),), daemon=True).start()
    me = os.getpid()
    while (message := pipe.recv()) is not None:
        number, commands, dim = message
        outcomes = evaluate(environment, commands, dim, pickled=True)
        if os.getpid() != me:  # the black box has forked, and come back twice
            os._exit(0)
        pipe.send((number, outcomes))


def _end_with(parent: int) -> None:
    """End this process, and what it has started, when the one that it works for has been killed."""
    while os.getppid() == parent:
        sleep(_GLANCE)
    with suppress(AttributeError):
        os.killpg(0, signal.SIGKILL)
    os._exit(1)
