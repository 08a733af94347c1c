"""Workers: processes that call a function, and are replaced when they die or take too long.

They are loky's, which start from nothing: a script needs no guard, functions may be defined
anywhere, and no lock of a thread is copied. Each of them answers a thread of its own, so that it is
always plain which call a death has cost. It leads a process group, so that programs it has started
end with it.
"""

from __future__ import annotations

import os
import signal
from collections.abc import Callable
from concurrent.futures import CancelledError, ThreadPoolExecutor
from contextlib import suppress
from multiprocessing.connection import wait
from queue import SimpleQueue
from threading import Lock, Thread
from time import monotonic, sleep
from typing import TYPE_CHECKING, Any, TypeVar

from divbandit._core import undisturbed
from divbandit._library import library
from divbandit._portable import portable

if TYPE_CHECKING:
    from concurrent.futures import Future
    from multiprocessing.connection import Connection

Result = TypeVar("Result")

#: Calls the function in a worker.
Call = Callable[..., Any]

#: Seconds between looks at whether a process lives: a copy of it that it has left behind keeps its
#: pipes open.
_GLANCE = 0.2

#: Seconds that an idle worker has to end by itself.
_GRACE = 1.0


class LostError(RuntimeError):
    """A worker has died, or took too long; its cause says which."""


class Workers:
    """A number of worker processes, between `start` and `close`.

    Parameters
    ----------
    function : callable
        Sent to each worker once.
    jobs : int
        How many there are.
    timeout : float or None
        The longest time for a call, in seconds.
    user : str
        What needs them, for messages.

    Raises
    ------
    ModuleNotFoundError
        If loky is not installed.
    TypeError
        If the function cannot be pickled.
    """

    def __init__(
        self, function: Callable[..., Any], jobs: int, timeout: float | None, *, user: str
    ) -> None:
        context = library("loky", user=user, extra="jobs").backend.get_context("loky")
        try:
            sent = library("cloudpickle", user=user, extra="jobs").dumps(function)
        except Exception as error:  # a user's object may raise anything
            raise TypeError(f"{user} needs what can be pickled, got: {error}") from error
        self._workers = [_Worker(context, sent, timeout) for _ in range(jobs)]
        self._idle: SimpleQueue[_Worker] = SimpleQueue()
        self._threads = ThreadPoolExecutor(jobs)

    def start(self) -> None:
        """Start all of them; `close` ends them also if this raises."""
        for worker in self._workers:
            undisturbed(worker.start)
            self._idle.put(worker)

    def submit(self, work: Callable[[Call], Result]) -> Future[Result]:
        """Do something in a thread with the next worker that is idle: with its `call`."""
        return self._threads.submit(self._with_idle, work)

    def _with_idle(self, work: Callable[[Call], Result]) -> Result:
        worker = self._idle.get()
        try:
            return work(worker.call)
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

    def __init__(self, context: Any, function: bytes, timeout: float | None) -> None:  # noqa: ANN401
        self._context, self._function, self._timeout = context, function, timeout
        self._lock = Lock()  # of what follows, but for who calls
        self._process: Any = None
        self._pipe: Connection[Any, Any]
        self._is_closed = self._is_dismissed = self._is_ready = False
        self._sent = 0  # messages

    def start(self) -> None:
        """Start a process, in place of the one before."""
        with self._lock:
            self._kill()
            if self._is_closed:
                raise CancelledError
            self._is_ready = False
            self._pipe, theirs = self._context.Pipe()
            # No daemon: a function may start processes, too.
            self._process = self._context.Process(
                target=_work, args=(self._function, theirs), daemon=False
            )
            self._process.start()
            theirs.close()

    def call(self, *arguments: object, calls: int = 1) -> Any:  # noqa: ANN401 - what it returns
        """Return what the function returns, in the time for so many calls, or raise what it raises.

        Raises a LostError if the process dies, or takes too long; it is replaced.
        """
        try:
            result, error = self._answer(arguments, calls)
        except LostError:
            self.start()
            raise
        if error is not None:
            raise error
        return result

    def _answer(
        self, arguments: tuple[object, ...], calls: int
    ) -> tuple[Any, BaseException | None]:
        if not self._process.is_alive():  # it has died when there was nothing to do
            self.start()
        process = self._process
        self._await_ready()
        self._sent += 1
        end = None if self._timeout is None else monotonic() + self._timeout * calls
        with suppress(EOFError, OSError):  # it has ended
            self._pipe.send((self._sent, arguments))
            while process.is_alive() or self._pipe.poll():
                left = _GLANCE if end is None else min(_GLANCE, end - monotonic())
                if self._pipe in wait([self._pipe, process.sentinel], max(0, left)):
                    number, result, error = self._received()
                    if number == self._sent:
                        return result, error
                elif left <= 0:
                    late = TimeoutError(f"no effect within timeout = {self._timeout:g} s")
                    raise LostError from late
        _await_end(process, monotonic() + _GRACE)
        died = RuntimeError(f"the worker process ended (exit code {process.exitcode})")
        raise LostError from died

    def _await_ready(self) -> None:
        """Wait until the process has the function: that takes none of a call's time."""
        problem = "it ended"
        with suppress(EOFError, OSError):
            while not self._is_ready and (self._process.is_alive() or self._pipe.poll()):
                if self._pipe.poll(_GLANCE):
                    problem = self._pipe.recv()
                    self._is_ready = problem == ""
                    break
        if not self._is_ready:
            raise RuntimeError(f"a worker process could not begin: {problem}")

    def _received(self) -> Any:  # noqa: ANN401
        try:
            return self._pipe.recv()
        except (EOFError, OSError):
            raise
        except Exception as error:  # it cannot be read in this process
            raise LostError from error

    def dismiss(self) -> None:
        """Tell the process, which is idle, to end, unless it is still beginning."""
        if self._is_ready:
            with suppress(OSError):
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
                os.killpg(self._process.pid, signal.SIGKILL)
            with suppress(OSError):  # where there are no groups, or it leads none yet
                os.kill(self._process.pid, getattr(signal, "SIGKILL", signal.SIGTERM))
            self._process.join()


def _await_end(process: Any, until: float) -> None:  # noqa: ANN401
    """Wait for a process; `join` with a time-out would wait for its copies, too."""
    while process.is_alive() and monotonic() < until:
        process.join(0.02)


def _work(function: bytes, pipe: Connection[Any, Any]) -> None:
    """Answer messages: what a worker does."""
    signal.signal(signal.SIGINT, signal.SIG_IGN)  # Ctrl-C is for the process that it works for
    with suppress(OSError, AttributeError):
        os.setpgid(0, 0)
    Thread(target=_end_with, args=(os.getppid(),), daemon=True).start()
    try:
        call = library("cloudpickle", user="a worker").loads(function)
    except BaseException as error:  # noqa: BLE001 - a user's object may raise anything
        pipe.send(f"{type(error).__name__}: {error}")
        return
    try:
        pipe.send("")
    except OSError:  # the process that it works for has ended
        return
    me = os.getpid()
    while (message := _next(pipe)) is not None:
        number, arguments = message
        result, problem = None, None
        try:
            result = call(*arguments)
        except BaseException as error:  # noqa: BLE001 - raised where it was called from
            problem = portable(error)
        if os.getpid() != me:  # the function has forked, and come back twice
            os._exit(0)
        with suppress(OSError):  # as in `_next`
            try:
                pipe.send((number, result, problem))
            except OSError:
                raise
            except Exception as error:  # noqa: BLE001 - pickling may fail in any way
                pipe.send((number, None, portable(error)))


def _next(pipe: Connection[Any, Any]) -> Any:  # noqa: ANN401 - a message
    """Return the next message; None if the process that sends them has been killed."""
    try:
        return pipe.recv()
    except (EOFError, OSError):
        return None


def _end_with(parent: int) -> None:
    """End this process, and what it has started, when the one that it works for has been killed."""
    while os.getppid() == parent:
        sleep(_GLANCE)
    with suppress(AttributeError):
        os.killpg(0, signal.SIGKILL)
    os._exit(1)
