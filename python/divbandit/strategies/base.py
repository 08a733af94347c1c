"""Strategy: what every exploration strategy offers; Starter: how an exploration starts them."""

from __future__ import annotations

import copy
from abc import ABC, abstractmethod
from typing import TYPE_CHECKING, Any, TypeVar

from divbandit._core import Trial
from divbandit._value import Value

if TYPE_CHECKING:
    import numpy as np
    from numpy.random import Generator
    from numpy.typing import ArrayLike, NDArray

    from divbandit.box import Box
    from divbandit.history import History

Part = TypeVar("Part")


class Strategy(ABC):
    """A way to explore: derive from it and write `propose`.

    A strategy sees everything observed so far, in the history, whichever strategy proposed it. It
    may keep state in its attributes: an exploration works on a deep copy.

    Examples
    --------
    Commands at corners of the motor space:

    >>> import numpy as np
    >>> import divbandit as db
    >>> class Corners(db.Strategy):
    ...     def propose(self, history, rng):
    ...         space = history.motor_space
    ...         return np.where(rng.random(space.dim) < 0.5, space.low, space.high)
    >>> run = db.explore(db.PlanarArm(3), Corners(), n=4, rng=0)
    >>> len(np.unique(abs(run.commands)))
    1
    """

    @abstractmethod
    def propose(self, history: History, rng: Generator) -> Trial | ArrayLike:
        """Return the next motor command, or a Trial that also says its goal.

        Parameters
        ----------
        history : History
            All that was observed so far; empty at first.
        rng : numpy.random.Generator
            The only source of randomness to use.

        Returns
        -------
        array_like, shape (m,), or Trial
            A point of ``history.motor_space``.

        Examples
        --------
        >>> import numpy as np
        >>> import divbandit as db
        >>> history = db.History(db.Box([0], [1]))
        >>> db.MotorBabbling().propose(history, np.random.default_rng(0)).command
        array([0.63696169])
        """

    def observe(self, trial: Trial, effect: NDArray[np.float64]) -> None:  # noqa: B027
        """Update from the effect of a trial that this strategy proposed.

        The effect is the newest of the history.

        Parameters
        ----------
        trial : Trial
            The one that `propose` returned, or was made from the command that it returned.
        effect : numpy.ndarray, shape (s,)

        Examples
        --------
        The explorer's copy, ``explorer.strategy``, has what a user-defined strategy learned.

        >>> import divbandit as db
        >>> class Watchful(db.Strategy):
        ...     farthest = 0.0
        ...     def propose(self, history, rng):
        ...         return history.motor_space.sample(rng)
        ...     def observe(self, trial, effect):
        ...         self.farthest = max(self.farthest, float(effect[0]))
        >>> explorer = db.Explorer(Watchful(), db.Box([0], [1]), rng=0)
        >>> explorer.tell(explorer.ask(), [3.0])
        >>> explorer.strategy.farthest
        3.0
        """

    def fail(self, trial: Trial, reason: str) -> None:  # noqa: B027
        """Update from the failure of a trial that this strategy proposed: there is no effect.

        Parameters
        ----------
        trial : Trial
            The one that `propose` returned, or was made from the command that it returned.
        reason : str

        Examples
        --------
        >>> import divbandit as db
        >>> class Careful(db.Strategy):
        ...     failed = 0
        ...     def propose(self, history, rng):
        ...         return history.motor_space.sample(rng)
        ...     def fail(self, trial, reason):
        ...         self.failed += 1
        >>> explorer = db.Explorer(Careful(), db.Box([0], [1]), rng=0)
        >>> explorer.fail(explorer.ask(), "the robot fell over")
        >>> explorer.strategy.failed
        1
        """

    def check(self, motor_space: Box, effect_dim: int | None, *, has_goals: bool) -> None:  # noqa: B027
        """Raise a ValueError if this strategy cannot explore an environment of this kind.

        Called before an exploration begins, so that nothing is lost half-way.

        Parameters
        ----------
        motor_space : Box
        effect_dim : int or None
            Dimension of the effects; None if it is not known yet.
        has_goals : bool
            Whether the environment names a sensory space from which goals can be drawn.

        Examples
        --------
        >>> import divbandit as db
        >>> db.GoalBabbling().check(db.Box([0], [1]), 2, has_goals=False)
        ... # doctest: +ELLIPSIS
        Traceback (most recent call last):
            ...
        ValueError: there must be a sensory space to draw goals from: ...
        """

    def start(self, start: Starter) -> Strategy:
        """Return what runs during one exploration; by default a deep copy.

        Parameters
        ----------
        start : Starter
            Starts strategies that this one is made of, and knows the history.

        Examples
        --------
        >>> import divbandit as db
        >>> history = db.History(db.Box([0], [1]))
        >>> db.MotorBabbling().start(db.strategies.Starter(history))
        MotorBabbling()
        """
        return start.copy_of(self)

    @property
    def estimates(self) -> tuple[float, ...] | None:
        """A running bandit's estimates of its strategies; None for other strategies."""
        return None

    def __repr__(self) -> str:
        return f"{type(self).__name__}()"


class StrategyValue(Value, Strategy):
    """A strategy of the library: an immutable value, whose running state `start` returns.

    As it is not the value that runs, a user's class that derives from one cannot change how it
    proposes or observes: that is refused.
    """

    __repr__ = Value.__repr__

    def __init_subclass__(cls, **options: Any) -> None:  # noqa: ANN401 - as any class
        super().__init_subclass__(**options)
        is_ours = cls.__module__.startswith(__name__.partition(".")[0] + ".")
        starter = next(base for base in cls.__mro__ if "start" in vars(base))
        runs_itself = "propose" in vars(starter)  # as what has no state does
        changed = {"propose", "observe", "fail", "choose"} & set(vars(cls))
        if changed and not (is_ours or runs_itself):
            raise TypeError(
                f"{cls.__name__} must derive from Strategy or Composite: "
                f"its {min(changed)} would not be called"
            )

    def propose(self, history: History, rng: Generator) -> Trial:
        """Propose as a newly started strategy would.

        Parameters
        ----------
        history : History
        rng : numpy.random.Generator

        Examples
        --------
        >>> import numpy as np
        >>> import divbandit as db
        >>> mixture = db.Mixture([db.MotorBabbling()])
        >>> mixture.propose(db.History(db.Box([0], [1])), np.random.default_rng(0)).path
        (0,)
        """
        return Trial.of(Starter(history)(self).propose(history, rng))


class Starter:
    """Starts the strategies of one exploration; one that occurs twice is started once.

    Parameters
    ----------
    history : History
        The history of the exploration.

    Attributes
    ----------
    history : History

    Examples
    --------
    >>> import divbandit as db
    >>> start = db.strategies.Starter(db.History(db.Box([0], [1])))
    >>> schedule = db.Schedule([(3, db.MotorBabbling()), (None, db.MotorBabbling())])
    >>> start(schedule) is start(schedule)
    True
    """

    def __init__(self, history: History) -> None:
        self.history = history
        # By identity; the strategies are kept, so that no other gets the same identity.
        self._started: dict[int, tuple[Strategy, Strategy]] = {}
        self._copies: dict[int, Any] = {}

    def __call__(self, strategy: Strategy) -> Strategy:
        """Return the running counterpart of a strategy."""
        if id(strategy) not in self._started:
            self._started[id(strategy)] = (strategy, strategy.start(self))
        return self._started[id(strategy)][1]

    def copy_of(self, part: Part) -> Part:
        """Return a deep copy of a user's part; what parts share, their copies share."""
        try:
            return copy.deepcopy(part, self._copies)
        except TypeError as error:  # what runs in Rust cannot be copied
            raise TypeError(
                f"strategy must be one that can be copied, as it was given to an explorer, "
                f"not what runs in it, got {type(part).__name__}: {error}"
            ) from None

    def value_or_copy(self, part: Part) -> Part:
        """Return a value of the library as it is, and a deep copy of a user's part."""
        return part if isinstance(part, Value) else self.copy_of(part)

    def part(self, part: Any, *arguments: object) -> Any:  # noqa: ANN401 - of any kind
        """Start a part that is not a strategy: a value, or a deep copy of a user's part.

        Examples
        --------
        >>> import divbandit as db
        >>> start = db.strategies.Starter(db.History(db.Box([0], [1])))
        >>> start.part(db.bandits.WholePast(), 2, 6.0).means
        [0.0, 0.0]
        """
        own = self.value_or_copy(part)
        return own.start(*arguments) if hasattr(own, "start") else own
