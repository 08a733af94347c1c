"""Batch: solutions that an optimizer asked for together, given out one by one."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

from divbandit.strategies import Trial

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import ArrayLike, NDArray
    from typing_extensions import Self


@dataclass(frozen=True)
class Report:
    """The outcome of one solution: its effect, its objective, and its report by the archive."""

    effect: NDArray[np.float64]
    objective: float
    added: dict[str, NDArray[np.generic]]


class Batch:
    """Solutions that an optimizer asked for together; it learns once all have ended.

    Parameters
    ----------
    solutions : numpy.ndarray, shape (n, m)

    Attributes
    ----------
    solutions : numpy.ndarray, shape (n, m)
    reports : dict of Report or None
        One for each solution that has ended, by its row; None if it failed.

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
        self.reports: dict[int, Report | None] = {}
        self._given = 0

    @property
    def all_given(self) -> bool:
        """Whether every solution was given out."""
        return self._given == len(self.solutions)

    @property
    def all_ended(self) -> bool:
        """Whether every solution has an effect, or has failed."""
        return len(self.reports) == len(self.solutions)

    def take(self) -> int:
        """Give out the next solution: return its row."""
        self._given += 1
        return self._given - 1

    def end(self, row: int, report: Report | None = None) -> None:
        """Note the outcome of a solution; None if it failed."""
        self.reports[row] = report


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
    >>> OfBatch([0.5], batch=Batch(np.array([[0.5]])), row=0).row
    0
    """

    batch: Batch
    row: int

    def __new__(cls, command: ArrayLike, *, batch: Batch, row: int) -> Self:
        """Make one."""
        trial = super().__new__(cls, command)
        trial.batch, trial.row = batch, row
        return trial
