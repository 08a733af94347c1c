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

    It cannot be pickled, as pyribs' schedulers can: save the archive.

    Parameters
    ----------
    archive : ribs.archives.ArchiveBase
    emitters : sequence of ribs.emitters.EmitterBase
        Those to choose among.
    bandit : callable
        A function of a list of strategies, one for each emitter, that returns a bandit over them:
        ``divbandit.Adapt``, or ``lambda emitters: divbandit.Adapt(emitters, tau=0.1)``. `tau` is in
        the units of the measures, and of use if it is about the width of an archive's cell. Any
        composition of all these strategies will do, such as a `Mixture`.
    result_archive : ribs.archives.ArchiveBase, optional
        A second archive to which all solutions are added.
    num_active : int
        How many emitters are asked at a time. The bandit chooses as many times, at each `ask`, so
        that there is no ``reselect``; an emitter that is chosen again leaves its place to the one
        with the largest estimate of those that are left.
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
            if result_archive.measure_dim != archive.measure_dim:
                raise ValueError(
                    f"result_archive must have the archive's {archive.measure_dim} measures, "
                    f"got {result_archive.measure_dim}"
                )
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
        self._places = dict(_places_of(given))
        self._paths = {index: path for path, index in self._places.items()}
        if len(self._paths) < count:
            left_out = min(set(range(count)) - self._paths.keys())
            raise ValueError(
                "bandit must be over all the strategies it is given, "
                f"got none for emitters[{left_out}]"
            )
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
            if trial.path not in self._places:
                raise ValueError(
                    "bandit must let one of its strategies propose, as a Composite does, "
                    f"got a trial of path {trial.path}"
                )
            chosen.setdefault(self._places[trial.path], trial)
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
            chosen[each] = _choice(self._paths[each])
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
        count = len(self.solutions)
        effects = _numbers("measures", measures, (count, int(self.archive.measure_dim)))
        if objective is not None:
            _numbers("objective", objective, (count,))
        for name, values in fields.items():
            _check_length(name, values, count)
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
            self.history.append([self._places[trial.path]], effect, path=trial.path)
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
        return f"<RibsScheduler of {len(self.history)} solutions, emitters asked: {self.asked}>"


class _Emitter(Strategy):
    """What stands for an emitter in the bandit: its trials say who was chosen."""

    def __init__(self, index: int) -> None:
        self.index = index

    def propose(self, history: History, rng: Generator) -> Trial:
        """Propose the emitter."""
        del history, rng
        return Trial([0.0])  # its path says which one it is


def _choice(path: tuple[int, ...]) -> Trial:
    """Return the trial of composites that chose along a path."""
    trial = Trial([0.0])
    for part in reversed(path):
        trial = trial.proposed_by(part)
    return trial


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


def _places_of(
    strategy: Strategy, path: tuple[int, ...] = ()
) -> Iterator[tuple[tuple[int, ...], int]]:
    """Return the paths in a composition, each with the index of the emitter that it leads to."""
    if isinstance(strategy, _Emitter):
        yield path, strategy.index
        return
    parts = getattr(strategy, "strategies", None)
    if parts is None:
        raise ValueError(
            "bandit must return a composition of the strategies it is given alone, "
            f"got {strategy!r} in it"
        )
    for index, part in enumerate(parts):
        yield from _places_of(part, (*path, index))


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


def _numbers(name: str, values: ArrayLike, shape: tuple[int, ...]) -> NDArray[np.float64]:
    """Return a copy of what was told of the solutions, or say what is wrong with it."""
    wanted = f"{name} must be finite numbers of shape {shape}"
    try:
        numbers = np.array(values, dtype=np.float64)
    except (TypeError, ValueError) as error:
        raise type(error)(f"{wanted}: {error}") from None
    if numbers.shape != shape:
        raise ValueError(f"{wanted}, got shape {numbers.shape}")
    wrong = np.argwhere(~np.isfinite(numbers))
    if len(wrong):
        row = wrong[0, 0]
        raise ValueError(f"{wanted}, got {numbers[row].tolist()} in row {row}")
    return numbers


def _check_length(name: str, values: ArrayLike | None, count: int) -> None:
    """Raise unless there is a value for each solution, or none at all."""
    wanted = f"{name} must hold a value for each of {count} solutions"
    try:
        shape = (count,) if values is None else np.shape(values)
    except ValueError as error:  # rows of different lengths
        raise ValueError(f"{wanted}: {error}") from None
    if shape[:1] != (count,):
        raise ValueError(f"{wanted}, got shape {shape}")
