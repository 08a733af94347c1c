"""RibsScheduler: the other way round - a bandit over the emitters of a script for pyribs."""

from __future__ import annotations

import copy
from collections import deque
from typing import TYPE_CHECKING, NoReturn

import numpy as np

from divbandit._checks import generator, whole
from divbandit._core import Trial, undisturbed
from divbandit._library import library
from divbandit.box import Box
from divbandit.history import History
from divbandit.strategies import Strategy
from divbandit.strategies.base import Starter

if TYPE_CHECKING:
    from collections.abc import Callable, Iterator, Sequence
    from typing import Any, Literal

    from numpy.random import Generator
    from numpy.typing import ArrayLike, NDArray
    from ribs.archives import ArchiveBase
    from ribs.emitters import EmitterBase

    from divbandit._checks import Rng


class RibsScheduler:
    """A scheduler for pyribs whose emitters are chosen by a bandit of this library.

    It stands where ``ribs.schedulers.BanditScheduler`` stands in a script, and is asked and told
    alike. At each `ask` the bandit chooses who proposes; each solution then earns its emitter a
    reward, found as in any exploration, with the measures as effects: by default what they add to
    the area covered so far.

    Parameters
    ----------
    archive : ribs.archives.ArchiveBase
    emitters : sequence of ribs.emitters.EmitterBase
        Those to choose among.
    bandit : callable
        A function of a list of strategies, one for each emitter, that returns a bandit over them:
        ``divbandit.Adapt``, or ``lambda emitters: divbandit.Adapt(emitters, tau=0.1)``. `tau` is in
        the units of the measures, and of use if it is about the width of an archive's cell. Any
        composition of these strategies will do, such as a `Mixture`.
    result_archive : ribs.archives.ArchiveBase, optional
        A second archive to which all solutions are added.
    num_active : int
        How many emitters are asked at a time. So often does the bandit choose; an emitter that is
        chosen again leaves its place to the one with the largest estimate of those that are left.
    add_mode : {"batch", "single"}
        Whether solutions are added to the archives together, or one by one.
    rng : Generator, SeedSequence, int or None
        Where the bandit's draws come from. Emitters have their own.

    Attributes
    ----------
    archive, result_archive : ribs.archives.ArchiveBase
        The latter is the former where none was given.
    emitters, emitter_pool : tuple of ribs.emitters.EmitterBase
        Under the names that the two schedulers of pyribs use.
    asked : numpy.ndarray of int, shape (emitters,)
        How many times each emitter was asked.
    active : numpy.ndarray of bool, shape (emitters,)
        Who was asked last.
    solutions : numpy.ndarray or None
        Those asked for, until they are told.
    history : History
        What was told: ``history.effects`` are the measures, ``history.commands`` the indices of the
        emitters that proposed them.

    Raises
    ------
    ModuleNotFoundError
        If pyribs is not installed.
    TypeError, ValueError
        If an argument is not what it must be, or the bandit cannot reward measures of that number.

    Notes
    -----
    A window of ADAPT holds solutions, not batches: with batches of 36, the paper's 50 are the last
    two. A phase of a `Schedule` counts choices.

    Examples
    --------
    >>> import numpy as np
    >>> from ribs.archives import GridArchive
    >>> from ribs.emitters import GaussianEmitter
    >>> import divbandit as db
    >>> from divbandit.adapters import RibsScheduler
    >>> archive = GridArchive(solution_dim=2, dims=[20, 20], ranges=[(-1, 1), (-1, 1)], seed=0)
    >>> emitters = [
    ...     GaussianEmitter(archive, sigma=sigma, x0=[0, 0], batch_size=10, seed=0)
    ...     for sigma in (0.001, 0.1)
    ... ]
    >>> scheduler = RibsScheduler(
    ...     archive, emitters, lambda parts: db.Adapt(parts, tau=0.1), rng=0
    ... )
    >>> for _ in range(50):
    ...     solutions = scheduler.ask()
    ...     scheduler.tell(np.zeros(10), solutions)  # the measures are the solutions
    >>> int(scheduler.asked.sum()), bool(scheduler.asked[1] > scheduler.asked[0])
    (50, True)
    """

    def __init__(
        self,
        archive: ArchiveBase,
        emitters: Sequence[EmitterBase],
        bandit: Callable[[list[Strategy]], Strategy],
        *,
        result_archive: ArchiveBase | None = None,
        num_active: int = 1,
        add_mode: Literal["batch", "single"] = "batch",
        rng: Rng = None,
    ) -> None:
        library("ribs", user="RibsScheduler")
        self.archive = _of_kind("archive", archive, "ribs.archives", "ArchiveBase")
        self.emitters = self.emitter_pool = _emitters_of(emitters)
        if result_archive is not None:
            _of_kind("result_archive", result_archive, "ribs.archives", "ArchiveBase")
        self.result_archive = archive if result_archive is None else result_archive
        self._second = result_archive
        self._add_mode = add_mode
        self._scheduler = self._over(self.emitters)  # of those who were asked last
        count = len(self.emitters)
        self._num_active = whole("num_active", num_active, low=1, high=count)
        self._rng = generator(rng)
        self.asked, self.active = np.zeros(count, dtype=int), np.zeros(count, dtype=bool)
        self.solutions: NDArray[Any] | None = None
        self.history = History(Box([0], [count - 1]))
        given = _bandit_over(count, bandit)
        self._paths = dict(_paths_of(given))
        given.check(self.history.motor_space, int(archive.measure_dim), has_goals=False)
        self._bandit = Starter(self.history)(given)
        self._trials: list[Trial] = []  # who proposed each solution
        self._told: deque[tuple[Trial, NDArray[np.float64]]] = deque()  # to be learned

    @property
    def estimates(self) -> tuple[float, ...] | None:
        """The bandit's estimates of the emitters, as its next choice uses them.

        Examples
        --------
        >>> from ribs.archives import GridArchive
        >>> from ribs.emitters import GaussianEmitter
        >>> import divbandit as db
        >>> from divbandit.adapters import RibsScheduler
        >>> archive = GridArchive(solution_dim=1, dims=[20], ranges=[(-1, 1)])
        >>> emitters = [GaussianEmitter(archive, sigma=0.1, x0=[x]) for x in (0, 1)]
        >>> gain = db.bandits.Gain(db.measures.GridCoverage(0.1))
        >>> RibsScheduler(archive, emitters, lambda each: db.Adapt(each, reward=gain)).estimates
        (1.0, 1.0)
        """
        return self._bandit.estimates

    def ask(self) -> NDArray[Any]:
        """Return the solutions of the emitters that the bandit chooses.

        Returns
        -------
        numpy.ndarray, shape (n, m)
            Those of one emitter after those of another, in the order of `emitters`.

        Raises
        ------
        RuntimeError
            If those asked for last were not told.
        ValueError
            If an emitter asks for nothing.

        Examples
        --------
        >>> from ribs.archives import GridArchive
        >>> from ribs.emitters import GaussianEmitter
        >>> import divbandit as db
        >>> from divbandit.adapters import RibsScheduler
        >>> archive = GridArchive(solution_dim=1, dims=[20], ranges=[(-1, 1)])
        >>> emitters = [GaussianEmitter(archive, sigma=0.1, x0=[x], batch_size=5) for x in (0, 1)]
        >>> RibsScheduler(archive, emitters, db.Adapt, num_active=2).ask().shape
        (10, 1)
        """
        if self.solutions is not None:
            raise RuntimeError(
                "ask must follow tell: those asked for last, scheduler.solutions, are not told"
            )
        return undisturbed(self._ask)

    def _ask(self) -> NDArray[Any]:
        self._learn()
        chosen = self._chosen()
        active = [self.emitters[index] for index in chosen]
        scheduler = self._over(active)
        solutions: NDArray[Any] = scheduler.ask()
        sizes = scheduler._num_emitted  # noqa: SLF001 - whose solutions they are
        for emitter, size in zip(active, sizes, strict=True):
            if not size:
                raise ValueError(
                    "emitters must ask for at least one solution, "
                    f"got none from {type(emitter).__name__}"
                )
        self._trials = [
            trial for trial, size in zip(chosen.values(), sizes, strict=True) for _ in range(size)
        ]
        self.active = np.isin(np.arange(len(self.emitters)), list(chosen))
        self.asked = self.asked + self.active
        self._scheduler, self.solutions = scheduler, solutions
        return solutions

    def _over(self, active: Sequence[EmitterBase]) -> Any:  # noqa: ANN401 - of pyribs
        """Return pyribs' own scheduler of some of the emitters, which checks its arguments."""
        return library("ribs.schedulers", user="RibsScheduler").Scheduler(
            self.archive, active, self._second, add_mode=self._add_mode
        )

    def _chosen(self) -> dict[int, Trial]:
        """Return who is to propose, in order, with the choices as trials."""
        chosen: dict[int, Trial] = {}
        for _ in range(self._num_active):
            trial = Trial.of(self._bandit.propose(self.history, self._rng))
            chosen.setdefault(_emitter_of(trial), trial)
        means = self.estimates
        others = sorted(
            self._paths.keys() - chosen.keys(),
            key=lambda each: (
                0.0 if means is None else -means[self._paths[each][0]],
                self.asked[each],
                each,
            ),
        )
        for each in others[: self._num_active - len(chosen)]:
            chosen[each] = _choice(each, self._paths[each])
        return dict(sorted(chosen.items()))

    def tell(
        self, objective: ArrayLike | None, measures: ArrayLike, **fields: ArrayLike | None
    ) -> None:
        """Add the solutions to the archives, and let their emitters and the bandit learn.

        Where an argument is refused nothing changes, and the same solutions can be told again.

        Parameters
        ----------
        objective : array_like, shape (n,), or None
            None where the archive takes none.
        measures : array_like, shape (n, s)
        **fields : array_like, shape (n, ...), or None
            What else the archive holds of a solution.

        Raises
        ------
        RuntimeError
            If there was no `ask` before it.
        TypeError, ValueError
            If there is not one row for each solution, measures are not finite numbers, or the
            archive refuses them.

        Examples
        --------
        >>> from ribs.archives import GridArchive
        >>> from ribs.emitters import GaussianEmitter
        >>> import divbandit as db
        >>> from divbandit.adapters import RibsScheduler
        >>> archive = GridArchive(solution_dim=1, dims=[20], ranges=[(-1, 1)])
        >>> emitters = [GaussianEmitter(archive, sigma=0.1, x0=[x], batch_size=2) for x in (0, 1)]
        >>> scheduler = RibsScheduler(archive, emitters, db.Adapt)
        >>> _ = scheduler.ask()
        >>> scheduler.tell([1.0, 2.0], [[0.31]])
        Traceback (most recent call last):
            ...
        ValueError: measures must be finite numbers of shape (2, 1), got shape (1, 1)
        >>> scheduler.tell([1.0, 2.0], [[0.31], [0.32]])
        >>> len(archive)
        1
        """
        if self.solutions is None:
            raise RuntimeError("tell must follow ask: there are no solutions to tell")
        effects = _measures_of(measures, (len(self.solutions), int(self.archive.measure_dim)))
        for name, values in {"objective": objective, **fields}.items():
            _check_length(name, values, len(self.solutions))
        undisturbed(self._tell, objective, effects, measures, fields)

    def _tell(
        self,
        objective: ArrayLike | None,
        effects: NDArray[np.float64],
        measures: ArrayLike,
        fields: dict[str, ArrayLike | None],
    ) -> None:
        # A copy, as pyribs' scheduler takes no second tell after one that it refused.
        copy.copy(self._scheduler).tell(objective, measures, **fields)
        self._told.extend(zip(self._trials, effects, strict=True))
        self.solutions = None
        self._learn()

    def _learn(self) -> None:
        """Let the bandit learn; what is left where a reward raises is learned the next time."""
        while self._told:
            trial, effect = self._told.popleft()
            self.history.append([_emitter_of(trial)], effect, path=trial.path)
            self._bandit.observe(trial, effect)

    @staticmethod
    def ask_dqd() -> NoReturn:
        """Raise an error, as ``BanditScheduler`` does: emitters that need gradients do not go.

        Examples
        --------
        >>> from divbandit.adapters import RibsScheduler
        >>> RibsScheduler.ask_dqd()
        Traceback (most recent call last):
            ...
        NotImplementedError: RibsScheduler must be asked by ask(): it takes no gradients
        """
        raise NotImplementedError("RibsScheduler must be asked by ask(): it takes no gradients")

    @staticmethod
    def tell_dqd(*arguments: object, **fields: object) -> NoReturn:
        """Raise an error, as ``BanditScheduler`` does: emitters that need gradients do not go.

        Examples
        --------
        >>> from divbandit.adapters import RibsScheduler
        >>> RibsScheduler.tell_dqd()
        Traceback (most recent call last):
            ...
        NotImplementedError: RibsScheduler must be told by tell(): it takes no gradients
        """
        del arguments, fields
        raise NotImplementedError("RibsScheduler must be told by tell(): it takes no gradients")

    def __repr__(self) -> str:
        return f"<RibsScheduler of {len(self.emitters)} emitters, {len(self.history)} solutions>"


class _Emitter(Strategy):
    """What stands for an emitter in the bandit: it proposes the emitter's index."""

    def __init__(self, index: int) -> None:
        self.index = index

    def propose(self, history: History, rng: Generator) -> Trial:
        """Propose the emitter."""
        del history, rng
        return Trial([self.index])


def _choice(index: int, path: tuple[int, ...]) -> Trial:
    """Return the trial of composites that chose an emitter along a path."""
    trial = Trial([index])
    for part in reversed(path):
        trial = trial.proposed_by(part)
    return trial


def _emitter_of(trial: Trial) -> int:
    """Return the index of the emitter that was chosen."""
    while trial.inner is not None:
        trial = trial.inner
    return int(trial.command[0])


def _bandit_over(count: int, bandit: Callable[[list[Strategy]], Strategy]) -> Strategy:
    """Return the bandit over what stands for the emitters."""
    wanted = "a function of strategies that returns a bandit over them, such as db.Adapt or "
    wanted += "lambda emitters: db.Adapt(emitters, tau=0.1)"
    if not callable(bandit):
        raise TypeError(f"bandit must be {wanted}, got {type(bandit).__name__}")
    made = bandit([_Emitter(index) for index in range(count)])
    if not isinstance(made, Strategy):
        raise TypeError(f"bandit must be {wanted}; it returned {type(made).__name__}")
    return made


def _paths_of(
    strategy: Strategy, path: tuple[int, ...] = ()
) -> Iterator[tuple[int, tuple[int, ...]]]:
    """Return the emitters that a composition is made of, each with its path."""
    if isinstance(strategy, _Emitter):
        yield strategy.index, path
        return
    parts = getattr(strategy, "strategies", None)
    if parts is None:
        raise ValueError(
            "bandit must return a composition of the strategies it is given alone, "
            f"got {strategy!r} in it"
        )
    for index, part in enumerate(parts):
        yield from _paths_of(part, (*path, index))


def _emitters_of(emitters: Sequence[EmitterBase]) -> tuple[EmitterBase, ...]:
    """Return the emitters as a tuple, or say what is wrong with them."""
    try:
        every = tuple(emitters)
    except TypeError:
        raise TypeError(
            f"emitters must be a list of emitters of pyribs, got {type(emitters).__name__}"
        ) from None
    for index, emitter in enumerate(every):
        _of_kind(f"emitters[{index}]", emitter, "ribs.emitters", "EmitterBase")
    return every


def _of_kind(name: str, value: Any, module: str, kind: str) -> Any:  # noqa: ANN401 - of any kind
    """Return an object of pyribs that is of a kind, or say what is wrong with it."""
    if not isinstance(value, getattr(library(module, user="RibsScheduler"), kind)):
        got = f"the class {value.__name__}" if isinstance(value, type) else type(value).__name__
        raise TypeError(f"{name} must be a {module}.{kind}, got {got}")
    return value


def _measures_of(measures: ArrayLike, shape: tuple[int, int]) -> NDArray[np.float64]:
    """Return measures as effects, or say what is wrong with them."""
    wanted = f"measures must be finite numbers of shape {shape}"
    try:
        effects = np.array(measures, dtype=np.float64)
    except (TypeError, ValueError) as error:
        raise type(error)(f"{wanted}: {error}") from None
    if effects.shape != shape:
        raise ValueError(f"{wanted}, got shape {effects.shape}")
    wrong = np.flatnonzero(~np.isfinite(effects).all(axis=1))
    if len(wrong):
        raise ValueError(f"{wanted}, got {effects[wrong[0]].tolist()} in row {wrong[0]}")
    return effects


def _check_length(name: str, values: ArrayLike | None, count: int) -> None:
    """Raise unless there is a value for each solution, or none at all."""
    shape = None if values is None else np.shape(values)
    if shape is not None and shape[:1] != (count,):
        raise ValueError(
            f"{name} must hold a value for each of {count} solutions, got shape {shape}"
        )
