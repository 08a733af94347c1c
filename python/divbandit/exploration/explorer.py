"""Explorer: ask for a command, evaluate it anywhere, tell the effect."""

from __future__ import annotations

import copy
from collections.abc import Sequence
from typing import TYPE_CHECKING, overload

import numpy as np

from divbandit._checks import generator, truth, whole
from divbandit._core import as_point
from divbandit.exploration import saved
from divbandit.exploration.journal import Event, Journal
from divbandit.exploration.result import Exploration
from divbandit.exploration.trials import Trials
from divbandit.history import History
from divbandit.measures.points import many
from divbandit.strategies.base import Strategy, Trial
from divbandit.strategies.composite import proposals_of

if TYPE_CHECKING:
    import os

    from numpy.typing import ArrayLike, NDArray

    from divbandit._checks import Rng
    from divbandit.box import BoxLike

    #: A trial that is under way, the command that it was given out with, what the strategy
    #: proposed, and what a bandit believed.
    Open = tuple[Trial, NDArray[np.float64], Trial, tuple[float, ...] | None]

_NOT_MINE = "trial must be one that this explorer asked for and was not told of yet"


class Explorer:
    """An exploration that is driven from outside: ask for trials, tell their effects.

    Any number of trials may be under way, and they may be told in any order, or have failed. The
    history is in the order of telling, and so are gains: an effect's gain is what it adds to all
    that was told before it. The effects of one call of `tell` are told one after the other.

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
        self._journal = Journal(self.rng)
        # What the strategy was when it was first asked.
        self._began_as: str | None = None
        self._bounds = space.bounds
        self._asked = 0
        self._open: dict[int, Open] = {}
        # How many effects the history had when this explorer last looked.
        self._known = 0
        # What the bandit believed, by the step's place in the history.
        self._beliefs: dict[int, tuple[float, ...]] = {}
        self._dim_is_checked = self.history.effect_dim is not None

    @property
    def strategy(self) -> Strategy:
        """The explorer's own copy of the strategy, with all that it has learned."""
        return self._strategy

    @property
    def open_trials(self) -> tuple[Trial, ...]:
        """The trials that are under way, in the order in which they were given out."""
        return tuple(trial for trial, *_ in self._open.values())

    @overload
    def ask(self) -> Trial: ...
    @overload
    def ask(self, n: int) -> Trials: ...
    def ask(self, n: int | None = None) -> Trial | Trials:
        """Return a trial, or many: evaluate its command, then tell its effect.

        Parameters
        ----------
        n : int, optional
            How many trials to return, at least 1. A composite strategy then chooses `n` times
            before the first of its parts proposes anything, and each proposes its share.

        Returns
        -------
        Trial
            With a read-only ``command`` of shape (m,), the ``goal`` if the strategy has one,
            and the ``path`` of who proposed it.
        Trials
            A sequence of `n` of them, if `n` is given, with all their ``commands``, (n, m).

        Raises
        ------
        TypeError, ValueError
            If the strategy proposes what is no point of the motor space. The history is then as
            it was, and no trial was given out; the generator and the strategy have moved on.

        Examples
        --------
        >>> import divbandit as db
        >>> explorer = db.Explorer(db.MotorBabbling(), db.Box([0, 0], [1, 1]), rng=0)
        >>> explorer.ask().command
        array([0.63696169, 0.26978671])
        >>> explorer.ask(3).commands.shape
        (3, 2)
        """
        if self._began_as is None:
            self._began_as = repr(self._strategy)
        if n is not None:
            return self._ask_many(whole("n", n, low=1))
        if len(self.history) != self._known:
            self._note_what_others_wrote()
        try:
            proposed = Trial.of(self._strategy.propose(self.history, self.rng))
            command = self._checked(proposed)
            (trial,) = self._give_out([proposed], [command], self._strategy.diversities)
        except BaseException as error:
            self._journal.note(Event.ASK, 0, raised=error)
            raise
        self._journal.note(Event.ASK, 0)
        return trial

    def _ask_many(self, n: int) -> Trials:
        if len(self.history) != self._known:
            self._note_what_others_wrote()
        try:
            proposed = proposals_of(self._strategy, self.history, n, self.rng)
            beliefs = self._strategy.diversities
            commands = self._bounds.gather([trial.command for trial in proposed])
            if commands is None:  # one by one: lists, other types, and what is wrong with one
                commands = np.array([self._checked(trial) for trial in proposed])
                commands.flags.writeable = False
            trials = self._give_out(proposed, list(commands), beliefs)
        except BaseException as error:
            self._journal.note(Event.ASK_MANY, n, raised=error)
            raise
        self._journal.note(Event.ASK_MANY, n)
        return Trials(trials, commands)

    def _checked(self, proposed: Trial) -> NDArray[np.float64]:
        """Return a copy of the command, so that nobody who changes an array changes the log."""
        try:
            return self._bounds.command(proposed.command)
        except (TypeError, ValueError) as error:
            who = f"proposed by {self._strategy!r}, path {proposed.path}"
            raise type(error)(f"{error} ({who})") from None

    def _give_out(
        self,
        proposals: list[Trial],
        commands: list[NDArray[np.float64]],
        beliefs: tuple[float, ...] | None,
    ) -> list[Trial]:
        """Return trials of the explorer's own, which are under way from now on."""
        number, under_way, new = self._asked, self._open, object.__new__
        trials = []
        for proposed, command in zip(proposals, commands, strict=True):
            trial = new(Trial)  # quicker than by its constructor
            trial.command, trial.goal, trial.path = command, proposed.goal, proposed.path
            trial.inner, trial.number = proposed, number
            trial.place, trial.probability = None, proposed.probability
            under_way[number] = (trial, command, proposed, beliefs)
            number += 1
            trials.append(trial)
        self._asked = number
        return trials

    @overload
    def tell(self, trial: Trial, effect: ArrayLike) -> None: ...
    @overload
    def tell(self, trial: Sequence[Trial], effect: ArrayLike) -> None: ...
    def tell(self, trial: Trial | Sequence[Trial], effect: ArrayLike) -> None:
        """Record the effect of a trial, or of many, and let the strategy learn from it.

        Parameters
        ----------
        trial : Trial, or sequence of n Trial
            Given out by this explorer and not told of yet.
        effect : array_like, shape (s,) or (n, s)
            Those of many are told one after the other: it comes to the same as `n` calls.

        Raises
        ------
        TypeError, ValueError
            If a trial is another's or was told before, or an effect is not finite or of the
            wrong length; nothing is recorded then, and the trials can still be told.
        Exception
            What a strategy of one's own raises when it observes; that effect, and those before
            it, are then recorded.

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
            self._tell_many(trial, effect)
            return
        number, (_, command, proposed, beliefs) = self._find(trial)
        history = self.history
        point = as_point("effect", effect, history.effect_dim)
        if not self._dim_is_checked:
            self._check_dim(len(point))
        place = len(history)
        if place != self._known:
            self._note_what_others_wrote()
        if beliefs is not None:
            self._beliefs[place] = beliefs
        history.record(command, point, proposed.path)
        del self._open[number]
        self._known = place + 1
        trial.place = proposed.place = place
        try:
            self._strategy.observe(proposed, point)
        except BaseException as error:
            self._journal.note(Event.TELL, number, raised=error)
            raise
        self._journal.note(Event.TELL, number)

    def _find(self, trial: object) -> tuple[int, Open]:
        """Return the number of a trial that is under way, and what is known of it."""
        if not isinstance(trial, Trial):
            raise TypeError(f"trial must hold Trials only, got {type(trial).__name__}")
        number = trial.number
        known = None if number is None else self._open.get(number)
        if number is None or known is None or known[0] is not trial:
            raise ValueError(_NOT_MINE)
        return number, known

    def _check_dim(self, dim: int) -> None:
        """Let the strategy see the dimension, which the first effect tells."""
        self._strategy.check(self.history.motor_space, dim, has_goals=False)
        self._dim_is_checked = True

    def _tell_many(self, trials: Sequence[object], effects: ArrayLike) -> None:
        if not isinstance(trials, Sequence):
            kind = type(trials).__name__
            raise TypeError(f"trial must be a Trial, or a sequence of them, got {kind}")
        found: dict[int, Open] = {}
        under_way = self._open
        for each in trials:  # as `_find`; a hundred calls of that take as long as all else here
            number = each.number if isinstance(each, Trial) else None
            opened = None if number is None else under_way.get(number)
            if number is None or opened is None or opened[0] is not each:
                number, opened = self._find(each)  # says what is wrong
            found[number] = opened
        if len(found) < len(trials):
            raise ValueError("trial must hold each trial once")
        points = many("effect", effects, self.history.effect_dim).copy()
        points.flags.writeable = False
        if len(points) != len(found):
            raise ValueError(f"effect must have shape ({len(found)}, s), got {points.shape}")
        if not found:
            return
        if not self._dim_is_checked:
            self._check_dim(points.shape[1])
        if not self._strategy.learns_at_once:
            for known, point in zip(found.values(), points, strict=True):
                self.tell(known[0], point)
            return
        self._tell_at_once(found, points)

    def _tell_at_once(self, found: dict[int, Open], points: NDArray[np.float64]) -> None:
        place = len(self.history)
        if place != self._known:
            self._note_what_others_wrote()
        trials, commands, proposals, beliefs = zip(*found.values(), strict=True)
        under_way, known = self._open, self._beliefs
        rows = zip(found, trials, proposals, beliefs, strict=True)
        for row, (number, trial, proposed, believed) in enumerate(rows, place):
            trial.place = proposed.place = row
            if believed is not None:
                known[row] = believed
            del under_way[number]
        block = _block_of(list(found), commands)
        self.history.record_many(block, points, [each.path for each in proposals])
        self._known = place + len(found)
        try:
            self._strategy.observe_many(proposals, points)
        except BaseException as error:
            self._journal.note_many(Event.TELL_MANY, found, raised=error)
            raise
        self._journal.note_many(Event.TELL_MANY, found)

    def fail(self, trial: Trial, reason: str) -> None:
        """Record that the evaluation of a trial came to nothing: the robot fell over.

        The budget is spent, and there is no effect: neither the history's effects nor any measure
        change. ``history.failures`` tells of it. A bandit takes it for a trial without any gain.

        Parameters
        ----------
        trial : Trial
            Given out by this explorer and not told of yet.
        reason : str
            What went wrong, for the log.

        Raises
        ------
        TypeError, ValueError
            If the trial is another's or was told before, or the reason is no text; nothing is
            recorded then.
        Exception
            What a strategy of one's own raises when it learns of it; that is then recorded.

        Examples
        --------
        >>> import divbandit as db
        >>> explorer = db.Explorer(db.MotorBabbling(), db.Box([0], [1]), rng=0)
        >>> explorer.fail(explorer.ask(), "the robot fell over")
        >>> len(explorer.history), len(explorer.history.failures)
        (0, 1)
        """
        if not isinstance(trial, Trial):
            raise TypeError(f"trial must be a Trial, got {type(trial).__name__}")
        if not isinstance(reason, str):
            raise TypeError(f"reason must be a text, got {type(reason).__name__}")
        number, (_, command, proposed, _) = self._find(trial)
        if len(self.history) != self._known:
            self._note_what_others_wrote()
        self.history.record_failure(command, reason, proposed.path)
        self._journal.failed.append(number)
        del self._open[number]
        try:
            self._strategy.fail(proposed, reason)
        except BaseException as error:
            self._journal.note(Event.FAIL, number, raised=error)
            raise
        self._journal.note(Event.FAIL, number)

    def _note_what_others_wrote(self) -> None:
        """Note effects that came into the history past this explorer."""
        self._journal.note(Event.WRITTEN, len(self.history) - self._known)
        self._known = len(self.history)

    def save(self, path: str | os.PathLike[str]) -> None:
        """Write all that is needed to go on to a file, replacing it whole or not at all.

        The file is NumPy's ``npz``; nothing in it is pickled. It holds what was asked and told,
        and the generator's state at the beginning: all else follows from these.

        Parameters
        ----------
        path : str or path
            Used as it is: no ending is added.

        Raises
        ------
        ValueError
            If the generator is none of NumPy's own, whose state can be written; or an argument of
            a built-in part was changed by hand since the first trial.
        OSError
            If the file cannot be written.

        Examples
        --------
        >>> import os, tempfile
        >>> import divbandit as db
        >>> explorer = db.Explorer(db.MotorBabbling(), db.Box([0], [1]), rng=0)
        >>> trial = explorer.ask()
        >>> with tempfile.TemporaryDirectory() as folder:
        ...     explorer.save(os.path.join(folder, "run"))
        ...     again = db.Explorer.load(os.path.join(folder, "run"))
        >>> again.open_trials[0].command == trial.command
        array([ True])
        >>> again.ask().command == explorer.ask().command
        array([ True])
        """
        if len(self.history) != self._known:
            self._note_what_others_wrote()
        commands = {number: command for number, (_, command, _, _) in self._open.items()}
        saved.write(
            path, self._strategy, self._began_as, self.history, self._journal, commands, self.rng
        )

    @classmethod
    def load(cls, path: str | os.PathLike[str], strategy: Strategy | None = None) -> Explorer:
        """Read an explorer that was saved, to go on with it bit by bit as it would have.

        All that was asked and told is done again, with the generator as it was at the beginning;
        each command must come out as it did. So a strategy of one's own needs nothing but to
        depend on what it is told and on the generator alone. Nobody else may have drawn from
        that generator.

        Parameters
        ----------
        path : str or path
        strategy : Strategy, optional
            One like that which the explorer was made with. It must be given where that has parts
            of one's own, or had been used before; those built in are in the file as they are when
            they are new.

        Returns
        -------
        Explorer
            With a generator of its own, in ``rng``, and those trials in ``open_trials`` that
            were under way.

        Raises
        ------
        TypeError
            If `strategy` is none.
        ValueError
            If the file is truncated, was not written by `save` or by another version of it,
            names no strategy and none is given, or the strategy proposes other commands than
            those in the file.
        OSError
            If the file cannot be read.

        Examples
        --------
        >>> import divbandit as db
        >>> db.Explorer.load("missing")
        Traceback (most recent call last):
            ...
        FileNotFoundError: [Errno 2] No such file or directory: 'missing'
        """
        if strategy is not None and not isinstance(strategy, Strategy):
            raise TypeError(f"strategy must be a Strategy, got {type(strategy).__name__}")
        return saved.read(path, cls, strategy)

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


def _block_of(numbers: list[int], commands: tuple[NDArray[np.float64], ...]) -> NDArray[np.float64]:
    """Return commands as the rows of one array.

    Those of a whole batch, told in the order in which they were given out, are one already.
    """
    n, m = len(commands), len(commands[0])
    block = commands[0].base
    if (
        block is not None
        and block is commands[-1].base
        and block.size == n * m
        and numbers == list(range(numbers[0], numbers[0] + n))
    ):
        return block.reshape(n, m)
    return np.array(commands)
