"""Elsewhere: whole explorations in other processes, where in threads they would take turns."""

from __future__ import annotations

from concurrent.futures import TimeoutError as FutureTimeoutError
from contextlib import suppress
from importlib.util import find_spec
from threading import Lock
from typing import TYPE_CHECKING, Any

from numpy.random import Generator

from divbandit._library import library
from divbandit._workers import Workers
from divbandit.environments import PlanarArm, PushArm
from divbandit.exploration.drivers import runs_in_rust
from divbandit.exploration.evaluating import portable
from divbandit.exploration.explore import explore

if TYPE_CHECKING:
    from collections.abc import Callable
    from concurrent.futures import Executor, Future

    from divbandit._checks import Rng
    from divbandit.experiments.task import Task
    from divbandit.exploration import Exploration

    Keep = Callable[[Exploration], object] | None

#: Seconds between two looks at whether to stop.
_GLANCE = 0.05


class Elsewhere:
    """Explores tasks through an executor, or in worker processes where that is of use."""

    def __init__(self, jobs: int, executor: Executor | None) -> None:
        self._jobs, self._executor = jobs, executor
        self._workers: Workers[Any, object] | None = None
        self._lock = Lock()

    def takes(self, task: Task, keep: Keep) -> bytes | None:
        """Return what to send of a task, if it is not explored in a thread of this process."""
        if self._executor is not None:
            return b""
        at_once = self._jobs == 1 or isinstance(task.rng, Generator)  # which it must advance
        if at_once or _runs_in_rust(task) or find_spec("pebble") is None:
            return None
        with suppress(Exception):  # a user's object may raise anything
            return bytes(library("cloudpickle", user="explore_many").dumps((task, keep)))
        return None

    def explored(
        self, task: Task, rng: Rng, keep: Keep, sent: bytes, check: Callable[[], None]
    ) -> object:
        """Explore a task; `check` is called every now and then, and may raise."""
        if self._executor is not None:
            future: Future[object] = self._executor.submit(explored, task, rng, keep)
        else:
            future = self._own().submit((sent, rng))
        while True:
            check()
            try:
                return future.result(_GLANCE)
            except FutureTimeoutError:
                if future.done():
                    return future.result()
            except Exception as error:  # noqa: BLE001 - of the task, or of its worker
                raise (self._workers.lost(error) if self._workers else error) from None

    def _own(self) -> Workers[Any, object]:
        with self._lock:
            if self._workers is None:
                self._workers = Workers(_explored, self._jobs, user="explore_many")
            return self._workers

    def __enter__(self) -> None: ...

    def __exit__(self, *_: object) -> None:
        if self._workers is not None:
            self._workers.stop()


def _runs_in_rust(task: Task) -> bool:
    """Whether nothing of a task is in Python."""
    native = type(task.environment) in {PlanarArm, PushArm} and task.engine != "python"
    return native and runs_in_rust(task.strategy, task.environment)


def explored(task: Task, rng: Rng, keep: Keep) -> object:
    """Explore a task, and return what is kept of it."""
    try:
        run = explore(
            task.environment,
            task.strategy,
            task.n,
            rng=rng,
            engine=task.engine,
            keep_commands=task.keep_commands,
            on_error=task.on_error,
        )
        return run if keep is None else keep(run)
    except BaseException as error:  # noqa: BLE001 - sent to where it is raised
        with suppress(AttributeError):
            del error.explorer  # type: ignore[attr-defined] # it stays here
        raise portable(error) from None


def _explored(sent: tuple[bytes, Rng]) -> object:
    task, keep = library("cloudpickle", user="explore_many").loads(sent[0])
    return explored(task, sent[1], keep)
