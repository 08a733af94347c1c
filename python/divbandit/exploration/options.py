"""Options: how an explorer runs, checked."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass
from typing import TYPE_CHECKING, Literal

from divbandit._checks import one_of, whole
from divbandit._duration import seconds
from divbandit.callbacks.protocol import check_callback
from divbandit.environments import Environment
from divbandit.exploration.watching import Every, period

if TYPE_CHECKING:
    import os
    from concurrent.futures import Executor

    from divbandit.callbacks.protocol import CallbackLike

#: What to do if an evaluation fails.
OnError = Literal["raise", "record"]


@dataclass(frozen=True)
class Options:
    """How `Explorer.run` evaluates: its arguments, and checks of them."""

    jobs: int | None = None
    executor: Executor | None = None
    in_flight: int | None = None
    batch: int = 1
    timeout: float | str | None = None
    on_error: OnError = "raise"
    max_failures: int | None = None
    callbacks: Iterable[CallbackLike] = ()
    checkpoint: str | os.PathLike[str] | None = None
    every: Every = "30s"

    def __post_init__(self) -> None:
        one_of("on_error", self.on_error, ("raise", "record"))
        for name in ("jobs", "in_flight", "batch", "max_failures"):
            if (value := getattr(self, name)) is not None or name == "batch":
                whole(name, value, low=1)
        self._check_where()
        if self.timeout is not None:
            object.__setattr__(self, "timeout", seconds("timeout", self.timeout))
            if self.jobs is None:
                raise ValueError(
                    f"timeout needs worker processes that can be ended, such as jobs=1, "
                    f"got {self.timeout!r} without jobs"
                )
        if callable(self.callbacks) or not isinstance(self.callbacks, Iterable):
            raise TypeError(
                "callbacks must be a list of callables, such as [callback], "
                f"got {type(self.callbacks).__name__}"
            )
        object.__setattr__(self, "callbacks", tuple(self.callbacks))
        for index, callback in enumerate(self.callbacks):
            check_callback(f"callbacks[{index}]", callback)
        period("every", self.every)

    def _check_where(self) -> None:
        if self.executor is not None:
            check_executor(self.executor)
            if self.jobs is not None:
                raise ValueError(f"jobs and executor must not both be given, got jobs={self.jobs}")
            if self.in_flight is None:
                raise ValueError("in_flight must be given together with an executor, got None")
        elif self.jobs is None and self.in_flight is not None:
            raise ValueError(
                f"in_flight must be given with an executor or jobs alone, got {self.in_flight!r}"
            )


def check_executor(executor: object) -> None:
    """Raise a TypeError unless calls can be submitted to it."""
    if not callable(getattr(executor, "submit", None)):
        kind = type(executor).__name__
        raise TypeError(f"executor must be a concurrent.futures.Executor, got {kind}")


def check_environment(environment: object) -> None:
    """Raise a TypeError unless this is a black box with its spaces."""
    if not isinstance(environment, Environment):
        raise TypeError(
            "environment must be callable and have motor_space and sensory_space "
            f"(FunctionEnvironment makes one of a function), got {type(environment).__name__}"
        )
