"""explore_with: several evaluations under way, through any executor."""

from __future__ import annotations

from concurrent.futures import FIRST_COMPLETED, BrokenExecutor, Executor, Future, wait
from typing import TYPE_CHECKING

from divbandit._checks import whole
from divbandit._core import as_point

if TYPE_CHECKING:
    from numpy.typing import ArrayLike

    from divbandit._core import Trial
    from divbandit.environments import Environment
    from divbandit.exploration.explorer import Explorer


def explore_with(
    environment: Environment,
    explorer: Explorer,
    n: int,
    *,
    executor: Executor,
    in_flight: int | None,
) -> None:
    """Let the explorer make `n` evaluations, up to `in_flight` of them at a time.

    Effects are told as they come in; those that come in together, in the order in which their
    commands were proposed. An evaluation that raises, or returns something that is not an effect,
    has failed.

    Raises
    ------
    TypeError, ValueError
        If `executor` is not an executor, or `in_flight` is not a whole number of at least 1.
    RuntimeError
        If all evaluations failed; the message gives the reason of the last one.
    BrokenExecutor
        If the executor itself breaks down.

    Examples
    --------
    >>> from concurrent.futures import ThreadPoolExecutor
    >>> import divbandit as db
    >>> arm = db.PlanarArm(20)
    >>> explorer = db.Explorer(db.MotorBabbling(), arm.motor_space, arm.sensory_space, rng=0)
    >>> with ThreadPoolExecutor(2) as executor:
    ...     explore_with(arm, explorer, 10, executor=executor, in_flight=4)
    >>> len(explorer.history)
    10
    """
    if not (hasattr(executor, "submit") and callable(executor.submit)):
        kind = type(executor).__name__
        raise TypeError(f"executor must be a concurrent.futures.Executor, got {kind}")
    if in_flight is None:
        raise ValueError("in_flight must be given together with an executor, got None")
    most = whole("in_flight", in_flight, low=1)
    under_way: dict[Future[ArrayLike], Trial] = {}
    asked = 0
    try:
        while asked < n or under_way:
            while asked < n and len(under_way) < most:
                trial = explorer.ask()
                under_way[executor.submit(environment, trial.command)] = trial
                asked += 1
            done, _ = wait(under_way, return_when=FIRST_COMPLETED)
            for future in [future for future in under_way if future in done]:
                _finish(explorer, under_way.pop(future), future)
    finally:
        for future in under_way:
            future.cancel()
    if len(explorer.history) == 0:
        failures = explorer.history.failures
        raise RuntimeError(f"all {len(failures)} evaluations failed, last: {failures[-1].reason}")


def _finish(explorer: Explorer, trial: Trial, future: Future[ArrayLike]) -> None:
    """Tell the effect, or record the failure."""
    try:
        effect = as_point("effect", future.result(), explorer.history.effect_dim)
    except BrokenExecutor:
        raise
    except Exception as error:  # noqa: BLE001 - a black box may raise anything
        explorer.fail(trial, f"{type(error).__name__}: {error}")
    else:
        explorer.tell(trial, effect)
