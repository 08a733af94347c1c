"""Callback: what is called while an explorer runs.

A callback is a function of the explorer and a trial, a `RunningCallback`; or, where it has state,
a `Callback`, whose `start` returns such a function for one run. Either may have an attribute
``every``: a number of evaluations, or a duration such as ``"0.5s"``; it is then called after that
many evaluations, or not more often than that. By default it is called after each evaluation.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Protocol, runtime_checkable

if TYPE_CHECKING:
    from typing import TypeAlias

    from divbandit._core import Trial
    from divbandit.exploration import Explorer


@runtime_checkable
class RunningCallback(Protocol):
    """What is called after evaluations: any function of an explorer and a trial.

    It may have a method ``close``, without arguments, which is called when the run has ended,
    whatever has ended it.

    See Also
    --------
    Every : calls any function less often.

    Examples
    --------
    Stop once an effect lies beyond 0.5 on the right.

    >>> import divbandit as db
    >>> def far_enough(explorer, trial):
    ...     return bool(explorer.history.effects[-1, 0] > 0.5)
    >>> arm, strategy = db.PlanarArm(20), db.GoalBabbling()
    >>> run = db.explore(arm, strategy, 999, rng=0, callbacks=[far_enough])
    >>> len(run) < 999
    True

    Tell of failures: there is one more in the history.

    >>> def report(explorer, trial):
    ...     for failure in explorer.history.failures[report.known :]:
    ...         print(failure.reason)
    ...     report.known = len(explorer.history.failures)
    >>> report.known = 0
    """

    def __call__(self, explorer: Explorer, trial: Trial, /) -> object:
        """Look at the run; return True, and nothing else that is true, to stop it.

        Trials that are under way then are finished first.

        Parameters
        ----------
        explorer : Explorer
            It must not be asked or told; all that was observed is in its ``history``.
        trial : Trial
            The newest that was told or has failed.
        """


@runtime_checkable
class Callback(Protocol):
    """What watches runs; `start` returns what is called during one of them.

    Any object with this method will do; no base class is needed. All state of a run is in what
    `start` returns, so that one callback can watch several runs, also at once.

    See Also
    --------
    Every, Plateau, Progress, TimeBudget

    Examples
    --------
    The time of each evaluation, for a black box that is tried again and again.

    >>> import time
    >>> class Times:
    ...     def __init__(self):
    ...         self.of_runs = []
    ...     def start(self, explorer, n):
    ...         times = []
    ...         self.of_runs.append(times)
    ...         return lambda explorer, trial: times.append(time.perf_counter())
    >>> import divbandit as db
    >>> isinstance(Times(), db.callbacks.Callback)
    True
    """

    def start(self, explorer: Explorer, n: int | None, /) -> RunningCallback:
        """Return what is called during one run, which is about to begin.

        Parameters
        ----------
        explorer : Explorer
            It may have a history already.
        n : int or None
            How many evaluations the run is to make, at most; None if that is not known.

        Raises
        ------
        TypeError, ValueError
            If it cannot watch this run, which then does not begin.

        Examples
        --------
        >>> import divbandit as db
        >>> arm = db.PlanarArm(20)
        >>> explorer = db.Explorer(db.MotorBabbling(), arm.motor_space, arm.sensory_space, rng=0)
        >>> over = db.callbacks.TimeBudget("2h").start(explorer, 1000)
        >>> trial = explorer.ask()
        >>> explorer.tell(trial, arm(trial.command))
        >>> over(explorer, trial)
        False
        """


#: What `Explorer.run` takes.
CallbackLike: TypeAlias = Callback | RunningCallback


def check_callback(name: str, value: object) -> CallbackLike:
    """Return a callback, or say what is wrong with it.

    Examples
    --------
    >>> from divbandit.callbacks import Progress
    >>> check_callback("callbacks[0]", Progress)
    Traceback (most recent call last):
        ...
    TypeError: callbacks[0] must be a function of an explorer and a trial, or have start, such as TimeBudget("2h"), got the class Progress
    """  # noqa: E501 - a message is one line
    # `isinstance` with a Protocol also accepts classes.
    if isinstance(value, type) or not isinstance(value, (Callback, RunningCallback)):
        kind = f"the class {value.__name__}" if isinstance(value, type) else type(value).__name__
        raise TypeError(
            f"{name} must be a function of an explorer and a trial, or have start, "
            f'such as TimeBudget("2h"), got {kind}'
        )
    return value


def start_callback(callback: CallbackLike, explorer: Explorer, n: int | None) -> RunningCallback:
    """Return what is called during one run: the callback itself, if it does not start anything.

    Examples
    --------
    >>> import divbandit as db
    >>> explorer = db.Explorer(db.MotorBabbling(), db.Box([0], [1]), rng=0)
    >>> start_callback(print, explorer, 10)
    <built-in function print>
    """
    if isinstance(callback, Callback):
        return callback.start(explorer, n)
    return callback
