"""Workers: processes that call a function, and are replaced when they die or take too long.

Built on pebble, which watches them, and on loky, whose processes start from nothing: a script needs
no guard, functions may be defined anywhere, and no lock of a thread is copied. Each worker leads a
process group of its own, so that programs it has started end with it.
"""

from __future__ import annotations

import os
import signal
import tempfile
from concurrent.futures import Future
from concurrent.futures import TimeoutError as FutureTimeoutError
from contextlib import suppress
from pathlib import Path
from typing import TYPE_CHECKING, Any, Generic, TypeVar

from divbandit._library import library

if TYPE_CHECKING:
    from collections.abc import Callable

    from typing_extensions import Self

Argument = TypeVar("Argument")
Result = TypeVar("Result")

#: What a worker calls.
_function: Any = None


class Workers(Generic[Argument, Result]):
    """A number of worker processes that call a function; leaving the ``with`` statement ends them.

    Parameters
    ----------
    function : callable
        Sent to each worker once.
    jobs : int
        How many there are.
    timeout : float, optional
        The longest time for a call, in seconds.
    user : str
        What needs them, for messages.

    Raises
    ------
    ModuleNotFoundError
        If pebble or loky are not installed.
    TypeError
        If the function cannot be pickled.
    """

    def __init__(
        self,
        function: Callable[[Argument], Result],
        jobs: int,
        *,
        timeout: float | None = None,
        user: str,
    ) -> None:
        names = ("cloudpickle", "loky", "pebble")
        cloudpickle, loky, pebble = (library(name, user=user, extra="jobs") for name in names)
        try:
            sent = cloudpickle.dumps(function)
        except Exception as error:  # a user's object may raise anything
            raise TypeError(f"{user} needs what can be pickled, got: {error}") from error
        self._timeout = timeout
        self._expired: type[Exception] = pebble.ProcessExpired
        # Each worker leaves its number here, which is also that of its group.
        self._folder = tempfile.TemporaryDirectory(prefix="divbandit-")
        self._pool: Any = pebble.ProcessPool(
            max_workers=jobs,
            initializer=_begin,
            initargs=(sent, self._folder.name),
            context=loky.backend.get_context("loky"),
        )

    def submit(self, argument: Argument, *, calls: int = 1) -> Future[Result]:
        """Have the next worker that is free call the function, in the time for so many calls."""
        timeout = None if self._timeout is None else self._timeout * calls
        future: Future[Result] = self._pool.schedule(_call, args=(argument,), timeout=timeout)
        return future

    def lost(self, error: Exception) -> Exception:
        """Return what is to be said of a worker that did not answer."""
        if isinstance(error, FutureTimeoutError):
            return TimeoutError(f"no effect within timeout = {self._timeout:g} s")
        if isinstance(error, self._expired):
            code = getattr(error, "exitcode", None)
            return RuntimeError(f"the worker process ended (exit code {code})")
        return error

    def stop(self) -> None:
        """End them, whatever they do."""
        self._pool.stop()
        self._pool.join()
        for file in Path(self._folder.name).iterdir():
            with suppress(OSError, AttributeError):
                os.killpg(int(file.name), signal.SIGKILL)
        self._folder.cleanup()

    def __enter__(self) -> Self:
        return self

    def __exit__(self, *_: object) -> None:
        self.stop()


def _begin(function: bytes, folder: str) -> None:
    """Prepare a worker: Ctrl-C is for the process that it works for."""
    global _function  # noqa: PLW0603 - one for each process
    signal.signal(signal.SIGINT, signal.SIG_IGN)
    with suppress(OSError, AttributeError):
        os.setpgid(0, 0)
        (Path(folder) / str(os.getpid())).touch()
    _function = library("cloudpickle", user="a worker").loads(function)


def _call(argument: Any) -> Any:  # noqa: ANN401 - whatever the function takes and returns
    return _function(argument)
