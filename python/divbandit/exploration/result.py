"""Exploration: the record of a run, to measure, plot, save and load."""

from __future__ import annotations

from contextlib import suppress
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, cast

import numpy as np

from divbandit import _files
from divbandit._checks import whole
from divbandit._recipe import NoRecipeError, made_from, recipe_of
from divbandit.box import Box
from divbandit.exploration.describing import described
from divbandit.history import Failure, counted
from divbandit.measures import BallCoverage
from divbandit.measures.start import check_measure, start_measure

if TYPE_CHECKING:
    import os
    from collections.abc import Sequence

    from numpy.typing import NDArray

    from divbandit.history import History
    from divbandit.measures import Measure

_FORMAT = "divbandit exploration"
_VERSION = 2

#: In place of commands: the attribute is then missing.
NOT_KEPT = cast("NDArray[np.float64]", None)


@dataclass(frozen=True, eq=False, repr=False)
class Exploration:
    """The trace of an exploration: commands, effects, their strategies, a bandit's estimates.

    Attributes
    ----------
    motor_space : Box
    sensory_space : Box or None
    commands : numpy.ndarray of float64, shape (n, m)
        Missing if they were not kept.
    effects : numpy.ndarray of float64, shape (n, s)
    paths : numpy.ndarray of int64, shape (n, depth)
        Who proposed each command: indices of strategies, outermost first, -1 beyond the innermost.
    estimates : numpy.ndarray of float64, shape (n, q), or None
        The bandit's estimates of its q strategies when it chose (NaN for earlier evaluations that
        were added); None where the strategy is not a bandit.
    failures : tuple of Failure
        The failed evaluations; they are not among the n.
    names : tuple of str
        The strategies among which the top-level one chose, by class; its own if it has no parts.
    measure : Measure or None
        What the top-level bandit was rewarded by, if it was a gain in diversity.

    Examples
    --------
    >>> import divbandit as db
    >>> run = db.explore(db.PlanarArm(20), db.MotorBabbling(), n=100, rng=0)
    >>> len(run), run.commands.shape, run.estimates
    (100, (100, 20), None)
    """

    motor_space: Box
    sensory_space: Box | None
    commands: NDArray[np.float64]
    effects: NDArray[np.float64]
    paths: NDArray[np.int64]
    estimates: NDArray[np.float64] | None
    failures: tuple[Failure, ...] = ()
    names: tuple[str, ...] = ()
    measure: Measure | None = None

    def __post_init__(self) -> None:
        if self.commands is None:
            object.__delattr__(self, "commands")

    if not TYPE_CHECKING:  # a type checker knows all attributes

        def __getattr__(self, name: str) -> object:
            if name == "commands":
                raise AttributeError(
                    "commands were not kept: explore(..., keep_commands=True) does"
                )
            raise AttributeError(f"{type(self).__name__!r} object has no attribute {name!r}")

    @classmethod
    def of(cls, history: History, *, keep_commands: bool = True, take: bool = False) -> Exploration:
        """Return the exploration of a history: a copy, or with `take` the history's own memory.

        Examples
        --------
        >>> import divbandit as db
        >>> history = db.History(db.Box([0], [1]))
        >>> history.append([0.5], [7.0], path=(1, 0))
        >>> db.Exploration.of(history).paths
        array([[1, 0]])
        """
        log = history._log  # noqa: SLF001 - it is what is read here
        kept = keep_commands and log.keeps_commands
        commands, effects, paths, estimates = (log.take if take else log.arrays)(kept)
        return cls(
            history.motor_space,
            history.sensory_space,
            NOT_KEPT if commands is None else commands,
            effects,
            paths,
            estimates,
            history.failures,
            *history._explored_by,  # noqa: SLF001 - its explorer wrote it there
        )

    def __len__(self) -> int:
        return len(self.effects)

    def __repr__(self) -> str:
        m, s = self.motor_space.dim, self.effects.shape[1]
        return f"<Exploration of {counted(self)}, {m} -> {s}>"

    @property
    def choices(self) -> NDArray[np.int64]:
        """Index of the top-level strategy's part that chose, shape (n,); 0 if it has no parts."""
        if self.paths.shape[1] == 0:
            return np.zeros(len(self), dtype=np.int64)
        return self.paths[:, 0]

    def describe(
        self, *, measure: Measure | None = None, names: Sequence[str] | None = None
    ) -> str:
        """Return a summary to print: evaluations, failures, effects, and what each strategy did.

        Parameters
        ----------
        measure : Measure, optional
            By what to count gains; by default what the bandit was rewarded by. Without either there
            are no gains.
        names : sequence of str, optional
            What to call the top-level strategies; by default by their classes.

        Returns
        -------
        str
            A few lines. *Use* is a strategy's share of the evaluations, *gain* the diversity that
            its effects have added, in the units of the measure.

        Raises
        ------
        TypeError, ValueError
            If `measure` is not a measure, or `names` are not as many as the strategies.

        Examples
        --------
        >>> import divbandit as db
        >>> adapt = db.Adapt([db.MotorBabbling(), db.GoalBabbling(0.05)], tau=0.02)
        >>> run = db.explore(db.PlanarArm(20), adapt, n=500, rng=0)
        >>> print(run.describe(names=["motor", "goal"]))
        500 evaluations, 500 distinct effects
        strategy     use    gain
        motor     46.2 %  0.1995
        goal      53.8 %  0.2717
        gain of BallCoverage(0.02): 0.4712 in all
        """
        if measure is not None:
            check_measure("measure", measure)
        return described(self, self.measure if measure is None else measure, names)

    def diversity(self, measure: Measure) -> NDArray[np.float64]:
        """Return the diversity after each step, by any measure.

        Parameters
        ----------
        measure : Measure
            For instance ``divbandit.measures.GridCoverage(0.05)``.

        Returns
        -------
        numpy.ndarray of float64, shape (n,)
            The running sum of the gains, in the units of the measure.

        Raises
        ------
        TypeError, ValueError
            If `measure` is not a measure, or does not take effects of this dimension.

        Examples
        --------
        >>> import divbandit as db
        >>> run = db.explore(db.PlanarArm(20), db.MotorBabbling(), n=100, rng=0)
        >>> run.diversity(db.measures.GridCoverage(0.5))[[0, -1]]
        array([1., 6.])
        """
        check_measure("measure", measure)
        if len(self) == 0:  # perhaps of no dimension yet
            return np.empty(0)
        return np.cumsum(
            start_measure("measure", measure, self.effects.shape[1]).extend(self.effects)
        )

    def coverage(self, tau: float) -> NDArray[np.float64]:
        """Return the coverage after each step: the measure of the union of balls so far.

        In the plane it is an area, that of discs. Short for ``diversity(BallCoverage(tau))``.

        Parameters
        ----------
        tau : float
            Radius of the balls, in the units of the effects; positive.

        Returns
        -------
        numpy.ndarray of float64, shape (n,)

        Raises
        ------
        TypeError, ValueError
            If `tau` is not a positive number, or `Coverage` does not take effects of this
            dimension.

        Examples
        --------
        >>> import divbandit as db
        >>> run = db.explore(db.PlanarArm(20), db.MotorBabbling(), n=100, rng=0)
        >>> round(float(run.coverage(0.02)[0]), 9)
        0.001256637
        """
        measure = BallCoverage(tau)
        try:
            return self.diversity(measure)
        except ValueError as error:
            dim = self.effects.shape[1]
            raise ValueError(
                f"effects must be of a dimension that coverage takes, got {dim}: {error}"
            ) from None

    def save(self, path: str | os.PathLike[str]) -> None:
        """Write the exploration to a file, replacing it whole or not at all.

        The file is NumPy's ``npz``; nothing in it is pickled.

        Parameters
        ----------
        path : str or path
            Used as it is: no ending is added.

        Raises
        ------
        OSError
            If the file cannot be written.

        Examples
        --------
        >>> import os, tempfile
        >>> import divbandit as db
        >>> run = db.explore(db.PlanarArm(20), db.MotorBabbling(), n=10, rng=0)
        >>> with tempfile.TemporaryDirectory() as folder:
        ...     run.save(os.path.join(folder, "run.npz"))
        ...     again = db.Exploration.load(os.path.join(folder, "run.npz"))
        >>> bool((again.effects == run.effects).all())
        True
        """
        kept = hasattr(self, "commands")
        arrays: dict[str, NDArray[Any]] = {
            "motor_space": np.array([self.motor_space.low, self.motor_space.high]),
            "commands": self.commands if kept else np.empty((0, self.motor_space.dim)),
            "effects": self.effects,
            "paths": self.paths,
        }
        if self.sensory_space is not None:
            box = self.sensory_space
            arrays["sensory_space"] = np.array([box.low, box.high])
        if self.estimates is not None:
            arrays["estimates"] = self.estimates
        if self.names:
            arrays["names"] = _files.from_json(self.names)
        with suppress(NoRecipeError):  # a user's own measure is not saved
            if self.measure is not None:
                arrays["measure"] = _files.from_json(recipe_of(self.measure))
        if self.failures:
            arrays["failed_commands"] = np.array([failure.command for failure in self.failures])
            arrays["failed_why"] = _files.from_json([failure[1:] for failure in self.failures])
        _files.write(path, _FORMAT, _VERSION, arrays)

    @classmethod
    def load(cls, path: str | os.PathLike[str]) -> Exploration:
        """Read an exploration that was saved.

        Parameters
        ----------
        path : str or path

        Raises
        ------
        ValueError
            If the file is truncated or was not written by `save`.
        OSError
            If the file cannot be read.

        Examples
        --------
        >>> import divbandit as db
        >>> db.Exploration.load("missing.npz")
        Traceback (most recent call last):
            ...
        FileNotFoundError: [Errno 2] No such file or directory: 'missing.npz'
        """
        return _files.read(
            path,
            _FORMAT,
            _VERSION,
            cls._from_arrays,
            writer="Exploration.save (for an explorer's: Explorer.load(path).result())",
            earlier={1: None},
        )

    @classmethod
    def _from_arrays(cls, arrays: dict[str, NDArray[Any]]) -> Exploration:
        """Rebuild from the arrays of a file, which may hold anything."""
        motor_space = Box(*_files.array(arrays, "motor_space", np.float64, (2, None)))
        sensory_space = None
        if "sensory_space" in arrays:
            sensory_space = Box(*_files.array(arrays, "sensory_space", np.float64, (2, None)))
        paths = _files.array(arrays, "paths", np.int64, (None, None))
        n = len(paths)
        commands = _files.array(arrays, "commands", np.float64, (None, motor_space.dim))
        if len(commands) == 0 < n:
            commands = NOT_KEPT
        else:
            _files.array(arrays, "commands", np.float64, (n, motor_space.dim))
        width = None if sensory_space is None else sensory_space.dim
        estimates = None
        for name in ("estimates", "diversities"):  # the latter in the first version
            if name in arrays:
                estimates = _files.array(arrays, name, np.float64, (n, None))
        return cls(
            motor_space,
            sensory_space,
            commands,
            _files.array(arrays, "effects", np.float64, (n, width)),
            paths,
            estimates,
            _failures(arrays, motor_space.dim),
            tuple(map(str, _files.to_json(arrays, "names"))) if "names" in arrays else (),
            check_measure("measure", made_from(_files.to_json(arrays, "measure")))
            if "measure" in arrays
            else None,
        )


def _failures(arrays: dict[str, NDArray[Any]], dim: int) -> tuple[Failure, ...]:
    """Return the failures in a file."""
    if "failed_why" not in arrays:
        return ()
    reasons = _files.to_json(arrays, "failed_why")
    commands = _files.array(arrays, "failed_commands", np.float64, (len(reasons), dim))
    commands.flags.writeable = False
    return tuple(
        Failure(command, str(reason), tuple(whole("path", i, low=0) for i in path), place)
        for command, (reason, path, place) in zip(commands, reasons, strict=True)
    )
