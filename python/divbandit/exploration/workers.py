"""Workers: processes that evaluate a black box, and are replaced when they die or take too long.

Built on pebble. Each worker leads a process group of its own, so that programs it has started end
with it.
"""

from __future__ import annotations

import os
import signal
import tempfile
from concurrent.futures import Future
from concurrent.futures import TimeoutError as FutureTimeoutError
from contextlib import suppress
from pathlib import Path
from typing import TYPE_CHECKING, Any

from divbandit.exploration.evaluating import Outcome, evaluate

if TYPE_CHECKING:
    from collections.abc import Sequence

    import numpy as np
    from numpy.typing import NDArray
    from typing_extensions import Self

    from divbandit.environments import Environment

#: The black box, in a worker.
_environment: Any = None


class Workers:
    """A number of worker processes; leaving the ``with`` statement ends them.

    Parameters
    ----------
    environment : Environment
        Sent to each worker once: it must be picklable where processes are not forked.
    jobs : int
        How many there are.
    timeout : float or None
        The longest time for an evaluation, in seconds.

    Raises
    ------
    ModuleNotFoundError
        If pebble is not installed.
    """

    def __init__(self, environment: Environment, jobs: int, timeout: float | None) -> None:
        try:
            import pebble  # noqa: PLC0415 - optional
        except ModuleNotFoundError as error:
            raise ModuleNotFoundError(
                "jobs needs the package pebble: pip install 'divbandit[jobs]'"
            ) from error
        self._timeout = timeout
        self._expired: type[Exception] = pebble.ProcessExpired
        # Each worker leaves its number here, which is also that of its group.
        self._folder = tempfile.TemporaryDirectory(prefix="divbandit-")
        self._pool: Any = pebble.ProcessPool(
            max_workers=jobs, initializer=_begin, initargs=(environment, self._folder.name)
        )

    def submit(self, commands: Sequence[NDArray[np.float64]]) -> Future[list[Outcome]]:
        """Send commands to the next worker that is free."""
        timeout = None if self._timeout is None else self._timeout * len(commands)
        future: Future[list[Outcome]] = self._pool.schedule(
            _evaluate, args=(commands,), timeout=timeout
        )
        return future

    def lost(self, error: Exception) -> Exception:
        """Return what is to be said of a worker that did not answer."""
        if isinstance(error, FutureTimeoutError):
            return TimeoutError(f"no effect within timeout = {self._timeout:g} s")
        if isinstance(error, self._expired):
            code = getattr(error, "exitcode", None)
            return RuntimeError(f"the worker process ended (exit code {code})")
        return error

    def __enter__(self) -> Self:
        return self

    def __exit__(self, *_: object) -> None:
        self._pool.stop()
        self._pool.join()
        for file in Path(self._folder.name).iterdir():
            with suppress(OSError, AttributeError):
                os.killpg(int(file.name), signal.SIGKILL)
        self._folder.cleanup()


def _begin(environment: Environment, folder: str) -> None:
    """Prepare a worker: Ctrl-C is for the process that it works for."""
    global _environment  # noqa: PLW0603 - one for each process
    _environment = environment
    signal.signal(signal.SIGINT, signal.SIG_IGN)
    with suppress(OSError, AttributeError):
        os.setpgid(0, 0)
        (Path(folder) / str(os.getpid())).touch()


def _evaluate(commands: Sequence[NDArray[np.float64]]) -> list[Outcome]:
    return evaluate(_environment, commands, pickled=True)
