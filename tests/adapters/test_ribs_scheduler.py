"""RibsScheduler chooses as the bandit does, and does the rest as pyribs' schedulers do."""

import signal
from functools import partial

import numpy as np
import pytest
from ribs.archives import CategoricalArchive, GridArchive, ProximityArchive
from ribs.emitters import EmitterBase, EvolutionStrategyEmitter, GaussianEmitter, IsoLineEmitter
from ribs.schedulers import BanditScheduler, Scheduler

import divbandit as db
from divbandit.adapters import RibsScheduler
from divbandit.bandits import UCB, Exp3, Gain, RoundRobin, WholePast, ucb1

DIM = 10
adapt = partial(db.Adapt, tau=0.5)
in_turn = partial(db.Bandit, estimator=WholePast(), policy=RoundRobin(), tau=0.5)


def sphere(solutions):
    """Return the objectives and measures of pyribs' benchmark (Fontaine et al. 2020)."""
    shift = 5.12 * 0.4
    worst = (5.12 + shift) ** 2 * solutions.shape[1]
    objective = 100 * (1 - np.square(solutions - shift).sum(axis=1) / worst)
    inside = np.abs(solutions) <= 5.12
    clipped = np.where(inside, solutions, 5.12 / np.where(inside, 1, solutions))
    half = solutions.shape[1] // 2
    measures = [clipped[:, :half].sum(axis=1), clipped[:, half:].sum(axis=1)]
    return objective, np.stack(measures, axis=1)


def setting(cells=30, **options):
    """Return an archive and three emitters: one of tiny steps, one of large ones, CMA-ME."""
    most = DIM / 2 * 5.12
    archive = GridArchive(
        solution_dim=DIM, dims=[cells, cells], ranges=[(-most, most)] * 2, seed=0, **options
    )
    start = np.zeros(DIM)
    return archive, [
        GaussianEmitter(archive, sigma=0.001, x0=start, batch_size=8, seed=1),
        IsoLineEmitter(archive, iso_sigma=0.3, x0=start, batch_size=12, seed=2),
        EvolutionStrategyEmitter(archive, x0=start, sigma0=0.5, batch_size=10, seed=3),
    ]


def work(scheduler, batches=60, evaluate=sphere):
    """Do what any script for pyribs does; return the archive's elites."""
    for _ in range(batches):
        objective, measures = evaluate(scheduler.ask())
        scheduler.tell(objective, measures)
    return elites(scheduler.archive)


def elites(archive):
    found = archive.data(return_type="dict")
    order = np.argsort(found["index"])
    return {name: values[order] for name, values in found.items()}


def assert_same(one, other):
    assert one.keys() == other.keys()
    for name, values in one.items():
        np.testing.assert_array_equal(values, other[name])


def adapt_by_hand(batches, rng, *, tau, window=50, alpha=0.1):
    """Explore with ADAPT in plain Python over emitters; return the elites and the choices."""
    archive, emitters = setting()
    covered = db.Coverage(tau, dim=2)
    gains = [[np.pi * tau**2] for _ in emitters]
    chosen = []
    for _ in range(batches):
        means = np.array([np.mean(each[-window:]) for each in gains])
        uniformly, u = rng.random() < alpha, rng.random()
        if uniformly or means.sum() == 0.0:
            index = int(u * len(means))
        else:
            index = int(np.searchsorted(np.cumsum(means) / means.sum(), u, side="right"))
        solutions = emitters[index].ask()
        objective, measures = sphere(solutions)
        info = archive.add(solutions, objective, measures)
        emitters[index].tell(solutions, objective, measures, info)
        gains[index] += [covered.add(effect) for effect in measures]
        chosen.append(index)
    return elites(archive), chosen


def test_equals_adapt_written_by_hand():
    expected, chosen = adapt_by_hand(80, np.random.default_rng(5), tau=0.5)
    scheduler = RibsScheduler(*setting(), adapt, rng=5)
    assert_same(work(scheduler, 80), expected)
    assert scheduler.asked.tolist() == np.bincount(chosen, minlength=3).tolist()
    assert len(set(chosen)) == 3


@pytest.mark.parametrize("add_mode", ["batch", "single"])
def test_equals_the_scheduler_of_pyribs_where_all_are_active(add_mode):
    expected = work(Scheduler(*setting(), add_mode=add_mode))
    ours = RibsScheduler(*setting(), adapt, num_active=3, add_mode=add_mode)
    assert_same(work(ours), expected)
    assert len(ours.archive) > 50
    assert len(ours.history) == 60 * 30


def test_stands_where_the_bandit_of_pyribs_stands():
    """One line of the script differs."""
    covered = []
    for make in (
        lambda archive, emitters: BanditScheduler(archive, emitters, num_active=1),
        lambda archive, emitters: RibsScheduler(archive, emitters, adapt, num_active=1, rng=0),
    ):
        scheduler = make(*setting())
        work(scheduler, 150)
        assert scheduler.active.sum() == 1
        assert len(scheduler.emitter_pool) == 3
        assert scheduler.result_archive is scheduler.archive
        covered.append(scheduler.archive.stats.coverage)
    theirs, ours = covered
    assert ours > 0.8 * theirs > 0.05


@pytest.mark.parametrize(
    "bandit",
    [adapt, partial(ucb1, tau=0.5), partial(db.Adapt, reward=Gain(db.measures.GridCoverage(1)))],
)
def test_learns_who_finds_more(bandit):
    scheduler = RibsScheduler(*setting(), bandit, rng=0)
    work(scheduler, 150)
    small, *large = scheduler.asked
    assert small < 0.2 * max(large)
    small, *large = scheduler.estimates
    assert small < 0.5 * min(large)
    # What was told is all there, with who proposed it.
    sizes = scheduler.asked * [8, 12, 10]
    assert len(scheduler.history) == sizes.sum()
    assert np.bincount(scheduler.history.commands[:, 0].astype(int)).tolist() == sizes.tolist()
    assert {path[0] for path in scheduler.history.paths} == {0, 1, 2}


def test_the_same_draws_the_same_archive():
    one, other, third = (
        work(RibsScheduler(*setting(), adapt, rng=rng), 30)
        for rng in (7, np.random.default_rng(7), 8)
    )
    assert_same(one, other)
    assert len(one["index"]) != len(third["index"]) or (one["index"] != third["index"]).any()


@pytest.mark.parametrize(
    "bandit",
    [
        adapt,
        in_turn,
        db.Mixture,
        partial(db.Bandit, estimator=WholePast(), policy=UCB(), tau=0.5),
        partial(db.Bandit, estimator=WholePast(), policy=Exp3(), tau=0.5),
        lambda parts: db.Adapt([db.Mixture(parts[:2]), parts[2]], tau=0.5),
        lambda parts: db.Schedule([(5, parts[0]), (None, adapt(parts))]),
    ],
)
@pytest.mark.parametrize("num_active", [1, 2, 3])
def test_as_many_are_active_as_wanted(bandit, num_active):
    scheduler = RibsScheduler(*setting(), bandit, num_active=num_active, rng=0)
    for batch in range(20):
        solutions = scheduler.ask()
        assert scheduler.active.sum() == num_active
        assert len(solutions) == np.array([8, 12, 10])[scheduler.active].sum()
        assert scheduler.asked.sum() == (batch + 1) * num_active
        scheduler.tell(*sphere(solutions))
    assert num_active == 1 or scheduler.asked.min() > 0


def test_one_that_is_chosen_again_leaves_its_place_to_the_best_of_the_others():
    """A policy that insists; by what they have found, large steps come next."""

    class First:
        def start(self, *_):
            return self

        def choose(self, *_):
            return 0

    bandit = partial(db.Bandit, estimator=WholePast(), policy=First(), tau=0.5)
    scheduler = RibsScheduler(*setting(), bandit, num_active=2)
    work(scheduler, 30)
    best = 1 + int(np.argmax(scheduler.estimates[1:]))
    assert scheduler.active.tolist() == [True, best == 1, best == 2]
    assert scheduler.asked[0] == 30
    assert scheduler.asked[3 - best] < 10


def test_a_second_archive_and_fields():
    archive, emitters = setting(extra_fields={"note": ((), np.int64)})
    second = setting(cells=5, extra_fields={"note": ((), np.int64)})[0]
    scheduler = RibsScheduler(archive, emitters, adapt, result_archive=second, rng=0)
    assert scheduler.result_archive is second
    for batch in range(10):
        solutions = scheduler.ask()
        scheduler.tell(*sphere(solutions), note=np.full(len(solutions), batch))
    assert len(set(archive.data("note")) & set(range(10))) > 1
    assert 0 < len(second) < len(archive)


def test_an_archive_without_objective():
    archive = ProximityArchive(solution_dim=2, measure_dim=2, k_neighbors=3, novelty_threshold=0.1)
    emitters = [GaussianEmitter(archive, sigma=sigma, x0=[0, 0]) for sigma in (0.001, 0.5)]
    scheduler = RibsScheduler(archive, emitters, partial(db.Adapt, tau=0.1), rng=0)
    work(scheduler, 30, lambda solutions: (None, solutions))
    assert len(archive) > 20
    assert scheduler.asked[1] > scheduler.asked[0]


def rows(n, s=2):
    return np.zeros((n, s))


@pytest.mark.parametrize(
    ("arguments", "fields", "error", "words"),
    [
        (
            (np.zeros(7), rows(8)),
            {},
            ValueError,
            r"objective must be .* shape \(8,\), got shape \(7,\)",
        ),
        ((1.0, rows(8)), {}, ValueError, r"objective must be .* shape \(8,\), got shape \(\)"),
        (
            (np.zeros(8), rows(9)),
            {},
            ValueError,
            r"measures must be .* shape \(8, 2\), got shape \(9, 2\)",
        ),
        ((np.zeros(8), rows(8, 3)), {}, ValueError, r"measures must .*, got shape \(8, 3\)"),
        (
            (np.zeros(8), None),
            {},
            (TypeError, ValueError),
            "measures must be finite numbers of shape",
        ),
        ((np.zeros(8), [["x", "y"]] * 8), {}, ValueError, "measures must be finite .*: could not"),
        ((np.zeros(8), [[1.0, 2.0]] * 3 + [[np.nan, 1.0]] * 5), {}, ValueError, "in row 3"),
        ((np.full(8, np.nan), rows(8)), {}, ValueError, "objective must be .*, got nan in row 0"),
        (
            ([1, [2]] * 4, rows(8)),
            {},
            ValueError,
            "objective must be finite numbers of .*: setting",
        ),
        (([1] * 8, rows(8)), {"note": [1, [2]] * 4}, ValueError, "note must hold a value .*: sett"),
        ((None, rows(8)), {}, ValueError, "objective"),
        ((np.zeros(8), rows(8)), {"note": [1]}, ValueError, "note must hold a value for each of 8"),
        ((np.zeros(8), rows(8)), {"note": rows(8)}, ValueError, "note"),
        ((np.zeros(8),), {}, TypeError, "measures"),
    ],
)
def test_a_wrong_tell_loses_nothing(arguments, fields, error, words):
    expected = work(RibsScheduler(*setting(), in_turn), 3)
    scheduler = RibsScheduler(*setting(), in_turn)
    solutions = scheduler.ask()
    for _ in range(2):
        with pytest.raises(error, match=words):
            scheduler.tell(*arguments, **fields)
        assert len(scheduler.archive) == len(scheduler.history) == 0
        assert scheduler.solutions is solutions
    scheduler.tell(*sphere(solutions))
    assert scheduler.solutions is None
    assert_same(work(scheduler, 2), expected)


def test_out_of_turn():
    scheduler = RibsScheduler(*setting(), in_turn)
    with pytest.raises(RuntimeError, match="tell must follow ask: there are no solutions"):
        scheduler.tell([1.0], [[0.0, 0.0]])
    solutions = scheduler.ask()
    with pytest.raises(RuntimeError, match="ask must follow tell: those asked for last"):
        scheduler.ask()
    scheduler.tell(*sphere(solutions))
    with pytest.raises(RuntimeError, match="tell must follow ask"):
        scheduler.tell(*sphere(solutions))
    assert len(scheduler.history) == 8
    for call in (scheduler.ask_dqd, partial(scheduler.tell_dqd, [1], [[1]], [[[1]]])):
        with pytest.raises(NotImplementedError, match="it takes no gradients"):
            call()


def test_a_reward_that_raises_loses_nothing():
    def sometimes(_, history):
        if len(history) == 4:
            raise ArithmeticError("out of order")
        return 1.0

    scheduler = RibsScheduler(*setting(), partial(db.Adapt, reward=sometimes), rng=0)
    solutions = scheduler.ask()
    with pytest.raises(ArithmeticError, match="out of order"):
        scheduler.tell(*sphere(solutions))
    assert len(scheduler.archive) > 0
    count = len(solutions) + len(scheduler.ask())
    assert len(scheduler.history) == len(solutions)
    scheduler.tell(*sphere(scheduler.solutions))
    assert len(scheduler.history) == count


class Odd(EmitterBase):
    """An emitter that raises at times, hears Ctrl-C at others, or asks for nothing."""

    def __init__(self, archive, ask=None, tell=None, count=3):
        super().__init__(
            archive, solution_dim=DIM, bounds=None, lower_bounds=None, upper_bounds=None
        )
        self._does, self._count = {"ask": ask, "tell": tell}, count
        self.told = 0

    def ask(self):
        if self._does["ask"] is not None:
            self._does["ask"]()
        return np.full((self._count, DIM), 0.5)

    def tell(self, solution, **_):
        self.told += len(solution)
        if self._does["tell"] is not None:
            self._does["tell"]()


def odd(**options):
    archive = setting()[0]
    emitter = Odd(archive, **options)
    return emitter, RibsScheduler(archive, [emitter], adapt)


def test_an_emitter_that_raises():
    failures = iter([True, False, True, False])

    def fail():
        if next(failures):
            raise OSError("no emitter today")

    _, scheduler = odd(ask=fail)
    for _ in range(2):
        with pytest.raises(OSError, match="no emitter today"):
            scheduler.ask()
        assert scheduler.solutions is None
        scheduler.tell(*sphere(scheduler.ask()))
    assert len(scheduler.history) == 6


def test_an_emitter_that_asks_for_nothing():
    _, scheduler = odd(count=0)
    with pytest.raises(
        ValueError, match=r"emitters must ask for at least one .*, got none from Odd"
    ):
        scheduler.ask()


def test_ctrl_c_is_heard_between_steps():
    press = partial(signal.raise_signal, signal.SIGINT)
    emitter, scheduler = odd(ask=press, tell=press)
    with pytest.raises(KeyboardInterrupt):
        scheduler.ask()
    with pytest.raises(KeyboardInterrupt):
        scheduler.tell(*sphere(scheduler.solutions))
    assert scheduler.solutions is None
    assert emitter.told == len(scheduler.history) == 3
    with pytest.raises(KeyboardInterrupt):
        scheduler.ask()
    assert len(scheduler.solutions) == 3


ARCHIVE, EMITTERS = setting()


@pytest.mark.parametrize(
    ("changed", "error", "words"),
    [
        ({"archive": GridArchive}, TypeError, "archive must be .*ArchiveBase, got the class GridA"),
        ({"archive": EMITTERS}, TypeError, "archive must be a ribs.archives.ArchiveBase, got list"),
        ({"emitters": EMITTERS[0]}, TypeError, "emitters must be a list of emitters .*Gaussian"),
        ({"emitters": [GaussianEmitter]}, TypeError, r"emitters\[0\] must be .*the class Gaussian"),
        ({"emitters": [EMITTERS[0], 3]}, TypeError, r"emitters\[1\] must be .*, got int"),
        ({"emitters": []}, ValueError, "at least one emitter"),
        ({"emitters": EMITTERS[:1] * 2}, ValueError, "unique"),
        ({"bandit": None}, TypeError, "bandit must be a function of strategies .*, got NoneType"),
        ({"bandit": db.Adapt([db.MotorBabbling()])}, TypeError, "such as db.Adapt or .*got Adapt"),
        ({"bandit": len}, TypeError, "bandit must be a function of .*; it returned int"),
        ({"bandit": ucb1}, ValueError, "tau must be given, or reward"),
        ({"bandit": db.Bandit}, TypeError, "estimator"),
        (
            {"bandit": lambda parts: db.Mixture([*parts, db.MotorBabbling()])},
            ValueError,
            r"bandit must return .* it is given alone, got MotorBabbling\(\) in it",
        ),
        (
            {"bandit": lambda parts: adapt(parts[:2])},
            ValueError,
            r"bandit must be over all the strategies it is given, got none for emitters\[2\]",
        ),
        (
            {"result_archive": GridArchive(solution_dim=DIM, dims=[9], ranges=[(0, 1)])},
            ValueError,
            "2 measures, got 1",
        ),
        ({"num_active": 0}, ValueError, "num_active must be from 1 to 3, got 0"),
        ({"num_active": 4}, ValueError, "num_active must be from 1 to 3, got 4"),
        ({"add_mode": "one"}, ValueError, "add_mode"),
        ({"result_archive": ARCHIVE}, ValueError, "result_archive"),
        ({"result_archive": 3}, TypeError, "result_archive must be a ribs.archives.ArchiveBase"),
        ({"rng": "seed"}, TypeError, "rng must be None, an int"),
    ],
)
def test_refuses(changed, error, words):
    arguments = {"archive": ARCHIVE, "emitters": EMITTERS, "bandit": adapt, **changed}
    with pytest.raises(error, match=words):
        RibsScheduler(**arguments)


def test_refuses_proposals_of_its_own():
    class Alone(db.Composite):
        def choose(self, *_):
            """Choose none."""

        def propose(self, *_):
            return [1.0]

    scheduler = RibsScheduler(ARCHIVE, EMITTERS, Alone)
    with pytest.raises(ValueError, match=r"as a Composite does, got a trial of path \(\)"):
        scheduler.ask()


def test_one_emitter_in_two_places():
    scheduler = RibsScheduler(*setting(), lambda parts: adapt([*parts, parts[0]]), rng=0)
    work(scheduler, 30)
    assert {path[0] for path in scheduler.history.paths} == {0, 1, 2, 3}
    assert scheduler.asked.sum() == 30


def test_refuses_measures_that_cannot_be_rewarded():
    archive = GridArchive(solution_dim=2, dims=[1] * 33, ranges=[(0, 1)] * 33)
    emitters = [GaussianEmitter(archive, sigma=1, x0=[0, 0])]
    with pytest.raises(ValueError, match="effects must be of a dimension that Adapt takes, got 33"):
        RibsScheduler(archive, emitters, adapt)
    archive = CategoricalArchive(solution_dim=2, categories=[["a", "b"]])
    emitters = [GaussianEmitter(archive, sigma=1, x0=[0, 0], batch_size=2)]
    scheduler = RibsScheduler(archive, emitters, adapt)
    scheduler.ask()
    with pytest.raises(ValueError, match=r"measures must be finite numbers of shape .*: could not"):
        scheduler.tell([1, 2], [["a"], ["b"]])
