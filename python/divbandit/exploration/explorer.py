"""Explorer: ask for a command, evaluate it anywhere, tell the effect."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING, overload

from divbandit._checks import generator, one_of, truth, whole
from divbandit._core import Trial, as_point
from divbandit.exploration import saved
from divbandit.exploration.drivers import ENGINES, RustDriver, driver_of
from divbandit.exploration.journal import Event, Journal
from divbandit.exploration.result import Exploration
from divbandit.history import Failure, History
from divbandit.strategies.base import Strategy

if TYPE_CHECKING:
    import os
    from collections.abc import Callable

    import numpy as np
    from numpy.typing import ArrayLike, NDArray

    from divbandit._checks import Rng
    from divbandit.box import BoxLike
    from divbandit.environments import Environment
    from divbandit.exploration.drivers import EngineName

_NOT_MINE = "trial must be pending: asked for by this explorer, not told and not failed"


class Explorer:
    """An exploration that is driven from outside: ask for trials, tell their effects.

    Any number of trials may be under way, and they may be told in any order, or fail. The history
    is in the order of telling, and so are gains: an effect's gain is what it adds to all that was
    told before it.

    Parameters
    ----------
    strategy : Strategy
        Never changed: the running state is started from it.
    motor_space : Box or object with ``low`` and ``high``
        M, the box of all motor commands.
    sensory_space : Box or object with ``low`` and ``high``, optional
        A box in S to draw goals from.
    rng : None, int, SeedSequence or Generator
        All randomness comes from it; a Generator is drawn from, not copied.
    past : Exploration, optional
        An earlier run, whose commands and effects are added as `add_past` does.
    engine : {"auto", "python", "rust"}
        Where strategies run, as in `explore`.

    Attributes
    ----------
    history : History
        All that was told so far.
    rng : numpy.random.Generator
        The source of all randomness.

    Raises
    ------
    TypeError, ValueError
        If an argument is not what it must be, or the strategy cannot explore these spaces.

    Examples
    --------
    >>> import divbandit as db
    >>> arm = db.PlanarArm(20)
    >>> explorer = db.Explorer(db.GoalBabbling(0.05), arm.motor_space, arm.sensory_space, rng=0)
    >>> for _ in range(10):
    ...     trial = explorer.ask()
    ...     explorer.tell(trial, arm(trial.command))
    >>> len(explorer.history)
    10
    """

    def __init__(
        self,
        strategy: Strategy,
        motor_space: BoxLike,
        sensory_space: BoxLike | None = None,
        *,
        rng: Rng = None,
        past: Exploration | None = None,
        engine: EngineName = "auto",
    ) -> None:
        self._prepare(strategy, motor_space, sensory_space, rng, engine)
        if past is not None:
            if not isinstance(past, Exploration):
                raise TypeError(f"past must be an Exploration, got {type(past).__name__}")
            self.add_past(past.commands, past.effects)

    @classmethod
    def for_run(
        cls,
        strategy: Strategy,
        motor_space: BoxLike,
        sensory_space: BoxLike | None,
        *,
        rng: Rng,
        engine: EngineName,
        keep_commands: bool,
    ) -> Explorer:
        """Return an explorer that may discard commands if no strategy needs them."""
        explorer = cls.__new__(cls)
        explorer._prepare(  # noqa: SLF001 - a constructor
            strategy, motor_space, sensory_space, rng, engine, keep_commands=keep_commands
        )
        return explorer

    def _prepare(
        self,
        strategy: Strategy,
        motor_space: BoxLike,
        sensory_space: BoxLike | None,
        rng: Rng,
        engine: str,
        *,
        keep_commands: bool = True,
    ) -> None:
        if not isinstance(strategy, Strategy):
            raise TypeError(f"strategy must be a Strategy, got {type(strategy).__name__}")
        one_of("engine", engine, ENGINES)
        history = History(motor_space, sensory_space)
        strategy.check(
            history.motor_space, history.effect_dim, has_goals=history.sensory_space is not None
        )
        self.rng = generator(rng)
        self.history = history
        self._given = strategy
        driver = self._driver = driver_of(strategy, history, engine)
        kept = keep_commands or driver.needs_commands
        history._log.begin(kept, len(driver.estimates or ()))  # noqa: SLF001 - the explorer's
        history._is_explorers = True  # noqa: SLF001 - nothing else writes to it
        self._journal = Journal(self.rng)
        self._asked = 0
        #: The trials under way and the commands they were given out with, by number.
        self._open: dict[int, tuple[Trial, NDArray[np.float64]]] = {}
        self._dim_is_checked = history.effect_dim is not None

    @property
    def strategy(self) -> Strategy:
        """The strategy; if it is user-defined, the explorer's copy, with what it has learned."""
        return self._driver.strategy

    @property
    def estimates(self) -> tuple[float, ...] | None:
        """A bandit's estimates of its strategies; None for any other strategy."""
        return self._driver.estimates

    @property
    def open_trials(self) -> tuple[Trial, ...]:
        """The trials that are under way, in the order in which they were given out."""
        return tuple(trial for trial, _ in self._open.values())

    @overload
    def ask(self) -> Trial: ...
    @overload
    def ask(self, n: int) -> list[Trial]: ...
    def ask(self, n: int | None = None) -> Trial | list[Trial]:
        """Return a trial, or many: evaluate its command, then tell its effect.

        Parameters
        ----------
        n : int, optional
            How many trials to return, at least 1: the same as `n` calls of ``ask()``.

        Returns
        -------
        Trial, or list of Trial
            With a read-only ``command`` of shape (m,), the ``goal`` if the strategy has one,
            and the ``path`` of who proposed it.

        Raises
        ------
        TypeError, ValueError
            If the strategy's proposal is not a point of the motor space. The history is then as it
            was, and no trial was given out; the generator and the strategy have moved on.

        Examples
        --------
        >>> import divbandit as db
        >>> explorer = db.Explorer(db.MotorBabbling(), db.Box([0, 0], [1, 1]), rng=0)
        >>> explorer.ask().command
        array([0.63696169, 0.26978671])
        >>> len(explorer.ask(3))
        3
        """
        if n is not None:
            return [self.ask() for _ in range(whole("n", n, low=1))]
        try:
            trial = self._driver.ask(self._asked, self.rng)
        except BaseException as error:
            self._journal.note(Event.ASK, 0, raised=error)
            raise
        self._journal.note(Event.ASK, 0)
        return self._give_out(trial)

    def _give_out(self, trial: Trial) -> Trial:
        """Note that a trial is under way."""
        self._open[self._asked] = (trial, trial.command)
        self._asked += 1
        return trial

    @overload
    def tell(self, trial: Trial, effect: ArrayLike) -> None: ...
    @overload
    def tell(self, trial: Sequence[Trial], effect: ArrayLike) -> None: ...
    def tell(self, trial: Trial | Sequence[Trial], effect: ArrayLike) -> None:
        """Record the effect of a trial, or of many, and let the strategy learn from it.

        Parameters
        ----------
        trial : Trial, or sequence of n Trial
            Returned by `ask`, and neither told nor failed yet.
        effect : array_like, shape (s,) or (n, s)
            Effects of many are told in order: the same as `n` calls.

        Raises
        ------
        TypeError, ValueError
            If a trial is not a pending one of this explorer, or an effect is not finite or of the
            wrong length; nothing is recorded then, and the trials can still be told.
        Exception
            What a user-defined strategy raises when it observes; that effect, and those before
            it, are then recorded.

        Examples
        --------
        >>> import divbandit as db
        >>> explorer = db.Explorer(db.MotorBabbling(), db.Box([0], [1]), rng=0)
        >>> trial = explorer.ask()
        >>> explorer.tell(trial, [3.0])
        >>> explorer.tell(trial, [3.0])
        Traceback (most recent call last):
            ...
        ValueError: trial must be pending: asked for by this explorer, not told and not failed
        """
        if not isinstance(trial, Trial):
            self._tell_each(trial, effect)
            return
        self._find(trial)
        self._record(trial, as_point("effect", effect, self.history.effect_dim))

    def _record(self, trial: Trial, effect: NDArray[np.float64]) -> None:
        """Record an effect that is right for a trial that is under way."""
        if not self._dim_is_checked:
            self._check_dim(len(effect))
        number: int = trial.number  # type: ignore[assignment] # given out
        _, command = self._open.pop(number)
        try:
            self._driver.tell(trial, command, effect)
        except BaseException as error:
            self._journal.note(Event.TELL, number, raised=error)
            raise
        self._journal.note(Event.TELL, number)

    def _find(self, trial: object) -> int:
        """Return the number of a trial that is under way, or say that it is not."""
        if not isinstance(trial, Trial):
            raise TypeError(f"trial must be a Trial, got {type(trial).__name__}")
        number = trial.number
        if number is None or number not in self._open or self._open[number][0] is not trial:
            raise ValueError(_NOT_MINE)
        return number

    def _check_dim(self, dim: int) -> None:
        """Let the strategy check the dimension of the first effect."""
        self._given.check(self.history.motor_space, dim, has_goals=False)
        self._dim_is_checked = True

    def _tell_each(self, trials: Sequence[Trial], effects: ArrayLike) -> None:
        """Check many trials and effects, then tell one after the other."""
        if not isinstance(trials, Sequence):
            kind = type(trials).__name__
            raise TypeError(f"trial must be a Trial, or a sequence of them, got {kind}")
        if len({self._find(trial) for trial in trials}) < len(trials):
            raise ValueError("trial must hold each trial once")
        try:
            rows = list(effects)  # type: ignore[arg-type]
        except TypeError:
            raise TypeError(f"effect must be a list of effects, got {effects!r}") from None
        if len(rows) != len(trials):
            raise ValueError(f"effect must have shape ({len(trials)}, s), got {len(rows)} rows")
        dim = self.history.effect_dim
        points = []
        for index, row in enumerate(rows):
            points.append(as_point(f"effect[{index}]", row, dim))
            dim = len(points[-1])
        for trial, point in zip(trials, points, strict=True):
            self._record(trial, point)

    def fail(self, trial: Trial, reason: str) -> None:
        """Record that the evaluation of a trial failed: the robot fell over.

        The budget is spent, and there is no effect: neither the history's effects nor any measure
        change. It is recorded in ``history.failures``. A bandit rewards it with 0.

        Parameters
        ----------
        trial : Trial
            Returned by `ask`, and neither told nor failed yet.
        reason : str
            What went wrong, for the log.

        Raises
        ------
        TypeError, ValueError
            If the trial is not a pending one of this explorer, or the reason is not a string;
            nothing is recorded then.
        Exception
            What a user-defined strategy raises when it learns of it; that is then recorded.

        Examples
        --------
        >>> import divbandit as db
        >>> explorer = db.Explorer(db.MotorBabbling(), db.Box([0], [1]), rng=0)
        >>> explorer.fail(explorer.ask(), "the robot fell over")
        >>> len(explorer.history), len(explorer.history.failures)
        (0, 1)
        """
        if not isinstance(reason, str):
            raise TypeError(f"reason must be a string, got {type(reason).__name__}")
        number = self._find(trial)
        _, command = self._open.pop(number)
        failure = Failure(command, reason, trial.path, len(self.history))
        self.history._failures.append(failure)  # noqa: SLF001 - its log
        self._journal.failed.append(number)
        try:
            self._driver.fail(trial, reason)
        except BaseException as error:
            self._journal.note(Event.FAIL, number, raised=error)
            raise
        self._journal.note(Event.FAIL, number)

    def add_past(self, commands: ArrayLike, effects: ArrayLike) -> None:
        """Record evaluations made elsewhere: strategies see them, none is rewarded.

        Parameters
        ----------
        commands : array_like, shape (n, m)
        effects : array_like, shape (n, s)

        Raises
        ------
        TypeError, ValueError
            If a command is not a point of the motor space, or an effect is not finite or of another
            dimension than those before; nothing is recorded then.

        Examples
        --------
        >>> import divbandit as db
        >>> explorer = db.Explorer(db.GoalBabbling(), db.Box([0], [1]), db.Box([0], [9]), rng=0)
        >>> explorer.add_past([[0.5], [0.25]], [[7.0], [8.0]])
        >>> len(explorer.history)
        2
        """
        log = self.history._log  # noqa: SLF001 - the explorer writes it
        points, dim = log.checked(commands, effects)
        if len(points[0]) == 0:  # nothing happened, and no dimension is known
            return
        if not self._dim_is_checked and dim is not None:
            self._check_dim(dim)
        log.extend(points)
        self._journal.note(Event.PAST, len(points[0]))

    def _run(
        self, environment: Environment, n: int, between: Callable[[], object] | None = None
    ) -> None:
        """Explore an environment for `n` evaluations; what was observed stays, whatever ends it."""
        driver = self._driver
        if not isinstance(driver, RustDriver):
            self._step_by_step(environment, n, between)
            return
        if not self._dim_is_checked:  # the first effect tells its dimension
            self._step_by_step(environment, 1, between)
            n -= 1
        known = len(self.history)
        try:
            driver.run(environment, n, self.rng, between)
        finally:
            made = len(self.history) - known
            refused = ValueError() if driver.refused else None
            self._journal.note(Event.RUN, made, raised=refused)
            self._asked += made
            if driver.asked > self._asked:  # a trial whose evaluation did not end
                self._journal.note(Event.ASK, 0)
                self._give_out(driver.under_way(self._asked))

    def _step_by_step(
        self, environment: Environment, n: int, between: Callable[[], object] | None
    ) -> None:
        """Ask and tell `n` times."""
        for _ in range(n):
            trial = self.ask()
            self.tell(trial, environment(trial.command))
            if between is not None:
                between()

    def save(self, path: str | os.PathLike[str]) -> None:
        """Write all that is needed to resume to a file, replacing it whole or not at all.

        The file is NumPy's ``npz``; nothing in it is pickled. It holds what was asked and told,
        and the generator's state at the beginning: all else follows from these.

        Parameters
        ----------
        path : str or path
            Used as it is: no ending is added.

        Raises
        ------
        ValueError
            If the generator is not one of NumPy's own, whose state can be written, or commands were
            not kept.
        OSError
            If the file cannot be written.

        Examples
        --------
        >>> import os, tempfile
        >>> import divbandit as db
        >>> explorer = db.Explorer(db.MotorBabbling(), db.Box([0], [1]), rng=0)
        >>> trial = explorer.ask()
        >>> with tempfile.TemporaryDirectory() as folder:
        ...     explorer.save(os.path.join(folder, "run"))
        ...     again = db.Explorer.load(os.path.join(folder, "run"))
        >>> again.open_trials[0].command == trial.command
        array([ True])
        >>> again.ask().command == explorer.ask().command
        array([ True])
        """
        commands = {number: command for number, (_, command) in self._open.items()}
        saved.write(path, self._given, self.history, self._journal, commands, self.rng)

    @classmethod
    def load(cls, path: str | os.PathLike[str], strategy: Strategy | None = None) -> Explorer:
        """Read a saved explorer, which continues bit for bit as the original would have.

        All that was asked and told is repeated, with the generator as it was at the beginning; each
        command must come out the same. So a user-defined strategy must depend on its observations
        and the generator alone, and the generator must not have been drawn from elsewhere.

        Parameters
        ----------
        path : str or path
        strategy : Strategy, optional
            One equal to the explorer's. It must be given if that has user-defined parts; strategies
            of the library are in the file.

        Returns
        -------
        Explorer
            With its own generator, in ``rng``, and the trials that were under way in
            ``open_trials``.

        Raises
        ------
        TypeError
            If `strategy` is not a Strategy.
        ValueError
            If the file is truncated, was not written by `save` or by another version of it,
            names no strategy and none is given, or the strategy proposes other commands than
            those in the file.
        OSError
            If the file cannot be read.

        Examples
        --------
        >>> import divbandit as db
        >>> db.Explorer.load("missing")
        Traceback (most recent call last):
            ...
        FileNotFoundError: [Errno 2] No such file or directory: 'missing'
        """
        if strategy is not None and not isinstance(strategy, Strategy):
            raise TypeError(f"strategy must be a Strategy, got {type(strategy).__name__}")
        return saved.read(path, cls, strategy)

    def result(self, *, keep_commands: bool = True) -> Exploration:
        """Return all that was told so far as an Exploration, to plot or save.

        Parameters
        ----------
        keep_commands : bool
            False leaves the motor commands out.

        Examples
        --------
        >>> import divbandit as db
        >>> explorer = db.Explorer(db.MotorBabbling(), db.Box([0], [1]), rng=0)
        >>> explorer.tell(explorer.ask(), [3.0])
        >>> explorer.result().effects
        array([[3.]])
        """
        truth("keep_commands", keep_commands)
        return Exploration.of(self.history, keep_commands=keep_commands)

    def __repr__(self) -> str:
        return f"<Explorer of {self._given!r} after {len(self.history)} evaluations>"
