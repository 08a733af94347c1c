"""Summary: the few numbers that a comparison of many explorations needs."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass
from typing import TYPE_CHECKING, NamedTuple

import numpy as np

from divbandit._checks import whole
from divbandit.exploration import Exploration
from divbandit.measures import Coverage

if TYPE_CHECKING:
    from collections.abc import Callable

    from numpy.typing import NDArray


class Summary(NamedTuple):
    """What `summarize` keeps of an exploration.

    Attributes
    ----------
    coverage : numpy.ndarray of float64, shape (k,)
        After each of k steps, in the units of the effects to the power of their dimension.
    usage : numpy.ndarray of float64, shape (q,)
        The fraction of steps for which each part of the top-level strategy was chosen, in [0, 1].

    Examples
    --------
    >>> import numpy as np
    >>> import divbandit as db
    >>> db.experiments.Summary(coverage=np.array([2.25]), usage=np.array([0.25, 0.75])).usage
    array([0.25, 0.75])
    """

    coverage: NDArray[np.float64]
    usage: NDArray[np.float64]


def summarize(tau: float, *, at: Iterable[int] | None = None) -> Callable[[Exploration], Summary]:
    """Return a function that summarizes an Exploration, for `explore_many` to ``keep``.

    Parameters
    ----------
    tau : float
        Radius of the balls, in the units of the effects; positive.
    at : iterable of int, optional
        The evaluations after which to take the coverage, from 1 on: those that failed are among
        them, and those of the past. By default the last.

    Returns
    -------
    callable
        Takes an Exploration and returns a Summary. For a bandit, ``usage`` has an element for each
        part. For other strategies only the choices are known: it then has elements up to the last
        part that was chosen, and a single one if there are no parts.

    Raises
    ------
    TypeError, ValueError
        If `tau` is not a positive number or `at` is not an iterable of counts. The returned
        function raises them if the exploration has fewer steps, or none, or if `Coverage` does not
        support the dimension of its effects.

    Examples
    --------
    >>> import divbandit as db
    >>> adapt = db.Adapt([db.MotorBabbling(), db.GoalBabbling(0.05)], tau=0.02)
    >>> task = db.experiments.Task(db.PlanarArm(20), adapt, n=500)
    >>> summarize = db.experiments.summarize(0.02, at=[100, 500])
    >>> many = db.explore_many(task.over(range(4)), keep=summarize)
    >>> [(each.coverage.shape, each.usage.shape) for _, each in many]
    [((2,), (2,)), ((2,), (2,)), ((2,), (2,)), ((2,), (2,))]
    """
    Coverage(tau)  # raises if tau is wrong
    if at is None:
        return _Summarize(tau, None)
    if not isinstance(at, Iterable):
        raise TypeError(f"at must be an iterable of counts, such as [100], got {type(at).__name__}")
    return _Summarize(tau, tuple(whole("at", count, low=1) for count in at))


@dataclass(frozen=True, repr=False)
class _Summarize:
    """The function that `summarize` returns."""

    tau: float
    at: tuple[int, ...] | None

    def __call__(self, run: Exploration) -> Summary:
        if not isinstance(run, Exploration):
            raise TypeError(f"run must be an Exploration, got {type(run).__name__}")
        if len(run) == 0:
            raise ValueError("run must have at least one effect, got none")
        places = np.array([failure.place for failure in run.failures], dtype=np.int64)
        n = len(run) + len(places)
        counts = np.array((n,) if self.at is None else self.at, dtype=np.int64)
        for count in counts.tolist():
            whole("at", count, low=1, high=n)
        # Evaluation number `places[j] + j`, from 0, is the j-th that failed.
        failed = np.searchsorted(places + np.arange(len(places)), counts)
        coverage = np.append(0.0, run.coverage(self.tau))
        return Summary(coverage[counts - failed], _usage(run))

    def __repr__(self) -> str:
        return f"summarize({self.tau!r}, at={self.at!r})"


def _usage(run: Exploration) -> NDArray[np.float64]:
    parts = 0 if run.estimates is None else run.estimates.shape[1]
    chosen = run.choices[run.choices >= 0]  # -1 where no part of a strategy proposed
    return np.bincount(chosen, minlength=max(parts, 1)) / max(len(chosen), 1)
