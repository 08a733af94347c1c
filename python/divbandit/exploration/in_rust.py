"""explore_in_rust: an exploration of built-in parts alone, made by the engine."""

from __future__ import annotations

from typing import TYPE_CHECKING

from numpy.random import Generator

from divbandit._engine import Description, NotBuiltInError
from divbandit.exploration.result import NOT_KEPT, Exploration

if TYPE_CHECKING:
    from collections.abc import Callable

    from divbandit.environments import Environment
    from divbandit.exploration.explorer import Explorer


def explore_in_rust(
    environment: Environment,
    explorer: Explorer,
    n: int,
    *,
    keep_commands: bool,
    between: Callable[[], object] | None,
) -> Exploration:
    """Make the `n` steps that an explorer, not yet used, would make.

    Raises
    ------
    NotBuiltInError
        If one of the parts is not built in; nothing was drawn then.

    Examples
    --------
    >>> import divbandit as db
    >>> arm = db.PlanarArm(20)
    >>> explorer = db.Explorer(db.MotorBabbling(), arm.motor_space, arm.sensory_space, rng=0)
    >>> explore_in_rust(arm, explorer, 100, keep_commands=True, between=None)
    <Exploration of 100 evaluations, 20 -> 2>
    """
    if type(explorer.rng) is not Generator:
        raise NotBuiltInError("rng", type(explorer.rng).__name__)
    history = explorer.history
    space, goals = history.motor_space, history.sensory_space
    description = Description(environment, space, goals)
    if goals is None:
        try:
            explorer.strategy.check(space, description.effect_dim, has_goals=False)
        except ValueError:  # found out when the first effect tells its dimension
            raise NotBuiltInError("environment.sensory_space", "NoneType") from None
    strategy = description.add("strategy", explorer.strategy)
    commands, effects, paths, diversities = description.engine.explore(
        strategy, n, explorer.rng, keep_commands, between
    )
    commands = NOT_KEPT if commands is None else commands
    return Exploration(space, goals, commands, effects, paths, diversities)
