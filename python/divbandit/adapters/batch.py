"""Batch: solutions that an optimizer asked for together, given out one by one."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

from divbandit.strategies.base import Trial

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import ArrayLike, NDArray


@dataclass
class Report:
    """What came of one solution: its effect, what that is worth, what the archive made of it."""

    effect: NDArray[np.float64]
    objective: float
    added: dict[str, NDArray[np.generic]]


class Batch:
    """Solutions that an optimizer asked for together; it is told when all have come to an end.

    Parameters
    ----------
    solutions : numpy.ndarray, shape (n, m)

    Attributes
    ----------
    solutions : numpy.ndarray, shape (n, m)
    reports : list
        One for each solution; None where none is known.

    Examples
    --------
    >>> import numpy as np
    >>> batch = Batch(np.array([[0.5], [0.7]]))
    >>> batch.take(), batch.take(), batch.all_given
    (0, 1, True)
    >>> batch.end(0)
    >>> batch.all_ended
    False
    """

    def __init__(self, solutions: NDArray[np.float64]) -> None:
        self.solutions = solutions
        self.reports: list[Report | None] = [None] * len(solutions)
        self._given = 0
        self._ended: set[int] = set()

    @property
    def all_given(self) -> bool:
        """Whether every solution was given out."""
        return self._given == len(self.solutions)

    @property
    def all_ended(self) -> bool:
        """Whether every solution has an effect, or has failed."""
        return len(self._ended) == len(self.solutions)

    def take(self) -> int:
        """Give out the next solution: return its row.

        Examples
        --------
        >>> import numpy as np
        >>> Batch(np.array([[0.5], [0.7]])).take()
        0
        """
        self._given += 1
        return self._given - 1

    def end(self, row: int) -> None:
        """Note that this solution has an effect, or has failed.

        Examples
        --------
        >>> import numpy as np
        >>> batch = Batch(np.array([[0.5]]))
        >>> batch.end(batch.take())
        >>> batch.all_ended
        True
        """
        self._ended.add(row)


class OfBatch(Trial):
    """A trial of one solution of a batch.

    Parameters
    ----------
    command : array_like, shape (m,)
    batch : Batch
    row : int
        Which of its solutions.

    Examples
    --------
    >>> import numpy as np
    >>> OfBatch([0.5], Batch(np.array([[0.5]])), 0).row
    0
    """

    __slots__ = ("batch", "row")

    def __init__(self, command: ArrayLike, batch: Batch, row: int) -> None:
        super().__init__(command)
        self.batch = batch
        self.row = row
