"""RibsEmitter: an emitter of pyribs, with its archive, as a strategy.

Emitters think in shares: a solution is a command whose coordinates are shares of the motor
ranges, from 0 to 1, so that one step size suits all joints. What lies outside is clipped.
"""

from __future__ import annotations

import copy
from typing import TYPE_CHECKING, Any

import numpy as np

from divbandit._checks import one_of, real, whole
from divbandit._library import library, named, seed_from
from divbandit.adapters.batch import Batch, OfBatch, Report
from divbandit.box import Box
from divbandit.strategies.base import Strategy, Trial

if TYPE_CHECKING:
    from collections.abc import Callable, Sequence

    from numpy.random import Generator
    from numpy.typing import NDArray
    from ribs.archives import ArchiveBase
    from ribs.emitters import EmitterBase

    from divbandit.box import BoxLike
    from divbandit.history import History

    EmitterFactory = Callable[[ArchiveBase, int], EmitterBase]
    ArchiveFactory = Callable[[int, int], ArchiveBase]
    Objective = Callable[[NDArray[np.float64], NDArray[np.float64]], float]


def _line(archive: ArchiveBase, seed: int) -> EmitterBase:
    """MAP-Elites: an elite, moved along the line to another one."""
    first = np.random.default_rng(seed).random((16, _dim(archive)))
    unit = [(0.0, 1.0)] * _dim(archive)
    emitters = library("ribs.emitters", user="RibsEmitter")
    emitter: EmitterBase = emitters.IsoLineEmitter(
        archive, initial_solutions=first, bounds=unit, batch_size=16, seed=seed
    )
    return emitter


def _evolution(archive: ArchiveBase, seed: int) -> EmitterBase:
    """CMA-ME: a distribution that moves to where new cells are found."""
    unit = [(0.0, 1.0)] * _dim(archive)
    emitters = library("ribs.emitters", user="RibsEmitter")
    emitter: EmitterBase = emitters.EvolutionStrategyEmitter(
        archive, x0=[0.5] * _dim(archive), sigma0=0.2, bounds=unit, seed=seed
    )
    return emitter


def _dim(archive: ArchiveBase) -> int:
    return int(np.prod(np.array(archive.solution_dim)))


#: Emitters that go by a name.
EMITTERS: dict[str, EmitterFactory] = {"evolution": _evolution, "line": _line}


class RibsEmitter(Strategy):
    """An emitter of pyribs as a strategy, so that a bandit can choose among emitters.

    The archive's measures are the effects. Like all that is derived from the history, the
    archive holds the effects of all strategies, so that an emitter looks for what nobody has
    found. An emitter asks for batches; they are given out one solution at a time, and the emitter
    is told when all of a batch have come to an end:

    - Emitters that learn, such as those of CMA-ME, must be told of whole batches: they rank by
      the places in what they asked for last. A trial that failed stands for the worst of its
      batch, and for one that did not enter the archive. A batch of which all failed is forgotten.
    - Where more is asked for while some of a batch are under way, a copy of the emitter proposes
      more of its kind. Their effects enter the archive; the emitter is not told. It learns
      nothing while a trial of its batch is open: one that will never be told should be failed.

    Parameters
    ----------
    emitter : {"line", "evolution"} or callable
        MAP-Elites by steps along lines between elites, CMA-ME by improvement, or a function of
        an archive and a seed that makes an emitter. Solutions are shares of the motor ranges.
    box : Box or object with ``low`` and ``high``, optional
        Where to lay the archive's grid; by default over the sensory space.
    cells : int
        How many cells the grid has along each coordinate of the effects.
    archive : callable, optional
        A function of the dimension of the commands and a seed that makes an archive, in place
        of the grid; `box` and `cells` then say nothing, and must be left at their defaults.
    objective : callable, optional
        A function of an effect and its command, both read-only arrays: the larger, the better.
        By default all are as good as each other: only new cells count.

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
    The first proposal draws two ``rng.random()``, seeds of the archive and the emitter; all that
    these draw is their own.

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

    def __init__(
        self,
        emitter: str | EmitterFactory = "line",
        *,
        box: BoxLike | None = None,
        cells: int = 20,
        archive: ArchiveFactory | None = None,
        objective: Objective | None = None,
    ) -> None:
        library("ribs", user="RibsEmitter")
        if not callable(emitter):
            one_of("emitter", emitter, sorted(EMITTERS))
        for name, value in [("archive", archive), ("objective", objective)]:
            if value is not None and not callable(value):
                raise TypeError(f"{name} must be callable, got {type(value).__name__}")
        self.emitter = emitter
        self.box = None if box is None else Box.of(box)
        self.cells = whole("cells", cells, low=1)
        if archive is not None and (box is not None or cells != 20):
            raise ValueError("archive must not be given together with box or cells")
        self.archive = archive
        self.objective = objective
        self._history: History | None = None
        self._batch: Batch | None = None
        self._spare: EmitterBase | None = None
        self._spare_batch: Batch | None = None

    def check(self, motor_space: Box, effect_dim: int | None, *, has_goals: bool) -> None:  # noqa: ARG002 - the same for all motor spaces
        """Require a box to lay the grid over, of the dimension of the effects."""
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

    @property
    def running(self) -> EmitterBase | None:
        """The emitter at work, with its archive as it was at the latest proposal; None at first."""
        return None if self._history is None else self._emitter

    def propose(self, history: History, rng: Generator) -> Trial:
        """Give out the next solution of the emitter's batch.

        What is remembered belongs to one history; asked about another, all begins anew.
        """
        if history is not self._history:
            self._begin(history, rng)
        self._catch_up(history)
        batch = self._batch
        if batch is not None and batch.all_ended:
            self._tell(batch)
            batch = None
        if batch is None or (batch.all_given and not self._learns):
            batch = self._batch = _asked(self._emitter)
        if not batch.all_given:
            row = batch.take()
            return OfBatch(self._command(batch.solutions[row]), batch, row)
        return Trial(self._command(self._surplus()))

    def observe(self, trial: Trial, effect: NDArray[np.float64]) -> None:  # noqa: ARG002 - it is in the history
        """Note where the effect is; the archive and the emitter are told at the next proposal."""
        history = self._history
        if history is not None and isinstance(trial, OfBatch) and trial.batch is self._batch:
            self._places[len(history) - 1 if trial.place is None else trial.place] = trial.row
            trial.batch.end(trial.row)

    def observe_many(self, trials: Sequence[Trial], effects: NDArray[np.float64]) -> None:
        """Note where the effects are."""
        for trial, effect in zip(trials, effects, strict=True):
            self.observe(trial, effect)

    def fail(self, trial: Trial, reason: str) -> None:  # noqa: ARG002 - whatever the reason
        """Count it as the worst of its batch."""
        if isinstance(trial, OfBatch) and trial.batch is self._batch:
            trial.batch.end(trial.row)

    def _begin(self, history: History, rng: Generator) -> None:
        """Make an archive and an emitter for this history."""
        space = history.motor_space
        seeds = seed_from(rng), seed_from(rng)
        archive = self._grid(history, seeds[0])
        factory = self.emitter if callable(self.emitter) else EMITTERS[self.emitter]
        self._emitter = factory(archive, seeds[1])
        self._low, self._high, self._width = space.low, space.high, space.high - space.low
        base = library("ribs.emitters", user="RibsEmitter").EmitterBase
        self._learns = type(self._emitter).tell is not base.tell
        self._known = 0
        self._places: dict[int, int] = {}  # of the batch's effects that are not in the archive yet
        self._batch, self._spare, self._spare_batch = None, None, None
        self._spare_asks = 0
        self._history = history

    def _grid(self, history: History, seed: int) -> ArchiveBase:
        dim = history.motor_space.dim
        if self.archive is not None:
            return self.archive(dim, seed)
        box = history.sensory_space if self.box is None else self.box
        if box is None:
            raise ValueError("box must be given to RibsEmitter: there is no sensory space")
        ranges = list(zip(box.low.tolist(), box.high.tolist(), strict=True))
        archives = library("ribs.archives", user="RibsEmitter")
        archive: ArchiveBase = archives.GridArchive(
            solution_dim=dim, dims=[self.cells] * box.dim, ranges=ranges, seed=seed
        )
        return archive

    def _command(self, solution: NDArray[np.float64]) -> NDArray[np.float64]:
        command: NDArray[np.float64] = np.clip(
            self._low + solution * self._width, self._low, self._high
        )
        return command

    def _surplus(self) -> NDArray[np.float64]:
        """Return one more solution, while some of a batch are under way."""
        if self._spare is None:
            archive = self._emitter.archive
            self._spare = copy.deepcopy(self._emitter, {id(archive): archive})
        if self._spare_batch is None or self._spare_batch.all_given:
            self._spare_batch = _asked(self._spare)
            self._spare_asks += 1
        solution: NDArray[np.float64] = self._spare_batch.solutions[self._spare_batch.take()]
        return solution

    def _catch_up(self, history: History) -> None:
        """Add to the archive what the history holds by now, in its order."""
        for place in sorted(self._places):
            self._add(history, self._known, place)
            row = self._places[place]
            assert self._batch is not None  # noqa: S101 - whoever notes a place has checked it
            solution = self._batch.solutions[row : row + 1]
            self._batch.reports[row] = self._add(history, place, place + 1, solution)
            self._known = place + 1
        self._places.clear()
        self._add(history, self._known, len(history))
        self._known = len(history)

    def _add(
        self,
        history: History,
        start: int,
        stop: int,
        solutions: NDArray[np.float64] | None = None,
    ) -> Report | None:
        """Add these effects to the archive; report on the last of them."""
        if start >= stop:
            return None
        commands, effects = history.commands[start:stop], history.effects[start:stop]
        if solutions is None:
            solutions = (commands - self._low) / np.where(self._width > 0.0, self._width, 1.0)
        objectives = [self._worth(*pair) for pair in zip(effects, commands, strict=True)]
        added: dict[str, Any] = self._emitter.archive.add(solutions, objectives, effects)
        return Report(effects[-1], objectives[-1], added)

    def _worth(self, effect: NDArray[np.float64], command: NDArray[np.float64]) -> float:
        return (
            0.0 if self.objective is None else real("objective()", self.objective(effect, command))
        )

    def _tell(self, batch: Batch) -> None:
        """Tell the emitter what came of a whole batch."""
        self._batch = None
        known = [report for report in batch.reports if report is not None]
        if not known or not self._learns:
            return
        worst = copy.deepcopy(min(known, key=_standing))
        worst.added["status"] = np.zeros_like(worst.added["status"])
        reports = [worst if report is None else report for report in batch.reports]
        self._emitter.tell(
            batch.solutions,
            np.array([report.objective for report in reports]),
            np.array([report.effect for report in reports]),
            {key: np.concatenate([report.added[key] for report in reports]) for key in worst.added},
        )
        for _ in range(self._spare_asks):  # the copy has used up these draws
            self._emitter.ask()
        self._spare, self._spare_batch, self._spare_asks = None, None, 0

    def __repr__(self) -> str:
        words = [named(self.emitter)]
        if self.box is not None:
            words.append(f"box={self.box!r}")
        words.append(
            f"cells={self.cells}" if self.archive is None else f"archive={named(self.archive)}"
        )
        if self.objective is not None:
            words.append(f"objective={named(self.objective)}")
        return f"RibsEmitter({', '.join(words)})"


def _asked(emitter: EmitterBase) -> Batch:
    """Return what the emitter asks for, inside the motor space."""
    solutions = np.clip(np.asarray(emitter.ask(), dtype=np.float64), 0.0, 1.0)
    if len(solutions) == 0:
        raise ValueError(
            f"emitter must ask for at least one solution, got none from {type(emitter).__name__}"
        )
    return Batch(solutions)


def _standing(report: Report) -> tuple[float, float, float]:
    """Return what tells better from worse among the solutions of a batch."""
    status = report.added["status"][0]
    value = report.added.get("value", np.array([report.objective]))[0]
    return float(status), float(value), report.objective
