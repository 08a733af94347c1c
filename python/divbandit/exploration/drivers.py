"""Drivers: what lets a strategy propose and learn - in Python, or in the engine.

Both do the same, draw for draw and bit for bit. The engine, in Rust, takes compositions of the
library's own strategies; the driver in Python takes any.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Protocol

from divbandit._core import Engine, NotBuiltInError, Trial
from divbandit.strategies.base import Starter, Strategy

if TYPE_CHECKING:
    from collections.abc import Callable
    from typing import Literal

    import numpy as np
    from numpy.random import Generator
    from numpy.typing import NDArray

    from divbandit.environments import Environment
    from divbandit.history import History

    EngineName = Literal["auto", "python", "rust"]

#: Where the strategies of an exploration can run.
ENGINES = ("auto", "python", "rust")


class Driver(Protocol):
    """Lets a strategy propose and learn."""

    strategy: Strategy

    @property
    def needs_commands(self) -> bool:
        """Whether a strategy may look at the commands of the history."""

    @property
    def estimates(self) -> tuple[float, ...] | None:
        """A bandit's estimates of its strategies."""

    def ask(self, number: int, rng: Generator) -> Trial:
        """Return the next trial, which is to have this number."""

    def tell(self, trial: Trial, command: NDArray[np.float64], effect: NDArray[np.float64]) -> None:
        """Record the effect of a trial, and let the strategy learn from it."""

    def fail(self, trial: Trial, reason: str) -> None:
        """Let the strategy learn that a trial failed."""


def driver_of(strategy: Strategy, history: History, engine: str) -> Driver:
    """Return the driver of a strategy: the engine, if it is wanted and possible.

    Examples
    --------
    >>> import divbandit as db
    >>> history = db.History(db.Box([0], [1]))
    >>> type(driver_of(db.MotorBabbling(), history, "auto")).__name__
    'RustDriver'
    """
    if engine != "python":
        try:
            return RustDriver(strategy, history)
        except NotBuiltInError as error:
            if engine == "rust":
                where, kind = error.args
                raise ValueError(
                    f'engine "rust" must be given parts of the library only, got {where}, a {kind}'
                ) from None
    return PythonDriver(strategy, history)


class RustDriver:
    """The engine: all strategies run in Rust."""

    def __init__(self, strategy: Strategy, history: History) -> None:
        self.strategy = strategy
        self._log = history._log  # noqa: SLF001 - shared with the engine
        self._engine = Engine(strategy, self._log)

    @property
    def estimates(self) -> tuple[float, ...] | None:
        """A bandit's estimates of its strategies."""
        return self._engine.estimates

    @property
    def needs_commands(self) -> bool:
        """Whether a strategy may look at the commands of the history."""
        return self._engine.needs_commands

    @property
    def refused(self) -> bool:
        """Whether the newest effect was recorded, but could not be rewarded."""
        return self._engine.refused

    @property
    def asked(self) -> int:
        """How many trials were asked for."""
        return self._engine.asked

    def ask(self, number: int, rng: Generator) -> Trial:
        """Return the next trial."""
        del number  # the engine counts them too
        return self._engine.ask(self._log, rng)

    def under_way(self, number: int) -> Trial:
        """Return a trial that `run` asked for, and whose evaluation it did not finish."""
        return self._engine.proposed(number)

    def tell(self, trial: Trial, command: NDArray[np.float64], effect: NDArray[np.float64]) -> None:
        """Record the effect of a trial, and let the strategy learn from it."""
        del command
        self._engine.tell(trial.number, self._log, effect)  # type: ignore[arg-type] # given out

    def fail(self, trial: Trial, reason: str) -> None:
        """Let the strategy learn that a trial failed."""
        del reason
        self._engine.fail(trial.number)  # type: ignore[arg-type] # given out

    def run(
        self,
        environment: Environment,
        n: int,
        rng: Generator,
        between: Callable[[], object] | None,
    ) -> None:
        """Explore for `n` evaluations."""
        self._engine.run(environment, self._log, n, rng, between)


class PythonDriver:
    """The loop in Python, in which a user's strategies, rewards, policies and samplers run too."""

    needs_commands = True

    def __init__(self, strategy: Strategy, history: History) -> None:
        self._history, self._log = history, history._log  # noqa: SLF001 - written here
        self.strategy = Starter(history)(strategy)
        # The bandit's estimates when it proposed the pending trials, by number.
        self._believed: dict[int, tuple[float, ...] | None] = {}

    @property
    def estimates(self) -> tuple[float, ...] | None:
        """A bandit's estimates of its strategies."""
        return self.strategy.estimates

    def ask(self, number: int, rng: Generator) -> Trial:
        """Return the next trial; its `inner` one is what the strategy proposed."""
        proposed = Trial.of(self.strategy.propose(self._history, rng))
        trial = proposed.given_out(self._checked(proposed), number)
        self._believed[number] = self.strategy.estimates
        return trial

    def _checked(self, proposed: Trial) -> NDArray[np.float64]:
        """Return a copy of the command, so that a change of the array does not change the log."""
        try:
            return self._history.motor_space.bounds.command(proposed.command)
        except (TypeError, ValueError) as error:
            who = f"proposed by {self.strategy!r}, path {proposed.path}"
            raise type(error)(f"{error} ({who})") from None

    def tell(self, trial: Trial, command: NDArray[np.float64], effect: NDArray[np.float64]) -> None:
        """Record the effect of a trial, and let the strategy learn from it."""
        self._log.record(command, effect, trial.path, self._believed.pop(trial.number))  # type: ignore[arg-type]
        self.strategy.observe(trial.inner, effect)  # type: ignore[arg-type]

    def fail(self, trial: Trial, reason: str) -> None:
        """Let the strategy learn that a trial failed."""
        del self._believed[trial.number]  # type: ignore[arg-type]
        self.strategy.fail(trial.inner, reason)  # type: ignore[arg-type]
