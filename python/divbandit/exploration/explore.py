"""explore: the whole loop - propose, try, observe - n times."""

from __future__ import annotations

from typing import TYPE_CHECKING

from divbandit._checks import one_of, truth, whole
from divbandit._engine import NotBuiltInError
from divbandit.environments import Environment
from divbandit.exploration.at_once import explore_at_once
from divbandit.exploration.explorer import Explorer
from divbandit.exploration.in_rust import explore_in_rust

if TYPE_CHECKING:
    from collections.abc import Callable
    from concurrent.futures import Executor
    from typing import Literal

    from divbandit._checks import Rng
    from divbandit.exploration.result import Exploration
    from divbandit.strategies.base import Strategy

    Engine = Literal["auto", "python", "rust"]

#: Where an exploration's steps can be made.
ENGINES = ("auto", "python", "rust")


def explore(
    environment: Environment,
    strategy: Strategy,
    n: int,
    *,
    rng: Rng = None,
    engine: Engine = "auto",
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
        Is copied; the one given is never changed.
    n : int
        How many evaluations, at least 1. The engine makes room for what all of them leave before
        it begins, and refuses to where there is no memory for that.
    rng : None, int, SeedSequence or Generator
        All randomness comes from it; a Generator is drawn from, not copied.
    engine : {"auto", "python", "rust"}
        Where the steps are made. In Rust, explorations that are made of built-in parts alone run
        from first to last without Python, some ten times as fast, and to the same bits. ``"auto"``
        does so where it can; ``"python"`` never does, ``"rust"`` insists on it.
    keep_commands : bool
        False leaves the motor commands out of what is returned, most of its memory. In Rust they
        are not even held while exploring, unless a strategy looks at them, as goal babbling does.
    executor : concurrent.futures.Executor, optional
        Where the black box is called: threads, processes, a cluster's
        (``dask.distributed.Client.get_executor()``, ``mpi4py.futures.MPIPoolExecutor``). The
        environment is sent there as it is, and so must be picklable where these are processes.
        An evaluation that raises, or whose result is no effect, has failed: it is one of the `n`,
        and told of in ``failures``. Effects are told as they come in, so that with more than one
        under way the exploration depends on which is ready first.
    in_flight : int, optional
        How many evaluations to keep under way; must be given with an executor. As many as it has
        workers, or some more, keep all of them busy.

    Returns
    -------
    Exploration
        Commands, effects, choices, and what the bandit believed.

    Raises
    ------
    TypeError, ValueError
        If an argument is not what it must be, or the strategy cannot explore this environment;
        or if `engine` is ``"rust"`` and a part is not built in, which the message names.
    KeyboardInterrupt
        On Ctrl-C; the run is lost then.
    RuntimeError
        If an executor was given, and not a single evaluation came to anything.
    Exception
        What the environment raises, or an executor that breaks down; the run is lost then. For a
        costly one use `Explorer`, whose history remains.

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
    explorer = _begin(environment, strategy, n, rng, engine, keep_commands)
    if engine == "rust":
        raise ValueError('engine must not be "rust" where there is an executor')
    explore_at_once(environment, explorer, n, executor=executor, in_flight=in_flight)
    return explorer.result(keep_commands=keep_commands)


def explore_between(
    environment: Environment,
    strategy: Strategy,
    n: int,
    rng: Rng,
    engine: Engine,
    *,
    keep_commands: bool,
    between: Callable[[], object] | None = None,
) -> Exploration:
    """Do what `explore` does, and call `between` again and again; what it raises ends the run.

    It is called after each step in Python, every twentieth of a second in Rust.

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
    explorer = _begin(environment, strategy, n, rng, engine, keep_commands)
    if engine != "python":
        try:
            return explore_in_rust(
                environment, explorer, n, keep_commands=keep_commands, between=between
            )
        except NotBuiltInError as error:
            if engine == "rust":
                raise ValueError(
                    'engine "rust" must be given built-in parts only, '
                    f"got {error.where}, a {error.kind}"
                ) from None
    for _ in range(n):
        trial = explorer.ask()
        explorer.tell(trial, environment(trial.command))
        if between is not None:
            between()
    return explorer.result(keep_commands=keep_commands)


def _begin(
    environment: Environment,
    strategy: Strategy,
    n: int,
    rng: Rng,
    engine: str,
    keep_commands: object,
) -> Explorer:
    """Check what an exploration is asked for, and return what will make it."""
    if not isinstance(environment, Environment):
        raise TypeError(
            "environment must be callable and have motor_space and sensory_space "
            f"(FunctionEnvironment makes one of a function), got {type(environment).__name__}"
        )
    explorer = Explorer(strategy, environment.motor_space, environment.sensory_space, rng=rng)
    whole("n", n, low=1)
    one_of("engine", engine, ENGINES)
    truth("keep_commands", keep_commands)
    return explorer
