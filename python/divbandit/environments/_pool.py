"""Pool: objects that are slow to make and serve one user at a time, kept for reuse."""

from __future__ import annotations

import threading
from contextlib import contextmanager, suppress
from typing import TYPE_CHECKING, Generic, Protocol, TypeVar

if TYPE_CHECKING:
    from collections.abc import Callable, Iterator


class _Closes(Protocol):
    def close(self) -> object: ...


T = TypeVar("T", bound=_Closes)


class Pool(Generic[T]):
    """Idle objects, lent to one user at a time; never more than were in use at once.

    Parameters
    ----------
    make : callable
        Makes an object.

    Examples
    --------
    >>> from io import StringIO
    >>> pool = Pool(StringIO)
    >>> with pool.borrow() as first, pool.borrow() as second:
    ...     first is second
    False
    >>> with pool.borrow() as again:
    ...     again in (first, second)
    True
    >>> pool.close()
    >>> first.closed, second.closed
    (True, True)
    """

    def __init__(self, make: Callable[[], T]) -> None:
        self._make = make
        self._lock = threading.Lock()
        self._idle: list[T] = []
        self._era = 0  # how often it was closed

    @contextmanager
    def borrow(self) -> Iterator[T]:
        """Lend an idle object, or a new one; it is closed if an error occurs meanwhile."""
        with self._lock:
            era = self._era
            lent = self._idle.pop() if self._idle else None
        if lent is None:
            lent = self._make()
        try:
            yield lent
        except BaseException:
            with suppress(Exception):  # the first error matters more
                lent.close()
            raise
        with self._lock:
            is_kept = era == self._era
            if is_kept:
                self._idle.append(lent)
        if not is_kept:
            lent.close()

    def close(self) -> None:
        """Close the idle objects now, and those in use when they are returned."""
        with self._lock:
            idle, self._idle = self._idle, []
            self._era += 1
        for one in idle:
            one.close()
