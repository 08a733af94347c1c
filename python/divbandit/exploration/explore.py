"""explore: the whole loop - propose, try, observe - n times."""

from __future__ import annotations

from contextlib import contextmanager
from typing import TYPE_CHECKING

from divbandit._checks import one_of, truth, whole
from divbandit.environments import Environment
from divbandit.exploration.drivers import ENGINES
from divbandit.exploration.executors import explore_with
from divbandit.exploration.explorer import Explorer
from divbandit.exploration.result import Exploration

if TYPE_CHECKING:
    from collections.abc import Callable, Iterator
    from concurrent.futures import Executor

    from divbandit._checks import Rng
    from divbandit.exploration.drivers import EngineName
    from divbandit.strategies.base import Strategy


def explore(
    environment: Environment,
    strategy: Strategy,
    n: int,
    *,
    rng: Rng = None,
    engine: EngineName = "auto",
    keep_commands: bool = True,
    executor: Executor | None = None,
    in_flight: int | None = None,
) -> Exploration:
    """Run a task (f, n): explore `environment` with `strategy` for `n` evaluations.

    Parameters
    ----------
    environment : Environment
        The black box: callable, with ``motor_space`` and ``sensory_space``.
    strategy : Strategy
        Never changed: the running state is started from it.
    n : int
        How many evaluations, at least 1. The engine allocates the log of all of them before it
        begins, and raises an error if there is not enough memory.
    rng : None, int, SeedSequence or Generator
        All randomness comes from it; a Generator is drawn from, not copied.
    engine : {"auto", "python", "rust"}
        Where strategies run. Compositions of the library's own parts run in Rust, over any
        environment: one in Python is called back for its effects. ``"auto"`` does so where it can;
        with ``"python"`` the loop is in Python, as it is for user-defined strategies, rewards,
        policies and samplers, to the same bits; with ``"rust"`` it is an error if they cannot run
        in Rust.
    keep_commands : bool
        False leaves the motor commands, most of the memory, out of what is returned. In Rust they
        are not even held while exploring, unless a strategy looks at them, as goal babbling does.
    executor : concurrent.futures.Executor, optional
        Where the black box is called: threads, processes, a cluster's
        (``dask.distributed.Client.get_executor()``, ``mpi4py.futures.MPIPoolExecutor``). The
        environment is sent there as it is, and so must be picklable where these are processes. An
        evaluation that raises, or whose result is not an effect, has failed: it is one of the `n`,
        and recorded in ``failures``. Effects are told as they come in, so that with more than one
        under way the exploration depends on which is ready first.
    in_flight : int, optional
        How many evaluations to keep under way; must be given with an executor. As many as it has
        workers, or some more, keep all of them busy.

    Returns
    -------
    Exploration
        Commands, effects, choices, and the bandit's estimates.

    Raises
    ------
    TypeError, ValueError
        If an argument is not what it must be, or the strategy cannot explore this environment;
        or if `engine` is ``"rust"`` and a part is user-defined, which the message names.
    KeyboardInterrupt
        On Ctrl-C.
    RuntimeError
        If an executor was given, and all evaluations failed.
    Exception
        What the environment raises, or an executor that breaks down.

    Notes
    -----
    An exception has the attribute ``explorer``, an `Explorer` that holds all that was observed, and
    can be resumed, or saved where it has kept the commands.

    Examples
    --------
    >>> import divbandit as db
    >>> adapt = db.Adapt([db.MotorBabbling(), db.GoalBabbling(0.05)], tau=0.02)
    >>> run = db.explore(db.PlanarArm(20), adapt, n=500, rng=0)
    >>> run.commands.shape, run.effects.shape
    ((500, 20), (500, 2))
    """
    if executor is None:
        if in_flight is not None:
            raise ValueError(f"in_flight must be given with an executor alone, got {in_flight!r}")
        return explore_between(environment, strategy, n, rng, engine, keep_commands=keep_commands)
    if engine == "rust":
        raise ValueError('engine must not be "rust" where there is an executor')
    explorer = _explorer(environment, strategy, n, rng, engine, keep_commands=True)
    truth("keep_commands", keep_commands)
    with _holding(explorer):
        explore_with(environment, explorer, n, executor=executor, in_flight=in_flight)
    return explorer.result(keep_commands=keep_commands)


def explore_between(
    environment: Environment,
    strategy: Strategy,
    n: int,
    rng: Rng,
    engine: EngineName,
    *,
    keep_commands: bool,
    between: Callable[[], object] | None = None,
) -> Exploration:
    """Do what `explore` does, and call `between` again and again; what it raises ends the run.

    It is called after each step that calls Python, every twentieth of a second elsewhere.

    Examples
    --------
    >>> import divbandit as db
    >>> def too_long():
    ...     raise TimeoutError
    >>> arm, babbling = db.PlanarArm(20), db.MotorBabbling()
    >>> explore_between(arm, babbling, 10**6, 0, "auto", keep_commands=False, between=too_long)
    Traceback (most recent call last):
        ...
    TimeoutError
    """
    explorer = _explorer(environment, strategy, n, rng, engine, keep_commands=keep_commands)
    with _holding(explorer):
        explorer._run(environment, n, between)  # noqa: SLF001 - its other half
    return Exploration.of(explorer.history, keep_commands=keep_commands, take=True)


def _explorer(
    environment: Environment,
    strategy: Strategy,
    n: int,
    rng: Rng,
    engine: EngineName,
    *,
    keep_commands: bool,
) -> Explorer:
    """Check the arguments of an exploration, and return its explorer."""
    if not isinstance(environment, Environment):
        raise TypeError(
            "environment must be callable and have motor_space and sensory_space "
            f"(FunctionEnvironment makes one of a function), got {type(environment).__name__}"
        )
    one_of("engine", engine, ENGINES)
    truth("keep_commands", keep_commands)
    explorer = Explorer.for_run(
        strategy,
        environment.motor_space,
        environment.sensory_space,
        rng=rng,
        engine=engine,
        keep_commands=keep_commands,
    )
    whole("n", n, low=1)
    return explorer


@contextmanager
def _holding(explorer: Explorer) -> Iterator[None]:
    """Attach the explorer, which holds all that was observed, to what is raised."""
    try:
        yield
    except BaseException as error:
        error.explorer = explorer  # type: ignore[attr-defined]
        raise
