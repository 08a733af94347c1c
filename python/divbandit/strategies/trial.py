"""Trial: a motor command that a strategy proposes, and why."""

from __future__ import annotations

from dataclasses import KW_ONLY, dataclass
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from numpy.typing import ArrayLike


@dataclass(frozen=True, eq=False)
class Trial:
    """A motor command that a strategy proposes, and why.

    Parameters
    ----------
    command : array_like, shape (m,)
        The motor command.
    goal : array_like, shape (s,), optional
        The effect that it is meant to bring about.

    Attributes
    ----------
    command, goal
        As given.
    path : tuple of int
        Who proposed it: indices of strategies, outermost first. Empty where one strategy
        explores alone.
    probability : float or None
        The probability with which the outermost strategy, a bandit, chose who proposed it; None
        where that is not known.
    inner : Trial or None
        For a trial of a composite strategy: the very trial that its part proposed.
    number : int or None
        For a trial that an Explorer gives out: how many it gave out before.

    Examples
    --------
    >>> import divbandit as db
    >>> trial = db.Trial([0.5, 0.5], goal=[1.0])
    >>> trial.path
    ()
    """

    command: ArrayLike
    _: KW_ONLY
    goal: ArrayLike | None = None
    path: tuple[int, ...] = ()
    probability: float | None = None
    inner: Trial | None = None
    number: int | None = None

    @classmethod
    def of(cls, proposal: Trial | ArrayLike) -> Trial:
        """Return what a strategy proposed as a Trial if it is not one already.

        Examples
        --------
        >>> import divbandit as db
        >>> db.Trial.of([0.5]).command
        [0.5]
        """
        return proposal if isinstance(proposal, Trial) else cls(proposal)

    def proposed_by(self, index: int, probability: float | None = None) -> Trial:
        """Return this trial as one of a composite strategy, whose part `index` proposed it.

        Parameters
        ----------
        index : int
        probability : float, optional
            With which probability that part was chosen.

        Examples
        --------
        >>> import divbandit as db
        >>> db.Trial([0.5]).proposed_by(1).proposed_by(0).path
        (0, 1)
        """
        return Trial(
            self.command,
            goal=self.goal,
            path=(index, *self.path),
            probability=probability,
            inner=self,
        )
