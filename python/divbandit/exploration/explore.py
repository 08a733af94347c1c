"""explore: the whole loop - propose, evaluate, learn - n times."""

from __future__ import annotations

from typing import TYPE_CHECKING

from divbandit._checks import whole
from divbandit.exploration import running
from divbandit.exploration.explorer import Explorer
from divbandit.exploration.options import Options, check_environment
from divbandit.exploration.result import Exploration

if TYPE_CHECKING:
    import os
    from collections.abc import Iterable
    from concurrent.futures import Executor

    from divbandit._checks import Rng
    from divbandit.callbacks.protocol import CallbackLike
    from divbandit.environments import Environment
    from divbandit.exploration.drivers import EngineName
    from divbandit.exploration.explorer import Past
    from divbandit.exploration.options import OnError
    from divbandit.exploration.watching import Every
    from divbandit.strategies.base import Strategy


def explore(  # noqa: PLR0913 - each is a choice of the user's
    environment: Environment,
    strategy: Strategy,
    n: int,
    *,
    rng: Rng = None,
    past: Past | None = None,
    engine: EngineName = "auto",
    keep_commands: bool = True,
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
    """Run a task (f, n): explore `environment` with `strategy` for `n` evaluations.

    Short for an `Explorer` of the environment's spaces that runs once.

    Parameters
    ----------
    environment : Environment
        The black box: callable, with ``motor_space`` and ``sensory_space``.
    strategy : Strategy
        Never changed: the running state is started from it.
    n : int
        How many evaluations, at least 1; those that fail are among them.
    rng : None, int, SeedSequence or Generator
        All randomness comes from it; a Generator is drawn from, not copied.
    past : Exploration, or (commands, effects), optional
        Earlier evaluations, which strategies see and which are not rewarded.
    engine : {"auto", "python", "rust"}
        Where strategies run. Compositions of the library's own parts run in Rust, over any
        environment: one in Python is called back for its effects. ``"auto"`` does so where it can;
        with ``"python"`` the loop is in Python, as it is for user-defined strategies, rewards,
        policies and samplers, to the same bits; with ``"rust"`` it is an error if they cannot run
        in Rust.
    keep_commands : bool
        False leaves the motor commands, most of the memory, out of what is returned. They are not
        even held while exploring, unless a strategy looks at them, as goal babbling does.
    jobs, executor, in_flight, batch, timeout, on_error, max_failures, callbacks, checkpoint, every
        Where and how to evaluate, what to do with failures, what to call and to write in between:
        see `Explorer.run`.

    Returns
    -------
    Exploration
        Commands, effects, choices, the bandit's estimates, and failures.

    Raises
    ------
    TypeError, ValueError
        If an argument is not what it must be, or the strategy cannot explore this environment;
        or if `engine` is ``"rust"`` and a part is user-defined, which the message names.
    KeyboardInterrupt
        On Ctrl-C.
    RuntimeError
        If all evaluations failed, or `max_failures` in a row.
    Exception
        What the environment raises, unless it is recorded; what a strategy, a callback or the
        executor raises.

    Notes
    -----
    An exception has the attribute ``explorer``: the `Explorer`, which holds all that was observed,
    and whose ``run`` goes on.

    Examples
    --------
    >>> import divbandit as db
    >>> adapt = db.Adapt([db.MotorBabbling(), db.GoalBabbling(0.05)], tau=0.02)
    >>> run = db.explore(db.PlanarArm(20), adapt, n=500, rng=0)
    >>> run.commands.shape, run.effects.shape
    ((500, 20), (500, 2))
    """
    check_environment(environment)
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
    explorer = Explorer(
        strategy,
        environment.motor_space,
        environment.sensory_space,
        rng=rng,
        past=past,
        engine=engine,
        keep_commands=keep_commands,
    )
    running.run(explorer, environment, whole("n", n, low=1), options)
    return Exploration.of(explorer.history, keep_commands=keep_commands, take=True)
