"""Explorer: ask for a command, evaluate it anywhere, tell the effect."""

from __future__ import annotations

import copy
from typing import TYPE_CHECKING, NamedTuple

from divbandit._checks import generator, truth
from divbandit._core import as_point
from divbandit.exploration.result import Exploration
from divbandit.history import History
from divbandit.strategies.base import Strategy, Trial

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import ArrayLike, NDArray

    from divbandit._checks import Rng
    from divbandit.box import BoxLike


class _Open(NamedTuple):
    """A trial asked for and not yet told."""

    trial: Trial
    command: NDArray[np.float64]
    proposed: Trial
    beliefs: tuple[float, ...] | None


class Explorer:
    """An exploration that is driven from outside, one trial at a time.

    Parameters
    ----------
    strategy : Strategy
        Is copied; the one given is never changed.
    motor_space : Box or object with ``low`` and ``high``
        M, the box of all motor commands.
    sensory_space : Box or object with ``low`` and ``high``, optional
        A box in S from which goals make sense.
    rng : None, int, SeedSequence or Generator
        All randomness comes from it; a Generator is drawn from, not copied.

    Attributes
    ----------
    history : History
        All that was told so far.
    rng : numpy.random.Generator
        Where all randomness comes from.

    Raises
    ------
    TypeError, ValueError
        If an argument is not what it must be, or the strategy cannot explore these spaces.

    Examples
    --------
    >>> import divbandit as db
    >>> arm = db.PlanarArm(20)
    >>> explorer = db.Explorer(db.GoalBabbling(0.05), arm.motor_space, arm.sensory_space, rng=0)
    >>> for _ in range(10):
    ...     trial = explorer.ask()
    ...     explorer.tell(trial, arm(trial.command))
    >>> len(explorer.history)
    10
    """

    def __init__(
        self,
        strategy: Strategy,
        motor_space: BoxLike,
        sensory_space: BoxLike | None = None,
        *,
        rng: Rng = None,
    ) -> None:
        if not isinstance(strategy, Strategy):
            raise TypeError(f"strategy must be a Strategy, got {type(strategy).__name__}")
        self.history = History(motor_space, sensory_space)
        space, goals = self.history.motor_space, self.history.sensory_space
        strategy.check(space, self.history.effect_dim, has_goals=goals is not None)
        self._strategy = copy.deepcopy(strategy)
        self.rng = generator(rng)
        self._bounds = space.bounds
        self._asked = 0
        self._open: dict[int, _Open] = {}
        # What the bandit believed, by the step's place in the history.
        self._beliefs: dict[int, tuple[float, ...]] = {}
        self._dim_is_checked = self.history.effect_dim is not None

    @property
    def strategy(self) -> Strategy:
        """The explorer's own copy of the strategy, with all that it has learned."""
        return self._strategy

    def ask(self) -> Trial:
        """Return a trial: evaluate its command, then tell its effect.

        Returns
        -------
        Trial
            With a read-only ``command`` of shape (m,), the ``goal`` if the strategy has one,
            and the ``path`` of who proposed it.

        Raises
        ------
        TypeError, ValueError
            If the strategy proposes what is no point of the motor space. The history is then as
            it was; the generator and the strategy have moved on.

        Examples
        --------
        >>> import divbandit as db
        >>> explorer = db.Explorer(db.MotorBabbling(), db.Box([0, 0], [1, 1]), rng=0)
        >>> explorer.ask().command
        array([0.63696169, 0.26978671])
        """
        proposed = Trial.of(self._strategy.propose(self.history, self.rng))
        # A copy, so that nobody who changes an array in place changes the log.
        try:
            command = self._bounds.command(proposed.command)
        except (TypeError, ValueError) as error:
            who = f"proposed by {self._strategy!r}, path {proposed.path}"
            raise type(error)(f"{error} ({who})") from None
        trial = Trial(command, goal=proposed.goal)
        trial.path, trial.inner, trial.number = proposed.path, proposed, self._asked
        self._open[self._asked] = _Open(trial, command, proposed, self._strategy.diversities)
        self._asked += 1
        return trial

    def tell(self, trial: Trial, effect: ArrayLike) -> None:
        """Record the effect of a trial and let the strategy learn from it.

        Parameters
        ----------
        trial : Trial
            One that this explorer gave out and has not been told of yet.
        effect : array_like, shape (s,)

        Raises
        ------
        TypeError, ValueError
            If the trial is another's or was told before, or the effect is not finite or of the
            wrong length; nothing is recorded then, and the trial can still be told.
        Exception
            What a strategy of one's own raises when it observes; the effect is then recorded.

        Examples
        --------
        >>> import divbandit as db
        >>> explorer = db.Explorer(db.MotorBabbling(), db.Box([0], [1]), rng=0)
        >>> trial = explorer.ask()
        >>> explorer.tell(trial, [3.0])
        >>> explorer.tell(trial, [3.0])
        Traceback (most recent call last):
            ...
        ValueError: trial must be one that this explorer asked for and was not told of yet
        """
        if not isinstance(trial, Trial):
            raise TypeError(f"trial must be a Trial, got {type(trial).__name__}")
        number = -1 if trial.number is None else trial.number
        known = self._open.get(number)
        if known is None or known.trial is not trial:
            raise ValueError(
                "trial must be one that this explorer asked for and was not told of yet"
            )
        history = self.history
        point = as_point("effect", effect, history.effect_dim)
        if not self._dim_is_checked:  # the first effect tells the dimension
            self._strategy.check(history.motor_space, len(point), has_goals=False)
            self._dim_is_checked = True
        if known.beliefs is not None:
            self._beliefs[len(history)] = known.beliefs
        history.record(known.command, point, known.proposed.path)
        del self._open[number]
        self._strategy.observe(known.proposed, point)

    def result(self, *, keep_commands: bool = True) -> Exploration:
        """Return all that was told so far as an Exploration, to plot or save.

        Parameters
        ----------
        keep_commands : bool
            False leaves the motor commands out.

        Examples
        --------
        >>> import divbandit as db
        >>> explorer = db.Explorer(db.MotorBabbling(), db.Box([0], [1]), rng=0)
        >>> explorer.tell(explorer.ask(), [3.0])
        >>> explorer.result().effects
        array([[3.]])
        """
        truth("keep_commands", keep_commands)
        return Exploration.from_history(self.history, self._beliefs, keep_commands=keep_commands)

    def __repr__(self) -> str:
        return f"<Explorer of {self._strategy!r} after {len(self.history)} evaluations>"
