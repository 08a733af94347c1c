"""RibsEmitter: an emitter of pyribs, with its archive, as a strategy.

An emitter's solution is a command whose coordinates are shares of the motor ranges, from 0 to 1, so
that one step size suits all joints. What lies outside is clipped.
"""

from __future__ import annotations

import copy
from dataclasses import dataclass
from inspect import signature
from typing import TYPE_CHECKING, Any, TypeGuard

import numpy as np

from divbandit._checks import one_of, real, whole
from divbandit._library import library, seed_from
from divbandit.adapters.batch import Batch, OfBatch, Report
from divbandit.box import Box
from divbandit.strategies import Strategy, Trial
from divbandit.strategies.base import StrategyValue

if TYPE_CHECKING:
    from collections.abc import Callable

    from numpy.random import Generator
    from numpy.typing import NDArray
    from ribs.archives import ArchiveBase
    from ribs.emitters import EmitterBase

    from divbandit.box import BoxLike
    from divbandit.history import History
    from divbandit.strategies.base import Starter

    EmitterFactory = Callable[[ArchiveBase, int], EmitterBase]
    ArchiveFactory = Callable[[int, int], ArchiveBase]
    Objective = Callable[[NDArray[np.float64], NDArray[np.float64]], float]


def _line(archive: ArchiveBase, seed: int) -> EmitterBase:
    """MAP-Elites: an elite, moved along the line to another one."""
    first = np.random.default_rng(seed).random((16, _dim(archive)))
    return _made(archive, seed, "IsoLineEmitter", initial_solutions=first, batch_size=16)


def _evolution(archive: ArchiveBase, seed: int) -> EmitterBase:
    """CMA-ME: a distribution that moves to where new cells are found."""
    middle = [0.5] * _dim(archive)
    return _made(archive, seed, "EvolutionStrategyEmitter", x0=middle, sigma0=0.2)


def _made(archive: ArchiveBase, seed: int, kind: str, **options: Any) -> EmitterBase:  # noqa: ANN401
    """Make an emitter of solutions from 0 to 1."""
    factory = getattr(library("ribs.emitters", user="RibsEmitter"), kind)
    emitter: EmitterBase = factory(
        archive, bounds=[(0.0, 1.0)] * _dim(archive), seed=seed, **options
    )
    return emitter


def _dim(archive: ArchiveBase) -> int:
    return int(np.prod(np.array(archive.solution_dim)))


#: Cells of the grid along each coordinate, by default.
_CELLS = 20

#: Emitters that go by a name.
EMITTERS: dict[str, EmitterFactory] = {"evolution": _evolution, "line": _line}


@dataclass(frozen=True, init=False, repr=False)
class RibsEmitter(StrategyValue):
    """An emitter of pyribs as a strategy, so that a bandit can choose among emitters.

    The archive's measures are the effects. The archive holds the effects of all strategies, so that
    an emitter looks for what none of them has found. An emitter proposes batches; they are handed
    out one solution at a time, and the emitter learns when all of a batch have ended:

    - Emitters that learn, such as those of CMA-ME, need whole batches: they rank by the places in
      what they asked for last. A trial that failed stands for the worst of its batch, and for one
      that did not enter the archive. A batch of which all failed is forgotten.
    - If more trials are asked for while some of a batch are pending, a copy of the emitter proposes
    them. Their effects enter the archive; the emitter does not learn them, and learns
      nothing while a trial of its batch is open: one without an effect should be failed.

    Parameters
    ----------
    emitter : {"line", "evolution"} or callable
        MAP-Elites by steps along lines between elites, CMA-ME by improvement, or a function of
        an archive and a seed that makes an emitter. Solutions are shares of the motor ranges, from
        0, the lower limit, to 1: an emitter that starts in the middle has ``x0=[0.5] * m``.
    box : Box or object with ``low`` and ``high``, optional
        The extent of the archive's grid; by default the sensory space.
    cells : int
        How many cells the grid has along each coordinate of the effects.
    archive : callable, optional
        A function of the dimension of the commands and a seed that makes an archive, in place of
        the grid: neither `box` nor `cells` may then be given.
    objective : callable, optional
        A function of an effect and its command, both read-only arrays: the larger, the better.
        By default all are equally good: only new cells count.

    Attributes
    ----------
    emitter, box, cells, archive, objective
        As given; `box` as a Box.

    Raises
    ------
    ModuleNotFoundError
        If pyribs is not installed.
    TypeError, ValueError
        If an argument is not what it must be; when exploring, if there is neither a box nor a
        sensory space, or the emitter asks for nothing.

    Notes
    -----
    The first proposal draws two ``rng.random()``, the seeds of the archive and of the emitter,
    whose draws are their own. The running emitter, with its archive, is
    ``explorer.strategy.emitter``; it is None at first.

    Examples
    --------
    >>> import divbandit as db
    >>> from divbandit.adapters import RibsEmitter
    >>> arm = db.PlanarArm(7)
    >>> adapt = db.Adapt([RibsEmitter("line"), db.MotorBabbling()], tau=0.05)
    >>> run = db.explore(arm, adapt, n=100, rng=0)
    >>> run.effects.shape
    (100, 2)
    """

    emitter: str | EmitterFactory
    box: Box | None
    cells: int
    archive: ArchiveFactory | None
    objective: Objective | None

    def __init__(
        self,
        emitter: str | EmitterFactory = "line",
        *,
        box: BoxLike | None = None,
        cells: int = _CELLS,
        archive: ArchiveFactory | None = None,
        objective: Objective | None = None,
    ) -> None:
        library("ribs", user="RibsEmitter")
        _check_class("emitter", emitter, "archive", "seed")
        _check_class("archive", archive, "dim", "seed")
        if isinstance(emitter, str):
            one_of("emitter", emitter, sorted(EMITTERS))
        elif not callable(emitter):
            raise TypeError(
                "emitter must be a name, or a function of an archive and a seed that makes one, "
                f"got {type(emitter).__name__}"
            )
        for name, value in [("archive", archive), ("objective", objective)]:
            if value is not None and not callable(value):
                raise TypeError(f"{name} must be callable, got {type(value).__name__}")
        if archive is not None and (box is not None or cells != _CELLS):
            raise ValueError("archive must not be given together with box or cells")
        self._set(
            emitter=emitter,
            box=None if box is None else Box.of(box),
            cells=whole("cells", cells, low=1),
            archive=archive,
            objective=objective,
        )

    def check(self, motor_space: Box, effect_dim: int | None, *, has_goals: bool) -> None:
        """Require a box to lay the grid over, of the dimension of the effects."""
        del motor_space
        if self.archive is not None:
            return
        if self.box is None and not has_goals:
            raise ValueError(
                "box must be given to RibsEmitter: there is no sensory space to lay a grid over"
            )
        if self.box is not None and effect_dim not in (None, self.box.dim):
            raise ValueError(
                f"box must have the dimension of the effects, {effect_dim}, got {self.box.dim}"
            )

    def start(self, start: Starter) -> Strategy:
        """Return the emitter under way."""
        return _Emitting(self, start.history)


def _check_class(name: str, given: object, *arguments: str) -> None:
    """Raise if a class is given that does not take these arguments, as those of pyribs do not."""
    if not isinstance(given, type):
        return
    try:
        signature(given).bind(*arguments)
    except (TypeError, ValueError):
        raise TypeError(
            f"{name} must be a function of {' and '.join(arguments)} that makes one, got the "
            f"class {given.__name__}: write "
            f"lambda {', '.join(arguments)}: {given.__name__}(..., seed=seed)"
        ) from None


def _emitter_of(recipe: RibsEmitter, history: History, rng: Generator) -> EmitterBase:
    """Make an emitter with an empty archive: two ``rng.random()``."""
    dim, seed = history.motor_space.dim, seed_from(rng)
    archive = _grid(recipe, history, seed) if recipe.archive is None else recipe.archive(dim, seed)
    factory = recipe.emitter if callable(recipe.emitter) else EMITTERS[recipe.emitter]
    return factory(archive, seed_from(rng))


def _grid(recipe: RibsEmitter, history: History, seed: int) -> ArchiveBase:
    """Make a grid over the box, or the sensory space."""
    box = history.sensory_space if recipe.box is None else recipe.box
    if box is None:
        raise ValueError("box must be given to RibsEmitter: there is no sensory space")
    archive: ArchiveBase = library("ribs.archives", user="RibsEmitter").GridArchive(
        solution_dim=history.motor_space.dim,
        dims=[recipe.cells] * box.dim,
        ranges=list(zip(box.low.tolist(), box.high.tolist(), strict=True)),
        seed=seed,
    )
    return archive


class _Emitting(Strategy):
    """An emitter under way: a batch at a time."""

    emitter: EmitterBase | None = None

    def __init__(self, recipe: RibsEmitter, history: History) -> None:
        space = history.motor_space
        self._recipe, self._history = recipe, history
        self._low, self._high, self._width = space.low, space.high, space.high - space.low
        self._learns = False
        self._batch: Batch | None = None
        self._surplus: _Surplus | None = None
        self._known = 0  # how much of the history is in the archive

    def propose(self, history: History, rng: Generator) -> Trial:
        """Give out the next solution of the emitter's batch."""
        if self.emitter is None:
            self.emitter = _emitter_of(self._recipe, history, rng)
            base = library("ribs.emitters", user="RibsEmitter").EmitterBase
            self._learns = type(self.emitter).tell is not base.tell
        self._catch_up(self.emitter, len(history))
        batch = self._batch
        if batch is not None and batch.all_ended:
            self._learn(self.emitter, batch)
            batch = None
        if batch is None or (batch.all_given and not self._learns):
            batch = self._batch = _asked(self.emitter)
        if not batch.all_given:
            row = batch.take()
            return OfBatch(self._command(batch.solutions[row]), batch=batch, row=row)
        if self._surplus is None:
            self._surplus = _Surplus(self.emitter)
        return Trial(self._command(self._surplus.take()))

    def observe(self, trial: Trial, effect: NDArray[np.float64]) -> None:
        """Add the newest effect to the archive, as one of the batch."""
        del effect  # it is in the history
        batch = self._batch
        if self.emitter is None or batch is None or not _is_of(trial, batch):
            return
        newest = len(self._history) - 1
        self._catch_up(self.emitter, newest)
        solution = batch.solutions[trial.row : trial.row + 1]
        self._known = newest + 1
        batch.end(trial.row, self._add(self.emitter, newest, newest + 1, solution))

    def fail(self, trial: Trial, reason: str) -> None:
        """Count the trial as the worst of its batch."""
        del reason
        if self._batch is not None and _is_of(trial, self._batch):
            self._batch.end(trial.row)

    def _command(self, solution: NDArray[np.float64]) -> NDArray[np.float64]:
        """Return the command of a solution."""
        command: NDArray[np.float64] = np.clip(
            self._low + solution * self._width, self._low, self._high
        )
        return command

    def _catch_up(self, emitter: EmitterBase, stop: int) -> None:
        """Add to the archive what the history holds up to a row."""
        start, self._known = self._known, stop
        if start < stop:
            width = np.where(self._width > 0.0, self._width, 1.0)
            solutions = (self._history.commands[start:stop] - self._low) / width
            self._add(emitter, start, stop, solutions)

    def _add(
        self, emitter: EmitterBase, start: int, stop: int, solutions: NDArray[np.float64]
    ) -> Report:
        """Add rows of the history to the archive; report on the last of them."""
        commands, effects = self._history.commands[start:stop], self._history.effects[start:stop]
        objectives = [self._worth(*pair) for pair in zip(effects, commands, strict=True)]
        added: dict[str, Any] = emitter.archive.add(solutions, objectives, effects)
        return Report(effects[-1], objectives[-1], added)

    def _worth(self, effect: NDArray[np.float64], command: NDArray[np.float64]) -> float:
        """Return the objective of an effect."""
        objective = self._recipe.objective
        return 0.0 if objective is None else real("objective()", objective(effect, command))

    def _learn(self, emitter: EmitterBase, batch: Batch) -> None:
        """Let the emitter learn from a whole batch."""
        self._batch = None
        known = [report for report in batch.reports.values() if report is not None]
        if not known or not self._learns:
            return
        worst = copy.deepcopy(min(known, key=_standing))
        worst.added["status"] = np.zeros_like(worst.added["status"])
        reports = [batch.reports[row] or worst for row in range(len(batch.solutions))]
        emitter.tell(
            batch.solutions,
            np.array([report.objective for report in reports]),
            np.array([report.effect for report in reports]),
            {key: np.concatenate([report.added[key] for report in reports]) for key in worst.added},
        )
        if self._surplus is not None:
            for _ in range(self._surplus.asks):  # the copy has used up these draws
                emitter.ask()
            self._surplus = None


class _Surplus:
    """Solutions by a copy of an emitter with the same archive, while its batch is under way."""

    def __init__(self, emitter: EmitterBase) -> None:
        self._emitter = copy.deepcopy(emitter, {id(emitter.archive): emitter.archive})
        self._batch = _asked(self._emitter)
        self.asks = 1

    def take(self) -> NDArray[np.float64]:
        """Return the next solution."""
        if self._batch.all_given:
            self._batch = _asked(self._emitter)
            self.asks += 1
        solution: NDArray[np.float64] = self._batch.solutions[self._batch.take()]
        return solution


def _is_of(trial: Trial, batch: Batch) -> TypeGuard[OfBatch]:
    """Say whether a trial is one of a batch."""
    return isinstance(trial, OfBatch) and trial.batch is batch


def _asked(emitter: EmitterBase) -> Batch:
    """Return what the emitter asks for, inside the motor space."""
    solutions = np.clip(np.asarray(emitter.ask(), dtype=np.float64), 0.0, 1.0)
    if len(solutions) == 0:
        raise ValueError(
            f"emitter must ask for at least one solution, got none from {type(emitter).__name__}"
        )
    return Batch(solutions)


def _standing(report: Report) -> tuple[float, float, float]:
    """Return what the solutions of a batch are ordered by: the least is the worst."""
    status = report.added["status"][0]
    value = report.added.get("value", np.array([report.objective]))[0]
    return float(status), float(value), report.objective
