"""Journal: what an explorer was asked and told, in order, so that it can be replayed."""

from __future__ import annotations

from array import array
from contextlib import suppress
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from collections.abc import Iterable, Iterator

    from numpy.random import Generator


class Event:
    """What can happen to an explorer; the number that goes with it is in brackets.

    Plain numbers: an enumeration takes three times as long to note.
    """

    ASK = 0
    RUN = 1  # how many trials, each asked for and told before the next
    TELL = 2  # the number of the trial
    FAIL = 3  # the number of the trial
    PAST = 4  # how many earlier evaluations were added


#: Added to an event: the strategy raised an exception; was interrupted, as by Ctrl-C.
_RAISED = 8
_INTERRUPTED = 16
_SHIFT = 5


class Journal:
    """All that happened to an explorer, in eight bytes an event, and how it began.

    Attributes
    ----------
    generator_state : dict or None
        That of its generator at the beginning; None where it is not known.
    events : array of int
        As `note` left them.
    failed : list of int
        The numbers of the trials that failed, in order.

    Examples
    --------
    >>> import numpy as np
    >>> journal = Journal(np.random.default_rng(0))
    >>> journal.note(Event.ASK, 0)
    >>> journal.note(Event.TELL, 0, raised=ValueError())
    >>> list(events_of(journal.events))
    [(0, 0, ''), (2, 0, 'raised')]
    """

    __slots__ = ("events", "failed", "generator_state")

    def __init__(self, rng: Generator) -> None:
        self.generator_state: dict[str, Any] | None = None
        with suppress(NotImplementedError):  # a user's bit generator need not tell it
            self.generator_state = dict(rng.bit_generator.state)
        self.events = array("q")
        self.failed: list[int] = []

    def note(self, event: int, number: int, *, raised: BaseException | None = None) -> None:
        """Note that something happened, and what the strategy raised.

        Examples
        --------
        >>> import numpy as np
        >>> journal = Journal(np.random.default_rng(0))
        >>> journal.note(Event.RUN, 3)
        >>> len(journal.events)
        1
        """
        flag = 0
        if raised is not None:
            flag = _RAISED if isinstance(raised, Exception) else _INTERRUPTED
        self.events.append(number << _SHIFT | event | flag)


def events_of(events: Iterable[int]) -> Iterator[tuple[int, int, str]]:
    """Return each event, its number, and "raised" or "interrupted" where the strategy was.

    Examples
    --------
    >>> list(events_of([3 << 5 | 1]))
    [(1, 3, '')]
    """
    for code in events:
        how = "raised" if code & _RAISED else "interrupted" if code & _INTERRUPTED else ""
        yield code & (_RAISED - 1), code >> _SHIFT, how
