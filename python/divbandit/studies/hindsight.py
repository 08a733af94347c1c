"""hindsight: every strategy proposes, all proposals are tried, only the best one is kept."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from divbandit.history import History
from divbandit.measures import Coverage
from divbandit.paper import setting
from divbandit.strategies import Trial
from divbandit.strategies.base import Starter

if TYPE_CHECKING:
    from collections.abc import Sequence

    from numpy.random import SeedSequence
    from numpy.typing import NDArray

    from divbandit.environments import Environment
    from divbandit.strategies import Strategy


def hindsight(
    environment: Environment, strategies: Sequence[Strategy], n: int, rng: SeedSequence
) -> NDArray[np.float64]:
    """Explore for `n` steps, seeing all outcomes before each choice.

    At each step every strategy proposes a command, in order, and each is tried. The one whose
    effect gains most is kept; the others are discarded. Ties are broken uniformly. So it makes ``n
    * len(strategies)`` evaluations, and no bandit can be expected to do as well with `n`.

    Parameters
    ----------
    environment : Environment
    strategies : sequence of Strategy
        They must learn from the history alone, like motor and goal babbling.
    n : int
        How many effects to keep.
    rng : SeedSequence

    Returns
    -------
    numpy.ndarray of float64, shape (n, s)
        The effects that were kept. Gains are areas of discs of the paper's radius.

    Examples
    --------
    >>> import numpy as np
    >>> import divbandit as db
    >>> arm, babblings = db.PlanarArm(20), [db.MotorBabbling(), db.GoalBabbling(0.05)]
    >>> kept = hindsight(arm, babblings, 200, np.random.SeedSequence(0))
    >>> bandit = db.explore(arm, db.Adapt(babblings), 200, rng=0)
    >>> bool(db.coverage(kept, 0.02) > db.coverage(bandit.effects, 0.02))
    True
    """
    draw = np.random.default_rng(rng)
    history = History(environment.motor_space, environment.sensory_space)
    running = [Starter(history)(strategy) for strategy in strategies]
    covered = Coverage(setting.TAU)
    for _ in range(n):
        commands = [Trial.of(each.propose(history, draw)).command for each in running]
        effects = [environment(command) for command in commands]
        gains = [covered.gain(effect) for effect in effects]
        most = max(gains)
        ties = [index for index, gain in enumerate(gains) if gain == most]
        chosen = ties[int(draw.random() * len(ties))]
        covered.add(effects[chosen])
        history.append(commands[chosen], effects[chosen], path=(chosen,))
    return history.effects
