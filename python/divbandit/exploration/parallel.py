"""parallel: several trials under way at a time, through an executor or in worker processes."""

from __future__ import annotations

import math
from concurrent.futures import BrokenExecutor, CancelledError, Future
from contextlib import suppress
from functools import partial
from queue import Empty, SimpleQueue
from typing import TYPE_CHECKING

from divbandit._core import as_point, undisturbed
from divbandit._workers import LostError, Workers
from divbandit.exploration.evaluating import Outcome, evaluate, note

if TYPE_CHECKING:
    from collections.abc import Sequence

    import numpy as np
    from numpy.typing import NDArray

    from divbandit._core import Trial
    from divbandit._workers import Call
    from divbandit.environments import Environment
    from divbandit.exploration.options import Options
    from divbandit.exploration.running import Loop

#: Seconds between checks while waiting: not every system lets Ctrl-C interrupt a long wait.
_GLANCE = 0.2


class Parallel:
    """Several trials at a time, told as their effects come in.

    Ctrl-C must not come while a lock of an executor or a future is taken: it would never be free
    again, and the executor never end.
    """

    def __init__(self, loop: Loop, environment: Environment, options: Options) -> None:
        self._loop, self._environment, self._options = loop, environment, options
        self._most = options.in_flight or options.jobs or 1
        self._under_way: dict[Future[list[Outcome]], list[Trial]] = {}
        self._ready: SimpleQueue[Future[list[Outcome]]] = SimpleQueue()
        self._left_over = list(loop.explorer.open_trials)
        self._workers = (
            None
            if options.jobs is None
            else Workers(
                partial(evaluate, environment, pickled=True),
                options.jobs,
                options.timeout,  # type: ignore[arg-type] # in seconds, as checked
                user="jobs",
            )
        )

    def start(self) -> None:
        """Start the workers."""
        if self._workers is not None:
            self._workers.start()

    def close(self) -> None:
        """End the workers, and cancel what no other executor has begun."""
        if self._workers is not None:
            self._workers.close()
        for future in self._under_way:
            undisturbed(future.cancel)

    def _submit(self, trials: list[Trial]) -> None:
        environment, executor = self._environment, self._options.executor
        commands = [trial.command for trial in trials]
        dim = self._loop.explorer.history.effect_dim
        future: Future[list[Outcome]]
        if self._workers is not None:
            work = partial(_evaluated, commands=commands, dim=dim)
            future = undisturbed(self._workers.submit, work)
        elif executor is not None:
            submit = executor.submit
            future = undisturbed(lambda: submit(evaluate, environment, commands, dim, pickled=True))
        else:
            future = Future()
            future.set_result(evaluate(environment, commands, dim))
        self._under_way[future] = trials
        undisturbed(future.add_done_callback, self._ready.put)

    def advance(self, n: int, seconds: float) -> None:
        """Keep all workers busy, and tell what comes in."""
        del n
        self._send()
        self._receive(seconds)

    def finish(self) -> None:
        """Wait for what is under way."""
        while self._under_way:
            self._receive(math.inf)

    def _send(self) -> None:
        under_way = sum(map(len, self._under_way.values()))
        while len(self._under_way) < self._most and under_way < self._loop.left:
            trials: list[Trial] = []
            for _ in range(min(self._options.batch, self._loop.left - under_way)):
                again = self._left_over.pop(0) if self._left_over else None
                trials.append(again or self._loop.explorer.ask())
            self._submit(trials)
            under_way += len(trials)

    def _receive(self, seconds: float) -> None:
        done = set()
        with suppress(Empty):
            done.add(self._ready.get(timeout=min(seconds, _GLANCE)))
            while True:
                done.add(self._ready.get_nowait())
        # Those that come in together are told in the order in which they were proposed; effects
        # before failures, so that none is lost if these are raised.
        failures: list[tuple[Trial, Outcome]] = []
        broken: BrokenExecutor | None = None
        for future in [future for future in self._under_way if future in done]:
            trials = self._under_way[future]
            try:
                outcomes = self._outcomes(future, trials)
            except BrokenExecutor as error:
                broken = error
                continue
            for trial, outcome in zip(trials, outcomes, strict=True):
                failed = outcome if outcome.error is not None else self._told(trial, outcome)
                if failed is not None:
                    failures.append((trial, failed))
            del self._under_way[future]
        for trial, failed in failures:
            assert failed.error is not None  # noqa: S101 - for mypy
            self._loop.failed(trial, failed.error, failed.reason)
        if broken is not None:
            note(broken, "its trials are under way: explorer.run evaluates them again")
            raise broken

    def _told(self, trial: Trial, outcome: Outcome) -> Outcome | None:
        """Tell an effect, or return what is wrong with it."""
        loop, explorer = self._loop, self._loop.explorer
        try:  # how many numbers it must have may not have been known when it was asked for
            point = as_point("effect", outcome.effect, explorer.history.effect_dim)  # type: ignore[arg-type]
        except ValueError as error:
            return Outcome.of(error)
        explorer.tell(trial, point)
        loop.succeeded()
        loop.made(trial)
        return None

    def _outcomes(self, future: Future[list[Outcome]], trials: list[Trial]) -> list[Outcome]:
        try:
            outcomes: list[Outcome] = undisturbed(future.result)
        except (BrokenExecutor, CancelledError):
            raise
        except Exception as error:
            if self._workers is not None:  # none can be started
                raise
            return [Outcome.of(error)] * len(trials)  # a worker is lost
        return outcomes


def _evaluated(
    call: Call, commands: Sequence[NDArray[np.float64]], dim: int | None
) -> list[Outcome]:
    """Return what comes of commands in a worker; its loss is the fault of one of them."""
    try:
        outcomes: list[Outcome] = call(commands, dim, calls=len(commands))
    except LostError as lost:
        if len(commands) == 1:
            return [Outcome.of(lost.__cause__ or lost)]
        return [outcome for command in commands for outcome in _evaluated(call, [command], dim)]
    return outcomes
