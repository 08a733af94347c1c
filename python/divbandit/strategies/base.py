"""Strategy and Trial: what every strategy offers, and what it proposes."""

from __future__ import annotations

from abc import ABC, abstractmethod
from itertools import repeat
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from collections.abc import Sequence

    import numpy as np
    from numpy.random import Generator
    from numpy.typing import ArrayLike, NDArray

    from divbandit.box import Box
    from divbandit.history import History


_new = object.__new__


class Trial:
    """A motor command that a strategy proposes, and why.

    Parameters
    ----------
    command : array_like, shape (m,)
        The motor command.
    goal : array_like, shape (s,), optional
        The effect that it is meant to bring about.

    Attributes
    ----------
    command, goal
        As given.
    path : tuple of int
        Who proposed it: indices of strategies, outermost first. Empty where one strategy
        explores alone.
    probability : float or None
        The probability with which the outermost strategy, a bandit, chose who proposed it; None
        where that is not known.
    inner : Trial or None
        For a trial of a composite strategy, or one that an Explorer gives out: the very trial
        that was proposed.
    number : int or None
        For a trial that an Explorer gives out: how many it gave out before.
    place : int or None
        Once its effect is known: the place of that effect in the history.

    Examples
    --------
    >>> import divbandit as db
    >>> trial = db.Trial([0.5, 0.5], goal=[1.0])
    >>> trial.path
    ()
    """

    __slots__ = ("command", "goal", "inner", "number", "path", "place", "probability")

    def __init__(self, command: ArrayLike, *, goal: ArrayLike | None = None) -> None:
        self.command = command
        self.goal = goal
        self.path: tuple[int, ...] = ()
        self.inner: Trial | None = None
        self.number: int | None = None
        self.place: int | None = None
        self.probability: float | None = None

    @classmethod
    def of(cls, proposal: Trial | ArrayLike) -> Trial:
        """Return what a strategy proposed as a Trial if it is not one already.

        Examples
        --------
        >>> import divbandit as db
        >>> db.Trial.of([0.5]).command
        [0.5]
        """
        return proposal if isinstance(proposal, Trial) else cls(proposal)

    @classmethod
    def many(
        cls, commands: Sequence[ArrayLike], goals: Sequence[ArrayLike] | None = None
    ) -> list[Trial]:
        """Return a trial for each command, and its goal: quicker than one by one.

        Parameters
        ----------
        commands : sequence of array_like, shape (m,)
        goals : sequence of array_like, shape (s,), optional
            As many.

        Examples
        --------
        >>> import divbandit as db
        >>> [trial.goal for trial in db.Trial.many([[0.5], [0.25]], [[1.0], [2.0]])]
        [[1.0], [2.0]]
        """
        trials = []
        for command, goal in zip(commands, goals or repeat(None, len(commands)), strict=True):
            trial = _new(Trial)
            trial.command, trial.goal, trial.path = command, goal, ()
            trial.inner = trial.number = trial.place = trial.probability = None
            trials.append(trial)
        return trials

    def proposed_by(self, index: int, probability: float | None = None) -> Trial:
        """Return this trial as one of a composite strategy, whose part `index` proposed it.

        Parameters
        ----------
        index : int
        probability : float, optional
            With which probability that part was chosen.

        Examples
        --------
        >>> import divbandit as db
        >>> db.Trial([0.5]).proposed_by(1).proposed_by(0).path
        (0, 1)
        """
        # Set one by one: a call of the constructor would double the time that this takes.
        trial = _new(Trial)
        trial.command, trial.goal = self.command, self.goal
        trial.path = (index, *self.path)
        trial.inner, trial.probability = self, probability
        trial.number = trial.place = None
        return trial

    def __repr__(self) -> str:
        return f"Trial({self.command!r}, goal={self.goal!r}, path={self.path!r})"


class Strategy(ABC):
    """An exploration strategy: derive from it, write `propose`, and it can be chosen among.

    Examples
    --------
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

    def __init_subclass__(cls, **options: object) -> None:
        """Drop an inherited shortcut for many trials where a class says anew how one is made."""
        super().__init_subclass__(**options)
        own = vars(cls)
        if "propose" in own and "propose_many" not in own:
            cls.propose_many = Strategy.propose_many  # type: ignore[method-assign]
        if "observe" in own and "observe_many" not in own:
            cls.observe_many = Strategy.observe_many  # type: ignore[method-assign]

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

    def propose_many(self, history: History, n: int, rng: Generator) -> list[Trial]:
        """Return `n` trials, all of them proposed before any of their effects is known.

        By default what `n` calls of `propose` return. A strategy may have a faster way; each of
        the trials must be one of its own.

        Parameters
        ----------
        history : History
        n : int
        rng : numpy.random.Generator

        Examples
        --------
        >>> import numpy as np
        >>> import divbandit as db
        >>> history = db.History(db.Box([0], [1]))
        >>> trials = db.MotorBabbling().propose_many(history, 2, np.random.default_rng(0))
        >>> [trial.command.round(2).tolist() for trial in trials]
        [[0.64], [0.27]]
        """
        return [Trial.of(self.propose(history, rng)) for _ in range(n)]

    def observe(self, trial: Trial, effect: NDArray[np.float64]) -> None:  # noqa: B027
        """Learn what came of a trial of one's own; the history holds it already.

        Parameters
        ----------
        trial : Trial
            The very one that `propose` returned (made from its command if it returned that).
        effect : numpy.ndarray, shape (s,)

        Examples
        --------
        An explorer works on a copy of the strategy, ``explorer.strategy``: what it has learned is
        read there.

        >>> import divbandit as db
        >>> class Watchful(db.MotorBabbling):
        ...     farthest = 0.0
        ...     def observe(self, trial, effect):
        ...         self.farthest = max(self.farthest, float(effect[0]))
        >>> explorer = db.Explorer(Watchful(), db.Box([0], [1]), rng=0)
        >>> explorer.tell(explorer.ask(), [3.0])
        >>> explorer.strategy.farthest
        3.0
        """

    def observe_many(self, trials: Sequence[Trial], effects: NDArray[np.float64]) -> None:
        """Learn what came of many trials of one's own; the history holds all of them already.

        By default what as many calls of `observe` do. Whoever tells a batch calls this where
        the strategy has an `observe_many` of its own, or learns nothing; others are told of one
        effect after the other, before the history holds the next.

        Parameters
        ----------
        trials : sequence of Trial
            In the order in which they were told; ``trial.place`` is the effect's in the history.
        effects : numpy.ndarray, shape (n, s)

        Examples
        --------
        >>> import numpy as np
        >>> import divbandit as db
        >>> class Counting(db.MotorBabbling):
        ...     seen = 0
        ...     def observe_many(self, trials, effects):
        ...         self.seen += len(trials)
        >>> explorer = db.Explorer(Counting(), db.Box([0], [1]), rng=0)
        >>> explorer.tell(explorer.ask(3), [[3.0], [4.0], [5.0]])
        >>> explorer.strategy.seen
        3
        """
        for trial, effect in zip(trials, effects, strict=True):
            self.observe(trial, effect)

    @property
    def learns_at_once(self) -> bool:
        """Whether `observe_many` comes to the same as calls of `observe` in between appends."""
        return self.learns_nothing or type(self).observe_many is not Strategy.observe_many

    @property
    def learns_nothing(self) -> bool:
        """Whether nothing is learned from effects, so that nobody need tell of them."""
        kind = type(self)
        return kind.observe is Strategy.observe and kind.observe_many is Strategy.observe_many

    def fail(self, trial: Trial, reason: str) -> None:  # noqa: B027
        """Learn that a trial of one's own came to nothing: there is no effect.

        Parameters
        ----------
        trial : Trial
            The very one that `propose` returned (made from its command if it returned that).
        reason : str

        Examples
        --------
        >>> import divbandit as db
        >>> class Careful(db.MotorBabbling):
        ...     failed = 0
        ...     def fail(self, trial, reason):
        ...         self.failed += 1
        >>> explorer = db.Explorer(Careful(), db.Box([0], [1]), rng=0)
        >>> explorer.fail(explorer.ask(), "the robot fell over")
        >>> explorer.strategy.failed
        1
        """

    def check(self, motor_space: Box, effect_dim: int | None, *, has_goals: bool) -> None:  # noqa: B027
        """Raise a ValueError if this strategy cannot explore such an environment.

        Called once before an exploration begins, so that nothing is lost half-way.

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
        Traceback (most recent call last):
            ...
        ValueError: goals must be given to GoalBabbling: there is no sensory space to draw them from
        """

    def __repr__(self) -> str:
        return f"{type(self).__name__}()"

    @property
    def diversities(self) -> tuple[float, ...] | None:
        """What a bandit currently believes of each of its strategies; None for all others."""
        return None
