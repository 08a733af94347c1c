"""running: the loop - propose, evaluate, learn - with all that can come between.

There are two ways to evaluate: one trial after the other in this thread, where the engine makes as
many steps at a time as nothing else is due; or several at a time, through an executor.
"""

from __future__ import annotations

import math
import sys
from collections.abc import Iterable
from concurrent.futures import BrokenExecutor, CancelledError, Future
from contextlib import ExitStack, contextmanager, suppress
from dataclasses import dataclass
from queue import Empty, SimpleQueue
from typing import TYPE_CHECKING, Literal

from divbandit._checks import one_of, positive, whole
from divbandit._core import as_point, undisturbed
from divbandit.callbacks.protocol import check_callback
from divbandit.environments import Environment
from divbandit.exploration.evaluating import Outcome, evaluate, reason_of
from divbandit.exploration.saved import Checkpoint
from divbandit.exploration.watching import Every, Watcher, period
from divbandit.exploration.workers import Workers

if TYPE_CHECKING:
    import os
    from collections.abc import Iterator
    from concurrent.futures import Executor

    from divbandit._core import Trial
    from divbandit.callbacks.protocol import CallbackLike
    from divbandit.exploration.explorer import Explorer

#: Seconds between checks while waiting: not every system lets Ctrl-C interrupt a long wait.
_GLANCE = 0.2


#: What to do if an evaluation fails.
OnError = Literal["raise", "record"]


@dataclass(frozen=True)
class Options:
    """How `Explorer.run` evaluates: its arguments, and checks of them."""

    jobs: int | None = None
    executor: Executor | None = None
    in_flight: int | None = None
    batch: int = 1
    timeout: float | None = None
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
            positive("timeout", self.timeout)
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
            if not callable(getattr(self.executor, "submit", None)):
                kind = type(self.executor).__name__
                raise TypeError(f"executor must be a concurrent.futures.Executor, got {kind}")
            if self.jobs is not None:
                raise ValueError(f"jobs and executor must not both be given, got jobs={self.jobs}")
            if self.in_flight is None:
                raise ValueError("in_flight must be given together with an executor, got None")
        elif self.jobs is None and self.in_flight is not None:
            raise ValueError(
                f"in_flight must be given with an executor or jobs alone, got {self.in_flight!r}"
            )


def run(explorer: Explorer, environment: Environment, n: int, options: Options) -> None:
    """Let the explorer make `n` evaluations of a black box, or until a callback stops it.

    Trials that are under way are evaluated first.
    """
    check_environment(environment)
    whole("n", n, low=1)
    callbacks: list[CallbackLike] = list(options.callbacks)
    if options.checkpoint is not None:
        callbacks.append(Checkpoint(options.checkpoint, options.every))
    with _holding(explorer), ExitStack() as stack:
        loop = _Loop(explorer, environment, n, options)
        for callback in callbacks:
            loop.watchers.append(stack.enter_context(Watcher(callback, explorer, n)))
        stack.callback(loop.evaluator.close)
        loop.evaluator.start()
        while loop.left > 0 and not loop.stopped:
            loop.advance()
        loop.evaluator.finish()
    history = explorer.history
    if len(history) == 0 < len(history.failures):
        with _holding(explorer):
            reason = history.failures[-1].reason
            raise RuntimeError(f"all {len(history.failures)} evaluations failed, last: {reason}")


def check_environment(environment: object) -> None:
    """Raise a TypeError unless this is a black box with its spaces."""
    if not isinstance(environment, Environment):
        raise TypeError(
            "environment must be callable and have motor_space and sensory_space "
            f"(FunctionEnvironment makes one of a function), got {type(environment).__name__}"
        )


class _Loop:
    """A run of an explorer."""

    def __init__(
        self, explorer: Explorer, environment: Environment, n: int, options: Options
    ) -> None:
        self.explorer, self._options = explorer, options
        self._end = explorer.evaluations + n
        self.watchers: list[Watcher] = []
        self.stopped = False
        self._failed = 0  # in a row
        self.evaluator: _Serial | _Parallel
        if options.jobs is None and options.executor is None and options.batch == 1:
            self.evaluator = _Serial(self, environment)
        else:
            self.evaluator = _Parallel(self, environment, options)

    @property
    def left(self) -> int:
        """How many evaluations are to be made."""
        return self._end - self.explorer.evaluations

    def advance(self) -> None:
        """Go on until something is due."""
        n = min([self.left, *(watcher.trials for watcher in self.watchers)])
        seconds = min([math.inf, *(watcher.seconds for watcher in self.watchers)])
        self.evaluator.advance(int(n), seconds)

    def made(self, trial: Trial, count: int = 1) -> None:
        """Tell the callbacks of evaluations; the trial is the last of them."""
        self.count(count)
        for watcher in self.watchers:
            self.stopped |= watcher.looks(trial)

    def count(self, count: int) -> None:
        """Count evaluations on which nothing was due."""
        for watcher in self.watchers:
            watcher.trials -= count

    def succeeded(self) -> None:
        """Note that an evaluation gave an effect."""
        self._failed = 0

    def failed(self, trial: Trial, error: BaseException, reason: str) -> None:
        """Record that the evaluation of a trial failed, or raise what it raised."""
        if isinstance(error, KeyboardInterrupt):  # another process heard Ctrl-C
            raise error
        if self._options.on_error == "raise":
            cause = None if isinstance(error, Exception) else error
            if cause is not None:  # not to end the program
                error = RuntimeError(f"the environment must return an effect, got {reason}")
            _note(error, f"raised by the evaluation of the command {trial.command.tolist()}")
            raise error from (error.__cause__ if cause is None else cause)
        self.explorer.fail(trial, reason)
        self._failed += 1
        self.made(trial)
        if self._failed == self._options.max_failures:
            raise RuntimeError(
                f"evaluations must not fail {self._failed} times in a row (max_failures), "
                f"last: {reason}"
            ) from (error if isinstance(error, Exception) else None)


class _Serial:
    """One trial after the other, in this thread."""

    def __init__(self, loop: _Loop, environment: Environment) -> None:
        self._loop, self._environment = loop, environment
        self._driver = loop.explorer._driver  # noqa: SLF001 - its loop

    def advance(self, n: int, seconds: float) -> None:
        """Make 1 to n evaluations."""
        loop, explorer = self._loop, self._loop.explorer
        known = len(explorer.history)
        pending = explorer.open_trials
        try:
            if pending:
                explorer.tell(pending[0], self._environment(pending[0].command))
            else:
                self._driver.run(self._environment, n, seconds)
        except (Exception, SystemExit) as error:
            made = len(explorer.history) - known
            if made > 0:
                loop.succeeded()
            still = explorer.open_trials
            if not still or (pending and still[0] is not pending[0]):
                raise  # the strategy's own
            loop.count(made)
            loop.failed(still[0], error, reason_of(error))
        else:
            loop.succeeded()
            newest = pending[0] if pending else self._driver.newest
            if newest is not None:
                loop.made(newest, len(explorer.history) - known)

    def start(self) -> None:
        """Nothing is to be started."""

    finish = close = start


class _Parallel:
    """Several trials at a time, told as their effects come in.

    Ctrl-C must not come while a lock of an executor or a future is taken: it would never be free
    again, and the executor never end.
    """

    def __init__(self, loop: _Loop, environment: Environment, options: Options) -> None:
        self._loop, self._environment, self._options = loop, environment, options
        self._most = options.in_flight or options.jobs or 1
        self._under_way: dict[Future[list[Outcome]], list[Trial]] = {}
        self._ready: SimpleQueue[Future[list[Outcome]]] = SimpleQueue()
        self._left_over = list(loop.explorer.open_trials)
        self._workers = (
            None if options.jobs is None else Workers(environment, options.jobs, options.timeout)
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
            future = undisturbed(self._workers.submit, commands, dim)
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
            _note(broken, "its trials are under way: explorer.run evaluates them again")
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


def _note(error: BaseException, text: str) -> None:
    if sys.version_info >= (3, 11):
        error.add_note(text)


@contextmanager
def _holding(explorer: Explorer) -> Iterator[None]:
    """Attach the explorer, which holds all that was observed, to what is raised."""
    try:
        yield
    except BaseException as error:
        if getattr(error, "explorer", None) is not explorer:
            error.explorer = explorer  # type: ignore[attr-defined]
            _note(
                error,
                f"the explorer holds {explorer.evaluations} evaluations: error.explorer.result() "
                "returns them, error.explorer.run(environment, n) goes on",
            )
        raise
