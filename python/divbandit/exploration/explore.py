"""explore: the whole loop - propose, try, observe - n times."""

from __future__ import annotations

from typing import TYPE_CHECKING

from divbandit._checks import whole
from divbandit.environments import Environment
from divbandit.exploration.explorer import Explorer

if TYPE_CHECKING:
    from divbandit._checks import Rng
    from divbandit.exploration.result import Exploration
    from divbandit.strategies.base import Strategy


def explore(
    environment: Environment, strategy: Strategy, n: int, *, rng: Rng = None
) -> Exploration:
    """Run a task (f, n): explore `environment` with `strategy` for `n` evaluations.

    Parameters
    ----------
    environment : Environment
        The black box: callable, with ``motor_space`` and ``sensory_space``.
    strategy : Strategy
        Is copied; the one given is never changed.
    n : int
        How many evaluations, at least 1.
    rng : None, int, SeedSequence or Generator
        All randomness comes from it; a Generator is drawn from, not copied.

    Returns
    -------
    Exploration
        Commands, effects, choices, and what the bandit believed.

    Raises
    ------
    TypeError, ValueError
        If an argument is not what it must be, or the strategy cannot explore this environment.
    Exception
        What the environment raises; the run is lost then. For a costly one use `Explorer`, whose
        history remains.

    Examples
    --------
    >>> import divbandit as db
    >>> adapt = db.Adapt([db.MotorBabbling(), db.GoalBabbling(0.05)], tau=0.02)
    >>> run = db.explore(db.PlanarArm(20), adapt, n=500, rng=0)
    >>> run.commands.shape, run.effects.shape
    ((500, 20), (500, 2))
    """
    if not isinstance(environment, Environment):
        raise TypeError(
            "environment must be callable and have motor_space and sensory_space "
            f"(FunctionEnvironment makes one of a function), got {type(environment).__name__}"
        )
    explorer = Explorer(strategy, environment.motor_space, environment.sensory_space, rng=rng)
    for _ in range(whole("n", n, low=1)):
        trial = explorer.ask()
        explorer.tell(trial, environment(trial.command))
    return explorer.result()
