"""running: the loop - propose, evaluate, learn - with all that can come between.

There are two ways to evaluate: one trial after the other in this thread, where the engine makes as
many steps at a time as nothing else is due; or several at a time, through an executor.
"""

from __future__ import annotations

import math
from contextlib import ExitStack, contextmanager
from typing import TYPE_CHECKING

from divbandit._checks import whole
from divbandit._portable import reason_of
from divbandit.exploration.evaluating import note
from divbandit.exploration.options import check_environment
from divbandit.exploration.parallel import Parallel
from divbandit.exploration.saved import Checkpoint
from divbandit.exploration.watching import Watcher

if TYPE_CHECKING:
    from collections.abc import Iterator

    from divbandit._core import Trial
    from divbandit.callbacks.protocol import CallbackLike
    from divbandit.environments import Environment
    from divbandit.exploration.explorer import Explorer
    from divbandit.exploration.options import Options


def run(explorer: Explorer, environment: Environment, n: int, options: Options) -> None:
    """Let the explorer make `n` evaluations of a black box, or until a callback stops it.

    Trials that are under way are evaluated first.
    """
    check_environment(environment)
    whole("n", n, low=0)
    callbacks: list[CallbackLike] = list(options.callbacks)
    if options.checkpoint is not None:
        callbacks.append(Checkpoint(options.checkpoint, options.every))
    with _holding(explorer), ExitStack() as stack:
        loop = Loop(explorer, environment, n, options)
        for callback in callbacks:
            loop.watchers.append(stack.enter_context(Watcher(callback, explorer, n)))
        stack.callback(loop.evaluator.close)
        if loop.left > 0:
            loop.evaluator.start()
        while loop.left > 0 and not loop.stopped:
            loop.advance()
        loop.evaluator.finish()
    history = explorer.history
    if len(history) == 0 < len(history.failures):
        with _holding(explorer):
            reason = history.failures[-1].reason
            raise RuntimeError(f"all {len(history.failures)} evaluations failed, last: {reason}")


class Loop:
    """A run of an explorer."""

    def __init__(
        self, explorer: Explorer, environment: Environment, n: int, options: Options
    ) -> None:
        self.explorer, self._options = explorer, options
        self._end = explorer.evaluations + n
        self.watchers: list[Watcher] = []
        self.stopped = False
        self._failed = 0  # in a row
        self.evaluator: _Serial | Parallel
        if options.jobs is None and options.executor is None and options.batch == 1:
            self.evaluator = _Serial(self, environment)
        else:
            self.evaluator = Parallel(self, environment, options)

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
            note(error, f"raised by the evaluation of the command {trial.command.tolist()}")
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

    def __init__(self, loop: Loop, environment: Environment) -> None:
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


@contextmanager
def _holding(explorer: Explorer) -> Iterator[None]:
    """Attach the explorer, which holds all that was observed, to what is raised."""
    try:
        yield
    except BaseException as error:
        if getattr(error, "explorer", None) is not explorer:
            error.explorer = explorer  # type: ignore[attr-defined]
            note(
                error,
                f"the explorer holds {explorer.evaluations} evaluations: error.explorer.result() "
                "returns them, error.explorer.run(environment, n) goes on",
            )
        raise
