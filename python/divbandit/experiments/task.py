"""Task: what to explore, with which strategy, and for how many steps."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING

from divbandit._value import Value
from divbandit.exploration.explore import explore

if TYPE_CHECKING:
    from collections.abc import Iterator

    from divbandit._checks import Rng
    from divbandit.callbacks.protocol import CallbackLike
    from divbandit.environments import Environment
    from divbandit.exploration import Exploration
    from divbandit.exploration.drivers import EngineName
    from divbandit.exploration.options import OnError
    from divbandit.strategies.base import Strategy


@dataclass(frozen=True, repr=False)
class Task(Value):
    """A task (f, n) of the paper and the strategy for it: the arguments of `explore`.

    The arguments are checked when the exploration starts.

    Parameters
    ----------
    environment : Environment
        The black box. Tasks that share an environment may call it from several threads at once.
    strategy : Strategy
        It is never changed.
    n : int
        Number of evaluations, at least 1.
    rng : None, int, SeedSequence or Generator
        The source of all randomness. With None, `explore_many` seeds the task by its place.
    engine : {"auto", "python", "rust"}
        Where the steps are made, as in `explore`.
    keep_commands : bool
        Whether the Exploration keeps the motor commands, as in `explore`.
    on_error : {"raise", "record"}
        What to do if an evaluation fails, as in `explore`.

    See Also
    --------
    explore_many : Explore many tasks.

    Examples
    --------
    >>> import divbandit as db
    >>> task = db.experiments.Task(db.PlanarArm(20), db.MotorBabbling(), n=100)
    >>> task.n, task.rng
    (100, None)
    """

    environment: Environment
    strategy: Strategy
    n: int
    rng: Rng = None
    engine: EngineName = "auto"
    keep_commands: bool = True
    on_error: OnError = "raise"

    def explore(self, *, callbacks: Iterable[CallbackLike] = ()) -> Exploration:
        """Explore with the arguments that this task holds.

        Parameters
        ----------
        callbacks : iterable of callables
            As in `explore`.

        Examples
        --------
        >>> import divbandit as db
        >>> db.experiments.Task(db.PlanarArm(20), db.MotorBabbling(), n=100, rng=0).explore()
        <Exploration of 100 evaluations, 20 -> 2>
        """
        return explore(
            self.environment,
            self.strategy,
            self.n,
            rng=self.rng,
            engine=self.engine,
            keep_commands=self.keep_commands,
            on_error=self.on_error,
            callbacks=callbacks,
        )

    def over(self, seeds: Iterable[Rng]) -> Iterator[Task]:
        """Yield this task once for each seed.

        Parameters
        ----------
        seeds : iterable of None, int, SeedSequence or Generator
            Taken one by one, so there may be any number.

        Raises
        ------
        TypeError
            If `seeds` is not iterable.

        Examples
        --------
        >>> import divbandit as db
        >>> task = db.experiments.Task(db.PlanarArm(20), db.MotorBabbling(), n=100)
        >>> [each.rng for each in task.over(range(3))]
        [0, 1, 2]
        """
        if not isinstance(seeds, Iterable):
            raise TypeError(
                f"seeds must be an iterable, such as range(25), got {type(seeds).__name__}"
            )
        return (replace(self, rng=seed) for seed in seeds)
