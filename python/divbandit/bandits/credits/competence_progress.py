"""CompetenceProgress: credit for coming nearer to a goal than ever before."""

from __future__ import annotations

from math import sqrt
from typing import TYPE_CHECKING, Any

from divbandit._core import NearestNeighbors, as_point

if TYPE_CHECKING:
    from collections.abc import Sequence

    import numpy as np
    from numpy.typing import NDArray

    from divbandit.history import History
    from divbandit.strategies.base import Trial


class CompetenceProgress:
    """By how much the nearest effect to the trial's goal has come nearer, in units of the effects.

    The distance from the goal to the nearest effect known before, less that to the new effect; 0
    where this is negative, where the trial has no goal, and for the first effect of all. In the
    spirit of the competence progress of Baranes and Oudeyer (2013, "Active Learning of Inverse
    Models with Intrinsically Motivated Goal Exploration in Robots", Robotics and Autonomous
    Systems 61(1), 49-73), with the nearest effect known as the competence for a goal.

    Motor babbling has no goals and earns nothing by it: choose it by a share at random.

    Examples
    --------
    >>> import divbandit as db
    >>> from divbandit.bandits import CompetenceProgress, EpsilonGreedy, RecentWindow
    >>> babblings = [db.GoalBabbling(d) for d in (0.01, 0.05, 0.5)]
    >>> bandit = db.Bandit(
    ...     babblings,
    ...     credit=CompetenceProgress(),
    ...     memory=RecentWindow(100),
    ...     rule=EpsilonGreedy(0.1),
    ... )
    >>> run = db.explore(db.PlanarArm(20), bandit, n=200, rng=0)
    >>> run.diversities.shape
    (200, 3)
    """

    def __init__(self) -> None:
        self._tree: NearestNeighbors | None = None

    def largest(self, dim: int) -> float:
        """Return 0.0: progress has no bound."""
        del dim
        return 0.0

    def of(self, trial: Trial, effect: NDArray[np.float64], history: History) -> float:
        """Return the progress towards the trial's goal."""
        place = trial.place
        if place is None:
            raise ValueError("trial must have the place of its effect in the history")
        if trial.goal is None or place == 0:
            return 0.0
        effects = history.effects
        goal = as_point("goal", trial.goal, effects.shape[1])
        _, nearest = self._before(place, effects).nearest(goal)
        progress = _distance(goal, effects[nearest]) - _distance(goal, effect)
        # In this order: of two distances beyond all numbers, whose difference is none, 0.0 remains.
        return max(0.0, progress)

    def of_many(
        self, trials: Sequence[Trial], effects: NDArray[np.float64], history: History
    ) -> list[float]:
        """Return the progress of each, given all before it in the history."""
        return [
            self.of(trial, effect, history) for trial, effect in zip(trials, effects, strict=True)
        ]

    def _before(self, place: int, effects: NDArray[np.float64]) -> NearestNeighbors:
        """Return the k-d tree of the first `place` effects."""
        tree = self._tree
        if tree is None or len(tree) > place:  # too far, and points cannot be taken out
            tree = self._tree = NearestNeighbors(effects.shape[1])
        if len(tree) < place:
            tree.extend(effects[len(tree) : place])
        return tree

    def __getstate__(self) -> dict[str, Any]:
        """Leave out the tree: it is made anew from the history."""
        return {**self.__dict__, "_tree": None}

    def __repr__(self) -> str:
        return "CompetenceProgress()"


def _distance(one: NDArray[np.float64], other: NDArray[np.float64]) -> float:
    """Return the Euclidean distance, by plain operations in order; nothing overflows in between."""
    differences = [abs(x - y) for x, y in zip(one.tolist(), other.tolist(), strict=True)]
    largest: float = max(differences)
    if not 0.0 < largest < float("inf"):
        return largest
    total = 0.0
    for difference in differences:
        share = difference / largest
        total += share * share
    return largest * sqrt(total)
