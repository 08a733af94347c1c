"""Drivers: what lets a strategy propose and learn - in Python, or in the engine.

Both do the same, draw for draw and bit for bit. The engine, in Rust, takes compositions of the
library's own strategies; the driver in Python takes any. Each call of a driver changes the
strategy, the history and the journal together: a Ctrl-C is heard before or after it.
"""

from __future__ import annotations

from time import monotonic
from typing import TYPE_CHECKING, Protocol

from divbandit._core import Engine, NotBuiltInError, Trial, as_point, interruptible, undisturbed
from divbandit.history import History
from divbandit.strategies.base import Starter, Strategy

if TYPE_CHECKING:
    from typing import Literal

    import numpy as np
    from numpy.random import Generator
    from numpy.typing import ArrayLike, NDArray

    from divbandit._core import Journal
    from divbandit.environments import Environment

    EngineName = Literal["auto", "python", "rust"]

#: Where the strategies of an exploration can run.
ENGINES = ("auto", "python", "rust")


class Driver(Protocol):
    """Lets a strategy propose and learn.

    Attributes
    ----------
    strategy : Strategy
        As it runs.
    newest : Trial or None
        The trial that `run` evaluated last.
    """

    strategy: Strategy

    @property
    def newest(self) -> Trial | None:
        """The trial that `run` evaluated last."""

    @property
    def needs_commands(self) -> bool:
        """Whether a strategy may look at the commands of the history."""

    @property
    def estimates(self) -> tuple[float, ...] | None:
        """A bandit's estimates of its strategies."""

    def ask(self) -> Trial:
        """Return the next trial."""

    def tell(self, trial: Trial, effect: ArrayLike) -> None:
        """Record the effect of a pending trial, and let the strategy learn from it."""

    def fail(self, trial: Trial, reason: str) -> None:
        """Let the strategy learn that a pending trial failed."""

    def run(self, environment: Environment, n: int, seconds: float) -> None:
        """Explore for 1 to `n` evaluations, and at most about so many seconds.

        A trial whose evaluation raises stays pending.
        """

    def repeat(self, commands: NDArray[np.float64], effects: NDArray[np.float64]) -> int:
        """Propose and learn as before; return how many commands came out the same."""


def driver_of(
    strategy: Strategy, history: History, journal: Journal, rng: Generator, engine: str
) -> Driver:
    """Return the driver of a strategy: the engine, if it is wanted and possible.

    Examples
    --------
    >>> import numpy as np
    >>> import divbandit as db
    >>> history, journal = db.History(db.Box([0], [1])), db._core.Journal()
    >>> rng = np.random.default_rng(0)
    >>> type(driver_of(db.MotorBabbling(), history, journal, rng, "auto")).__name__
    'RustDriver'
    """
    if engine != "python":
        try:
            return RustDriver(strategy, history, journal, rng)
        except NotBuiltInError as error:
            if engine == "rust":
                where, kind = error.args
                raise ValueError(
                    f'engine "rust" must be given parts of the library only, got {where}, a {kind}'
                ) from None
    return PythonDriver(strategy, history, journal, rng)


def runs_in_rust(strategy: Strategy, environment: Environment) -> bool:
    """Whether the engine takes a strategy.

    Examples
    --------
    >>> import divbandit as db
    >>> runs_in_rust(db.MotorBabbling(), db.PlanarArm(2))
    True
    """
    history = History(environment.motor_space, environment.sensory_space)
    try:
        Engine(strategy, history._log)  # noqa: SLF001 - the engine's
    except NotBuiltInError:
        return False
    except (TypeError, ValueError):  # it cannot explore this environment
        return True
    return True


def check_dim(strategy: Strategy, history: History, dim: int) -> None:
    """Let the strategy check the dimension of the first effect."""
    if history.effect_dim is None:
        strategy.check(history.motor_space, dim, has_goals=False)


class RustDriver:
    """The engine: all strategies run in Rust."""

    def __init__(
        self, strategy: Strategy, history: History, journal: Journal, rng: Generator
    ) -> None:
        self.strategy = strategy
        self._history, self._journal, self._rng = history, journal, rng
        self._log = history._log  # noqa: SLF001 - shared with the engine
        self._engine = Engine(strategy, self._log)

    @property
    def newest(self) -> Trial | None:
        """The trial that was evaluated last by `run`."""
        return self._engine.newest(self._journal)

    @property
    def estimates(self) -> tuple[float, ...] | None:
        """A bandit's estimates of its strategies."""
        return self._engine.estimates

    @property
    def needs_commands(self) -> bool:
        """Whether a strategy may look at the commands of the history."""
        return self._engine.needs_commands

    def ask(self) -> Trial:
        """Return the next trial."""
        return self._engine.ask(self._log, self._journal, self._rng)

    def tell(self, trial: Trial, effect: ArrayLike) -> None:
        """Record the effect of a trial, and let the strategy learn from it."""
        if self._log.effect_dim is None:
            effect = as_point("effect", effect)
            check_dim(self.strategy, self._history, len(effect))
        self._engine.tell(trial, effect, self._log, self._journal)

    def fail(self, trial: Trial, reason: str) -> None:
        """Let the strategy learn that a trial failed."""
        self._engine.fail(trial, reason, self._log, self._journal)

    def run(self, environment: Environment, n: int, seconds: float) -> None:
        """Explore for 1 to `n` evaluations, and at most about so many seconds."""
        if self._log.effect_dim is None:  # the first effect tells its dimension
            trial = self.ask()
            self.tell(trial, environment(trial.command))
            n -= 1
        if n > 0:
            self._engine.run(environment, n, seconds, self._log, self._journal, self._rng)

    def repeat(self, commands: NDArray[np.float64], effects: NDArray[np.float64]) -> int:
        """Propose and learn as before; return how many commands came out the same."""
        return self._engine.repeat(commands, effects, self._log, self._journal, self._rng)


class PythonDriver:
    """The loop in Python, in which a user's strategies, rewards, policies and samplers run too."""

    needs_commands = True

    def __init__(
        self, strategy: Strategy, history: History, journal: Journal, rng: Generator
    ) -> None:
        self._given = strategy
        self._history, self._journal, self._rng = history, journal, rng
        self._log = history._log  # noqa: SLF001 - written here
        self.strategy = Starter(history)(strategy)
        self.newest: Trial | None = None
        # The bandit's estimates when it proposed the pending trials, by number.
        self._believed: dict[int, tuple[float, ...] | None] = {}

    @property
    def estimates(self) -> tuple[float, ...] | None:
        """A bandit's estimates of its strategies."""
        return self.strategy.estimates

    def ask(self) -> Trial:
        """Return the next trial; its `inner` one is what the strategy proposed."""
        return undisturbed(self._ask)

    def _ask(self) -> Trial:
        try:
            proposed = Trial.of(self.strategy.propose(self._history, self._rng))
            number = self._journal.asked
            trial = proposed.given_out(self._checked(proposed), number)
            self._believed[number] = self.strategy.estimates
        except BaseException as error:
            self._journal.refused(interrupted=not isinstance(error, Exception))
            raise
        self._journal.give_out(trial)
        return trial

    def _checked(self, proposed: Trial) -> NDArray[np.float64]:
        """Return a copy of the command, so that a change of the array does not change the log."""
        try:
            return self._history.motor_space.bounds.command(proposed.command)
        except (TypeError, ValueError) as error:
            who = f"proposed by {self._given!r}, path {proposed.path}"
            raise type(error)(f"{error} ({who})") from None

    def tell(self, trial: Trial, effect: ArrayLike) -> None:
        """Record the effect of a trial, and let the strategy learn from it."""
        self._journal.find(trial)
        point = as_point("effect", effect, self._log.effect_dim)
        check_dim(self._given, self._history, len(point))
        undisturbed(self._tell, trial, point)

    def _tell(self, trial: Trial, effect: NDArray[np.float64]) -> None:
        number: int = trial.number  # type: ignore[assignment] # given out
        self._log.record(trial.command, effect, trial.path, self._believed[number])
        del self._believed[number]
        self._journal.told(trial)
        try:
            self.strategy.observe(trial.inner, effect)  # type: ignore[arg-type] # given out
        except BaseException as error:
            self._journal.raised(interrupted=not isinstance(error, Exception))
            raise

    def fail(self, trial: Trial, reason: str) -> None:
        """Let the strategy learn that a trial failed."""
        undisturbed(self._fail, trial, reason)

    def _fail(self, trial: Trial, reason: str) -> None:
        self._journal.failed(trial, reason, len(self._log))
        del self._believed[trial.number]  # type: ignore[arg-type] # given out
        try:
            self.strategy.fail(trial.inner, reason)  # type: ignore[arg-type] # given out
        except BaseException as error:
            self._journal.raised(interrupted=not isinstance(error, Exception))
            raise

    def run(self, environment: Environment, n: int, seconds: float) -> None:
        """Explore for 1 to `n` evaluations, and at most about so many seconds."""
        interruptible(self._run, environment, n, seconds)

    def _run(self, environment: Environment, n: int, seconds: float) -> None:
        end = monotonic() + seconds
        for _ in range(n):
            trial = self.newest = self.ask()
            self.tell(trial, environment(trial.command))
            if monotonic() >= end:
                break

    def repeat(self, commands: NDArray[np.float64], effects: NDArray[np.float64]) -> int:
        """Propose and learn as before; return how many commands came out the same."""
        for row, (command, effect) in enumerate(zip(commands, effects, strict=True)):
            trial = self.ask()
            if trial.command.tobytes() != command.tobytes():
                return row
            self.tell(trial, effect)
        return len(commands)
