"""replay: the events of an explorer, repeated with a fresh one."""

from __future__ import annotations

from typing import TYPE_CHECKING, NamedTuple

import numpy as np

from divbandit.exploration.journal import Event

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from divbandit._core import Trial
    from divbandit.exploration.explorer import Explorer


class OtherwiseError(Exception):
    """The repetition differs; the message says how."""


class Past(NamedTuple):
    """What happened to an explorer.

    Attributes
    ----------
    events : list of (event, number, how)
        As in a `Journal`.
    commands : numpy.ndarray, shape (trials, m)
        Those of the trials that were given out, by number.
    effects : numpy.ndarray, shape (n, s)
        In the order of the history.
    added : numpy.ndarray, shape (k, m)
        The commands of the earlier evaluations that were added.
    reasons : list of str
        Why trials failed.
    """

    events: list[tuple[int, int, str]]
    commands: NDArray[np.float64]
    effects: NDArray[np.float64]
    added: NDArray[np.float64]
    reasons: list[str]

    def check(self) -> None:
        """Raise a ValueError unless the events are possible, and match the arrays."""
        asked = known = failed = added = 0
        under_way: set[int] = set()
        for event, number, how in self.events:
            if number < 0 or event > Event.PAST:
                raise ValueError(f"events must be known ones, got {event} of {number}")
            if event == Event.ASK and not how:
                under_way.add(asked)
                asked += 1
            elif event == Event.RUN:
                asked, known = asked + number, known + number
            elif event == Event.PAST:
                known, added = known + number, added + number
            elif event in {Event.TELL, Event.FAIL}:
                under_way.remove(number)
                known, failed = known + (event == Event.TELL), failed + (event == Event.FAIL)
        found = len(self.commands), len(self.effects), len(self.added), len(self.reasons)
        if found != (asked, known, added, failed):
            raise ValueError("events must match the numbers of commands, effects and reasons")


def replay(explorer: Explorer, past: Past) -> None:
    """Ask and tell a fresh explorer what another was asked and told.

    Raises
    ------
    OtherwiseError
        If its strategy proposes other commands, or raises an exception where that one did not.

    Examples
    --------
    >>> import numpy as np
    >>> import divbandit as db
    >>> explorer = db.Explorer(db.MotorBabbling(), db.Box([0], [1]), rng=0)
    >>> empty = np.empty((0, 1))
    >>> events = [(Event.ASK, 0, "")]
    >>> replay(explorer, Past(events, np.array([[0.5]]), empty, empty, []))
    Traceback (most recent call last):
        ...
    divbandit.exploration.replay.OtherwiseError: it proposes another command for trial 0
    """
    _Replay(explorer, past).run()


class _Replay:
    """What is left of the past, while it is repeated."""

    def __init__(self, explorer: Explorer, past: Past) -> None:
        self._explorer, self._past = explorer, past
        self._reasons = iter(past.reasons)
        self._asked = self._known = self._added = 0
        self._open: dict[int, Trial] = {}

    def run(self) -> None:
        deeds = {
            Event.ASK: self._ask,
            Event.RUN: self._run,
            Event.TELL: self._tell,
            Event.FAIL: self._fail,
            Event.PAST: self._add,
        }
        for event, number, how in self._past.events:
            if how == "interrupted" and event == Event.ASK:
                continue  # nothing was given out; if anything was drawn, the next command tells
            caught: Exception | None = None
            try:
                deeds[event](number)
            except OtherwiseError:
                raise
            except Exception as error:  # noqa: BLE001 - a strategy may raise anything
                caught = error
            if how != "interrupted" and bool(how) != (caught is not None):
                what = "does not raise an exception again" if how else f"raises {caught!r}"
                raise OtherwiseError(f"it {what}, after {self._asked} trials") from caught

    def _ask(self, _: int) -> None:
        trial = self._explorer.ask()
        command = np.asarray(trial.command)
        if command.tobytes() != self._past.commands[self._asked].tobytes():
            raise OtherwiseError(f"it proposes another command for trial {self._asked}")
        self._open[self._asked] = trial
        self._asked += 1

    def _run(self, count: int) -> None:
        for _ in range(count):
            self._ask(0)
            self._tell(self._asked - 1)

    def _tell(self, number: int) -> None:
        # All is taken before the strategy learns of it: it may raise again what it raised.
        trial, effect = self._open.pop(number), self._past.effects[self._known]
        self._known += 1
        self._explorer.tell(trial, effect)

    def _fail(self, number: int) -> None:
        self._explorer.fail(self._open.pop(number), next(self._reasons))

    def _add(self, count: int) -> None:
        commands = self._past.added[self._added : self._added + count]
        effects = self._past.effects[self._known : self._known + count]
        self._added, self._known = self._added + count, self._known + count
        self._explorer.add_past(commands, effects)
