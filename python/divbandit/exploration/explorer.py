"""Explorer: ask for a command, evaluate it anywhere, tell the effect."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING, overload

from divbandit._checks import generator, one_of, truth, whole
from divbandit._core import Journal, Trial, as_point, undisturbed
from divbandit.bandits.rewards import Gain
from divbandit.exploration import running, saved
from divbandit.exploration.drivers import ENGINES, check_dim, driver_of
from divbandit.exploration.options import Options
from divbandit.exploration.result import Exploration
from divbandit.history import History, counted
from divbandit.strategies.base import Strategy

if TYPE_CHECKING:
    import os
    from collections.abc import Iterable
    from concurrent.futures import Executor

    import numpy as np
    from numpy.random import Generator
    from numpy.typing import ArrayLike, NDArray

    from divbandit._checks import Rng
    from divbandit.box import BoxLike
    from divbandit.callbacks.protocol import CallbackLike
    from divbandit.environments import Environment
    from divbandit.exploration.drivers import EngineName
    from divbandit.exploration.options import OnError
    from divbandit.exploration.watching import Every
    from divbandit.measures import Measure

    Past = Exploration | tuple[ArrayLike, ArrayLike]


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
    past : Exploration, or (commands, effects), optional
        Earlier evaluations, which are added as `add_past` does.
    engine : {"auto", "python", "rust"}
        Where strategies run, as in `explore`.
    keep_commands : bool
        False discards commands if no strategy needs them; the explorer cannot be saved then.

    Attributes
    ----------
    history : History
        All that was told so far.

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
        past: Past | None = None,
        engine: EngineName = "auto",
        keep_commands: bool = True,
    ) -> None:
        if not isinstance(strategy, Strategy):
            raise TypeError(f"strategy must be a Strategy, got {type(strategy).__name__}")
        one_of("engine", engine, ENGINES)
        truth("keep_commands", keep_commands)
        history = self.history = History(motor_space, sensory_space)
        strategy.check(
            history.motor_space, history.effect_dim, has_goals=history.sensory_space is not None
        )
        self._rng = generator(rng)
        self._given = strategy
        history._explored_by = _names_and_measure(strategy)  # noqa: SLF001 - for its result
        self._journal = history._journal = Journal()  # noqa: SLF001 - nothing else writes to it
        self._began = saved.state_of(self._rng)
        driver = self._driver = driver_of(strategy, history, self._journal, self._rng, engine)
        kept = keep_commands or driver.needs_commands
        history._log.begin(kept, len(driver.estimates or ()))  # noqa: SLF001 - the explorer's
        #: The checkpoint that is being written.
        self._growing: saved.Growing | None = None
        if past is not None:
            self.add_past(*_commands_and_effects(past))

    @property
    def rng(self) -> Generator:
        """The source of all randomness."""
        return self._rng

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
        return tuple(self._journal.open)

    @property
    def evaluations(self) -> int:
        """How many trials were told or have failed: those of the past are not counted."""
        return self._journal.asked - len(self._journal.open)

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
        return self._driver.ask()

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
        if isinstance(trial, Trial):
            self._driver.tell(trial, effect)
        else:
            self._tell_each(trial, effect)

    def _tell_each(self, trials: Sequence[Trial], effects: ArrayLike) -> None:
        """Check many trials and effects, then tell one after the other."""
        if not isinstance(trials, Sequence):
            kind = type(trials).__name__
            raise TypeError(f"trial must be a Trial, or a sequence of them, got {kind}")
        if len({self._pending(trial) for trial in trials}) < len(trials):
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
            self._driver.tell(trial, point)

    def _pending(self, trial: object) -> int:
        """Return the number of a trial that is under way, or say that it is not."""
        if not isinstance(trial, Trial):
            raise TypeError(f"trial must be a Trial, got {type(trial).__name__}")
        return self._journal.find(trial)

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
        self._pending(trial)
        self._driver.fail(trial, reason)

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
        if dim is None:  # nothing happened
            return
        check_dim(self._given, self.history, dim)
        undisturbed(self._extend, points)

    def _extend(self, points: tuple[NDArray[np.float64], NDArray[np.float64]]) -> None:
        self.history._log.extend(points)  # noqa: SLF001 - the explorer writes it
        self._journal.added(len(points[0]))

    def run(  # noqa: PLR0913 - each is a choice of the user's
        self,
        environment: Environment,
        n: int,
        *,
        jobs: int | None = None,
        executor: Executor | None = None,
        in_flight: int | None = None,
        batch: int = 1,
        timeout: float | str | None = None,
        on_error: OnError = "raise",
        max_failures: int | None = None,
        callbacks: Iterable[CallbackLike] = (),
        checkpoint: str | os.PathLike[str] | None = None,
        every: Every = "30s",
    ) -> Exploration:
        """Explore a black box for `n` evaluations.

        It can be called again, with any environment and options. Trials that are under way - an
        exception or Ctrl-C has left them - are evaluated first.

        Parameters
        ----------
        environment : Environment
            The black box: callable, with ``motor_space`` and ``sensory_space``.
        n : int
            How many evaluations; those that fail are among them. With 0, as where a script has
            been resumed at its end, nothing is evaluated.
        jobs : int, optional
            How many worker processes evaluate. One that dies, or takes longer than `timeout`, is
            replaced: that evaluation has failed. The environment must be picklable (by
            cloudpickle). By default trials are evaluated in this thread, one after the other.
        executor : concurrent.futures.Executor, optional
            Where to evaluate instead: threads, processes, a cluster's
            (``dask.distributed.Client.get_executor()``, ``mpi4py.futures.MPIPoolExecutor``).
        in_flight : int, optional
            How many messages to keep under way; must be given with an executor. As many as it has
            workers, or some more, keep all of them busy. By default as many as `jobs`. Effects are
            told as they come in, so that with more than one under way the exploration depends on
            which is ready first.
        batch : int
            How many commands go in one message: more where the black box takes less time than the
            message, or arrays (``FunctionEnvironment(f, ..., vectorized=True)``).
        timeout : float or str, optional
            The longest time for an evaluation in a worker process, in seconds, or as a duration
            such as ``"10min"``; needs `jobs`.
        on_error : {"raise", "record"}
            What to do if an evaluation fails: raises, exits, returns no effect (NaN, infinity, a
            wrong shape), takes too long, or its worker dies. ``"record"`` goes on: its command and
            the reason are in ``history.failures``, and a bandit rewards it with 0. ``"raise"``
            raises what was raised; the trial stays under way.
        max_failures : int, optional
            Raise an exception after so many failures in a row.
        callbacks : iterable of callables
            Called with the explorer and a trial after each evaluation, told or failed; one that
            returns True stops the run, once what is under way has been told. See
            `divbandit.callbacks`.
        checkpoint : str or path, optional
            Where to save the explorer while it runs: `load` reads it, also if the process was
            killed.
        every : int or str
            How often: a number of evaluations, or a duration such as ``"30s"``.

        Returns
        -------
        Exploration
            All that was observed, also earlier: `result`.

        Raises
        ------
        TypeError, ValueError
            If an argument is not what it must be.
        RuntimeError
            After `max_failures`, or if all evaluations failed.
        Exception
            What the environment raises, unless it is recorded; what a strategy, a callback or the
            executor raises.

        Notes
        -----
        Whatever ends it early, the explorer holds all that was observed. It is the attribute
        ``explorer`` of the exception.

        Examples
        --------
        >>> import divbandit as db
        >>> arm = db.PlanarArm(20)
        >>> explorer = db.Explorer(db.GoalBabbling(0.05), arm.motor_space, arm.sensory_space, rng=0)
        >>> explorer.run(arm, 100)
        <Exploration of 100 evaluations, 20 -> 2>
        >>> explorer.run(arm, 50)
        <Exploration of 150 evaluations, 20 -> 2>
        """
        options = Options(
            jobs=jobs,
            executor=executor,
            in_flight=in_flight,
            batch=batch,
            timeout=timeout,
            on_error=on_error,
            max_failures=max_failures,
            callbacks=callbacks,
            checkpoint=checkpoint,
            every=every,
        )
        running.run(self, environment, n, options)
        return self.result()

    def save(self, path: str | os.PathLike[str]) -> None:
        """Write all that is needed to resume to a file, replacing it whole or not at all.

        It holds what was asked and told, and the generator's state at the beginning: all else
        follows from these. The file is a sequence of NumPy arrays; nothing in it is pickled.

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
        saved.write(path, self)

    @classmethod
    def load(cls, path: str | os.PathLike[str], strategy: Strategy | None = None) -> Explorer:
        """Read a saved explorer, which continues bit for bit as the original would have.

        Also a checkpoint of `run`, as far as it was written when the process was killed. All that
        was asked and told is repeated, with the generator as it was at the beginning; each
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
        return f"<Explorer of {self._given!r} after {counted(self.history)}>"


def _names_and_measure(strategy: Strategy) -> tuple[tuple[str, ...], Measure | None]:
    parts = getattr(strategy, "strategies", None) or [strategy]
    reward = getattr(strategy, "rewarding", None)
    measure = reward.measure if isinstance(reward, Gain) else None
    return tuple(map(_name_of, parts)), measure


def _name_of(strategy: Strategy) -> str:
    """Return the class of a strategy, and that of its inverse model if it was given one."""
    name, inverse = type(strategy).__name__, getattr(strategy, "inverse", None)
    return name if inverse is None else f"{name} ({type(inverse).__name__})"


def _commands_and_effects(past: object) -> tuple[ArrayLike, ArrayLike]:
    if isinstance(past, Exploration):
        return past.commands, past.effects
    if isinstance(past, (tuple, list)) and len(past) == 2:
        return past[0], past[1]
    kind = type(past).__name__
    raise TypeError(f"past must be an Exploration or a tuple (commands, effects), got {kind}")
