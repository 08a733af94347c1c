"""replay: all that happened to an explorer, done again with a fresh one."""

from __future__ import annotations

from typing import TYPE_CHECKING, NamedTuple

import numpy as np

from divbandit.exploration.journal import Event

if TYPE_CHECKING:
    from collections.abc import Iterator

    from numpy.typing import NDArray

    from divbandit.exploration.explorer import Explorer
    from divbandit.strategies.base import Trial


class OtherwiseError(Exception):
    """What is done again comes out otherwise; the text says what."""


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
    written : numpy.ndarray, shape (k, m)
        The commands of those effects that came into the history past the explorer.
    paths : list of tuple of int
        Who chose these.
    reasons : list of str
        Why trials failed.
    """

    events: list[tuple[int, int, str]]
    commands: NDArray[np.float64]
    effects: NDArray[np.float64]
    written: NDArray[np.float64]
    paths: list[tuple[int, ...]]
    reasons: list[str]

    def check(self) -> None:
        """Raise a ValueError unless it can have happened, and all that is here belongs to it."""
        asked = known = failed = written = 0
        under_way: set[int] = set()
        for event, number, how in self._singly():
            if event in {Event.ASK, Event.ASK_MANY}:
                count = 0 if how else number if event == Event.ASK_MANY else 1
                under_way.update(range(asked, min(asked + count, len(self.commands))))
                asked += count
            elif event == Event.WRITTEN:
                known, written = known + number, written + number
            elif event in {Event.TELL, Event.FAIL}:
                under_way.remove(number)
                known, failed = known + (event == Event.TELL), failed + (event == Event.FAIL)
        found = len(self.commands), len(self.effects), len(self.reasons)
        others = len(self.written), len(self.paths)
        if found != (asked, known, failed) or others != (written, written):
            raise ValueError("events must be as many as there are commands, effects and reasons")

    def _singly(self) -> Iterator[tuple[int, int, str]]:
        """Return the events, and check that trials told at once follow one another."""
        missing = 0
        for event, number, how in self.events:
            if number < 0 or event > Event.WRITTEN:
                raise ValueError(f"events must be known ones, got {event} of {number}")
            if missing and event != Event.TELL:
                raise ValueError("events must have trials that were told at once together")
            missing = number if event == Event.TELL_MANY else max(0, missing - 1)
            yield event, number, how
        if missing:
            raise ValueError("events must have all trials that were told at once")


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
    >>> replay(explorer, Past(events, np.array([[0.5]]), empty, empty, [], []))
    Traceback (most recent call last):
        ...
    divbandit.exploration.replay.OtherwiseError: it proposes another command for trial 0
    """
    _Replay(explorer, past).run()


class _Replay:
    """What is left of the past, while it is done again."""

    def __init__(self, explorer: Explorer, past: Past) -> None:
        self._explorer, self._past = explorer, past
        self._events = iter(past.events)
        self._effects, self._reasons = iter(past.effects), iter(past.reasons)
        self._written = iter(zip(past.written, past.paths, strict=True))
        self._asked = 0
        self._open: dict[int, Trial] = {}

    def run(self) -> None:
        deeds = {
            Event.ASK: self._ask,
            Event.ASK_MANY: self._ask_many,
            Event.TELL: self._tell,
            Event.TELL_MANY: self._tell_many,
            Event.FAIL: self._fail,
            Event.WRITTEN: self._write,
        }
        for event, number, how in self._events:
            if how == "interrupted" and event in {Event.ASK, Event.ASK_MANY}:
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
        self._compare([self._explorer.ask()])

    def _ask_many(self, count: int) -> None:
        self._compare(list(self._explorer.ask(count)))

    def _compare(self, given: list[Trial]) -> None:
        for trial in given:
            command = np.asarray(trial.command)
            if command.tobytes() != self._past.commands[self._asked].tobytes():
                raise OtherwiseError(f"it proposes another command for trial {self._asked}")
            self._open[self._asked] = trial
            self._asked += 1

    def _tell(self, number: int) -> None:
        self._explorer.tell(self._open.pop(number), next(self._effects))

    def _tell_many(self, count: int) -> None:
        # All is taken before the strategy learns of it: it may raise again what it raised.
        trials = [self._open.pop(next(self._events)[1]) for _ in range(count)]
        effects = np.array([next(self._effects) for _ in range(count)])
        self._explorer.tell(trials, effects)

    def _fail(self, number: int) -> None:
        self._explorer.fail(self._open.pop(number), next(self._reasons))

    def _write(self, count: int) -> None:
        for _ in range(count):
            command, path = next(self._written)
            self._explorer.history.append(command, next(self._effects), path=path)
