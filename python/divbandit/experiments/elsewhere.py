"""Elsewhere: whole explorations in other processes, where in threads they would take turns."""

from __future__ import annotations

from concurrent.futures import TimeoutError as FutureTimeoutError
from contextlib import suppress
from dataclasses import replace
from functools import partial
from importlib.util import find_spec
from threading import Lock
from typing import TYPE_CHECKING

from numpy.random import Generator

from divbandit._library import library
from divbandit._portable import portable
from divbandit._workers import LostError, Workers
from divbandit.environments import PlanarArm, PushArm
from divbandit.exploration.drivers import runs_in_rust

if TYPE_CHECKING:
    from collections.abc import Callable
    from concurrent.futures import Executor, Future

    from divbandit._checks import Rng
    from divbandit._workers import Call
    from divbandit.experiments.task import Task
    from divbandit.exploration import Exploration

    Keep = Callable[[Exploration], object] | None

#: Seconds between two looks at whether to stop.
_GLANCE = 0.05


class Elsewhere:
    """Explores tasks through an executor, or in worker processes where that is of use."""

    def __init__(self, jobs: int, executor: Executor | None) -> None:
        self._jobs, self._executor = jobs, executor
        self._workers: Workers | None = None
        self._lock = Lock()

    def takes(self, task: Task, keep: Keep) -> bytes | None:
        """Return what to send of a task, if it is not explored in a thread of this process."""
        if self._executor is not None:
            return b""
        at_once = self._jobs == 1 or isinstance(task.rng, Generator)  # which it must advance
        if at_once or _runs_in_rust(task) or find_spec("loky") is None:
            return None
        with suppress(Exception):  # a user's object may raise anything
            return bytes(library("cloudpickle", user="explore_many").dumps((task, keep)))
        return None

    def explored(
        self, task: Task, rng: Rng, keep: Keep, sent: bytes, check: Callable[[], None]
    ) -> object:
        """Explore a task; `check` is called every now and then, and may raise."""
        future: Future[object]
        if self._executor is not None:
            future = self._executor.submit(explored, task, rng, keep)
        else:
            future = self._own().submit(partial(_answered, sent=sent, rng=rng))
        while True:
            check()
            try:
                return future.result(_GLANCE)
            except FutureTimeoutError:
                if future.done():
                    return future.result()

    def _own(self) -> Workers:
        with self._lock:
            if self._workers is None:
                self._workers = Workers(_explored, self._jobs, None, user="explore_many")
                self._workers.start()
            return self._workers

    def __enter__(self) -> None: ...

    def __exit__(self, *_: object) -> None:
        if self._workers is not None:
            self._workers.close()


def _answered(call: Call, sent: bytes, rng: Rng) -> object:
    """Return what a worker has kept of a task, or raise what it has raised."""
    try:
        return call(sent, rng)
    except LostError as lost:
        raise (lost.__cause__ or lost) from None


def _runs_in_rust(task: Task) -> bool:
    """Whether nothing of a task is in Python."""
    native = type(task.environment) in {PlanarArm, PushArm} and task.engine != "python"
    return native and runs_in_rust(task.strategy, task.environment)


def explored(task: Task, rng: Rng, keep: Keep) -> object:
    """Explore a task, and return what is kept of it."""
    try:
        run = replace(task, rng=rng).explore()
        return run if keep is None else keep(run)
    except BaseException as error:  # noqa: BLE001 - sent to where it is raised
        with suppress(AttributeError):
            del error.explorer  # type: ignore[attr-defined] # it stays here
        raise portable(error) from None


def _explored(sent: bytes, rng: Rng) -> object:
    """Do so in a worker."""
    task, keep = library("cloudpickle", user="explore_many").loads(sent)
    return explored(task, rng, keep)
