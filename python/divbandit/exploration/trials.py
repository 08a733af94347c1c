"""Trials: what an Explorer gives out when it is asked for several at once."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING, overload

from divbandit.strategies.base import Trial

if TYPE_CHECKING:
    from collections.abc import Iterator

    import numpy as np
    from numpy.typing import NDArray


class Trials(Sequence[Trial]):
    """Several trials, in the order in which they were proposed.

    Parameters
    ----------
    trials : sequence of Trial
    commands : numpy.ndarray, shape (n, m)
        Their commands.

    Attributes
    ----------
    commands : numpy.ndarray of float64, shape (n, m)
        Read-only: what an environment that takes many commands at once can be called with.

    Examples
    --------
    >>> import divbandit as db
    >>> arm = db.PlanarArm(20)
    >>> explorer = db.Explorer(db.MotorBabbling(), arm.motor_space, arm.sensory_space, rng=0)
    >>> trials = explorer.ask(100)
    >>> explorer.tell(trials, arm(trials.commands))
    >>> len(trials), trials[0].number, len(trials[90:])
    (100, 0, 10)
    """

    __slots__ = ("_trials", "commands")

    def __init__(self, trials: Sequence[Trial], commands: NDArray[np.float64]) -> None:
        self._trials = tuple(trials)
        self.commands = commands

    def __len__(self) -> int:
        return len(self._trials)

    @overload
    def __getitem__(self, index: int) -> Trial: ...
    @overload
    def __getitem__(self, index: slice) -> Trials: ...
    def __getitem__(self, index: int | slice) -> Trial | Trials:
        if isinstance(index, slice):
            return Trials(self._trials[index], self.commands[index])
        return self._trials[index]

    def __iter__(self) -> Iterator[Trial]:
        return iter(self._trials)

    def __repr__(self) -> str:
        return f"<{len(self)} Trials, commands {self.commands.shape}>"
