"""Task: what to explore, with which strategy, for how long."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from collections.abc import Iterator

    from divbandit._checks import Rng
    from divbandit.environments import Environment
    from divbandit.exploration.explore import Engine
    from divbandit.strategies.base import Strategy


@dataclass(frozen=True, slots=True)
class Task:
    """A task (f, n) of the paper, with the strategy to do it: what `explore` is called with.

    What it holds is looked at when its exploration starts.

    Attributes
    ----------
    environment : Environment
        The black box. Those that share one of your own call it from several threads at once.
    strategy : Strategy
        Is copied; the one given is never changed.
    n : int
        How many evaluations, at least 1.
    rng : None, int, SeedSequence or Generator
        All randomness comes from it. None lets `explore_many` seed it by its place.
    engine : {"auto", "python", "rust"}
        Where the steps are made, as in `explore`.
    keep_commands : bool
        Whether the Exploration is to have the motor commands, as in `explore`.

    See Also
    --------
    explore_many : explores many of them.

    Examples
    --------
    >>> import divbandit as db
    >>> task = db.Task(db.PlanarArm(20), db.MotorBabbling(), n=100)
    >>> task.n, task.rng
    (100, None)
    """

    environment: Environment
    strategy: Strategy
    n: int
    rng: Rng = None
    engine: Engine = "auto"
    keep_commands: bool = True

    def over(self, seeds: Iterable[Rng]) -> Iterator[Task]:
        """Return the same task once for each seed.

        Parameters
        ----------
        seeds : iterable of None, int, SeedSequence or Generator
            Taken one by one: there may be any number.

        Raises
        ------
        TypeError
            If `seeds` is not iterable.

        Examples
        --------
        >>> import divbandit as db
        >>> task = db.Task(db.PlanarArm(20), db.MotorBabbling(), n=100)
        >>> [each.rng for each in task.over(range(3))]
        [0, 1, 2]
        """
        if not isinstance(seeds, Iterable):
            raise TypeError(
                f"seeds must be an iterable, such as range(25), got {type(seeds).__name__}"
            )
        return (replace(self, rng=seed) for seed in seeds)
