"""replay: what happened to an explorer, repeated with a fresh one."""

from __future__ import annotations

from typing import TYPE_CHECKING, NamedTuple

import numpy as np

if TYPE_CHECKING:
    from collections.abc import Iterator

    from numpy.typing import NDArray

    from divbandit._core import Trial
    from divbandit.exploration.explorer import Explorer

    Points = NDArray[np.float64]
    #: Numbers of trials, and their commands.
    Numbered = tuple[NDArray[np.int64], Points]

#: The events of a journal; what goes with each is in brackets.
ASK = 0
RUN = 1  # how many trials, each asked for and told before the next
TELL = 2  # the number of the trial
FAIL = 3  # the number of the trial
PAST = 4  # how many earlier evaluations were added

#: Added to an event: the strategy raised an exception; was interrupted, as by Ctrl-C.
_RAISED = 8
_INTERRUPTED = 16
_SHIFT = 5


class OtherwiseError(Exception):
    """The repetition differs; the message says how."""


class Past(NamedTuple):
    """What happened to an explorer.

    Attributes
    ----------
    events : list of int
        As in a journal.
    commands : numpy.ndarray, shape (trials, m)
        Those of the trials that were given out, by number.
    effects : numpy.ndarray, shape (n, s)
        In the order of the history.
    added : numpy.ndarray, shape (k, m)
        The commands of the earlier evaluations that were added.
    reasons : list of str
        Why trials failed.
    """

    events: list[int]
    commands: Points
    effects: Points
    added: Points
    reasons: list[str]

    @classmethod
    def of(
        cls,
        events: NDArray[np.int64],
        rows: Points,
        effects: Points,
        failed: Numbered,
        pending: Numbered,
        reasons: list[str],
    ) -> Past:
        """Sort commands - of rows of the history, of failed and of pending trials - by trial.

        Raises
        ------
        ValueError
            If the events are not possible, or do not match the arrays.
        """
        told: list[NDArray[np.int64]] = []  # the numbers of the trials told, or -1 for an added one
        asked = 0
        under_way: set[int] = set()
        failures = []
        for event, number, how in events_of(events.tolist()):
            if number < 0 or event > PAST:
                raise ValueError(f"events must be known ones, got {event} of {number}")
            if event == ASK and not how:
                under_way.add(asked)
                asked += 1
            elif event == RUN:
                told.append(np.arange(asked, asked + number))
                asked += number
            elif event == PAST:
                told.append(np.full(number, -1))
            elif event in {TELL, FAIL}:
                under_way.remove(number)
                if event == TELL:
                    told.append(np.array([number]))
                else:
                    failures.append(number)
        numbers = np.concatenate(told) if told else np.empty(0, np.int64)
        if not (
            len(numbers) == len(rows) == len(effects)
            and failures == failed[0].tolist()
            and len(failures) == len(reasons) == len(failed[1])
            and sorted(under_way) == pending[0].tolist()
            and len(under_way) == len(pending[1])
        ):
            raise ValueError("events must match the numbers of commands, effects and reasons")
        commands = np.empty((asked, rows.shape[1]))
        commands[numbers[numbers >= 0]] = rows[numbers >= 0]
        for where, points in (failed, pending):
            commands[where] = points
        return cls(events.tolist(), commands, effects, rows[numbers < 0], reasons)


def events_of(events: list[int]) -> Iterator[tuple[int, int, str]]:
    """Return each event, its number, and "raised" or "interrupted" where the strategy was.

    Examples
    --------
    >>> list(events_of([3 << 5 | 1]))
    [(1, 3, '')]
    """
    for code in events:
        how = "raised" if code & _RAISED else "interrupted" if code & _INTERRUPTED else ""
        yield code & (_RAISED - 1), code >> _SHIFT, how


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
    >>> replay(explorer, Past([ASK], np.array([[0.5]]), empty, empty, []))
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
            ASK: self._ask,
            RUN: self._run,
            TELL: self._tell,
            FAIL: self._fail,
            PAST: self._add,
        }
        for event, number, how in events_of(self._past.events):
            if how == "interrupted" and event == ASK:
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
        if trial.command.tobytes() != self._past.commands[self._asked].tobytes():
            raise self._otherwise()
        self._open[self._asked] = trial
        self._asked += 1

    def _run(self, count: int) -> None:
        commands = self._past.commands[self._asked : self._asked + count]
        effects = self._past.effects[self._known : self._known + count]
        # All is taken before the strategy learns of it: it may raise again what it raised.
        self._asked, self._known = self._asked + count, self._known + count
        repeated = self._explorer._driver.repeat(commands, effects)  # noqa: SLF001 - its other half
        if repeated < count:
            self._asked -= count - repeated
            raise self._otherwise()

    def _tell(self, number: int) -> None:
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

    def _otherwise(self) -> OtherwiseError:
        return OtherwiseError(f"it proposes another command for trial {self._asked}")
