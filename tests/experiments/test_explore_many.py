"""explore_many: the very explorations of a plain loop, whatever the number of threads."""

import itertools
import threading
from functools import partial

import numpy as np
import pytest

import divbandit as db
from divbandit.experiments import Task
from tests.compositions import compositions
from tests.generators import state
from tests.threads import at_once

ARM = db.PlanarArm(5)
ADAPT = db.Adapt([db.MotorBabbling(), db.GoalBabbling(0.05)], window=10)
SHORT = Task(ARM, ADAPT, n=30)


class Backwards(db.Strategy):
    """Remembers its last command, and proposes the opposite of it every other time."""

    def __init__(self):
        self.last = None

    def propose(self, history, rng):
        space = history.motor_space
        if self.last is None:
            return space.low + rng.random(space.dim) * (space.high - space.low)
        return -self.last

    def observe(self, trial, effect):
        del effect
        self.last = None if self.last is not None else np.asarray(trial.command)


def bits(run):
    believed = b"" if run.estimates is None else run.estimates.tobytes()
    return [array.tobytes() for array in (run.commands, run.effects, run.paths)] + [believed]


def explored(tasks, **options):
    """Return the bits of each exploration, by place."""
    runs = dict(db.explore_many(tasks, **options))
    return [bits(runs[place]) for place in range(len(runs))]


@pytest.mark.parametrize("jobs", [1, 3])
def test_the_same_bits_as_a_plain_loop(jobs):
    """All share one environment, and each strategy is shared by two tasks of other lengths."""
    strategies = [*compositions().values(), Backwards()]
    tasks = [
        Task(ARM, strategy, n, rng=seed)
        for n in (60, 20)
        for seed, strategy in enumerate(strategies)
    ]
    plain = [db.explore(ARM, task.strategy, task.n, rng=task.rng) for task in tasks]
    assert explored(tasks, jobs=jobs) == [bits(run) for run in plain]


@pytest.mark.parametrize("jobs", [1, 2, 5])
def test_an_environment_in_python_shared_by_threads(jobs):
    square = db.FunctionEnvironment(
        lambda x: x**2, db.Box([-1, -1], [1, 1]), db.Box([0, 0], [1, 1])
    )
    tasks = [*Task(square, ADAPT, n=50).over(range(12))]
    plain = [bits(db.explore(square, ADAPT, n=50, rng=seed)) for seed in range(12)]
    assert explored(tasks, jobs=jobs) == plain


@pytest.mark.parametrize("jobs", [1, 2, 5])
def test_seeds_by_place_are_the_children_of_a_sequence(jobs):
    children = np.random.SeedSequence(9).spawn(7)
    plain = [bits(db.explore(ARM, ADAPT, n=30, rng=child)) for child in children]
    assert explored([SHORT] * 7, rng=9, jobs=jobs) == plain


def test_a_sequence_that_was_spawned_itself_stays_as_it_is():
    parent, twin = (np.random.SeedSequence(3, pool_size=8).spawn(2)[1] for _ in range(2))
    plain = [bits(db.explore(ARM, ADAPT, n=30, rng=child)) for child in twin.spawn(4)]
    assert explored([SHORT] * 4, rng=parent) == plain
    assert parent.n_children_spawned == 0
    assert explored([SHORT] * 4, rng=parent) == plain


def test_a_generator_gives_one_number_at_the_call():
    rng, twin = (np.random.default_rng(4) for _ in range(2))
    many = db.explore_many([SHORT] * 3, rng=rng)
    seed = int(twin.random() * 2**53)
    assert state(rng) == state(twin)
    runs = dict(many)
    assert state(rng) == state(twin)
    assert [bits(runs[place]) for place in range(3)] == explored([SHORT] * 3, rng=seed)


def test_a_seed_of_its_own_is_used_and_moves_no_other():
    mixed = [SHORT, *SHORT.over([5]), SHORT]
    plain = explored([SHORT] * 3, rng=1)
    found = explored(mixed, rng=1)
    assert found[0] == plain[0]
    assert found[1] == bits(db.explore(ARM, ADAPT, n=30, rng=5)) != plain[1]
    assert found[2] == plain[2]


def test_a_generator_of_its_own_is_drawn_from():
    rng, twin = (np.random.default_rng(4) for _ in range(2))
    plain = bits(db.explore(ARM, ADAPT, n=30, rng=twin))
    assert explored(SHORT.over([rng])) == [plain]
    assert state(rng) == state(twin)


def test_they_come_as_they_finish():
    second_is_here = threading.Event()

    def patient(x):
        assert second_is_here.wait(60)
        return x

    box = db.Box([0], [1])
    waiting = Task(db.FunctionEnvironment(patient, box), db.MotorBabbling(), n=1)
    quick = Task(db.FunctionEnvironment(lambda x: x, box), db.MotorBabbling(), n=1)
    places = []
    for place, _ in db.explore_many([waiting, quick], jobs=2):
        places.append(place)
        second_is_here.set()
    assert places == [1, 0]


@pytest.mark.parametrize("jobs", [1, 2, 5])
def test_what_keep_returns_is_kept(jobs):
    kept = dict(
        db.explore_many(SHORT.over(range(9)), keep=lambda run: run.effects[-1, 0], jobs=jobs)
    )
    plain = {seed: db.explore(ARM, ADAPT, n=30, rng=seed).effects[-1, 0] for seed in range(9)}
    assert kept == plain


@pytest.mark.parametrize("jobs", [1, 3])
def test_progress_is_told_of_each_in_the_thread_that_asks(jobs):
    told = []
    many = db.explore_many(
        [SHORT] * 8, jobs=jobs, progress=lambda: told.append(threading.current_thread())
    )
    assert told == []
    for count, _ in enumerate(many, start=1):
        assert len(told) == count
    assert told == [threading.current_thread()] * 8


def test_no_tasks_give_nothing():
    assert list(db.explore_many([])) == []
    assert list(db.explore_many(iter(()), jobs=3, progress=pytest.fail)) == []


def test_explorations_within_what_keeps_an_exploration():
    def keep(run):
        best = run.effects[:, 0].argmax()
        return [
            bits for _, bits in sorted(db.explore_many([SHORT] * 2, rng=int(best), keep=bits_of))
        ]

    def bits_of(run):
        return tuple(bits(run))

    plain = {}
    for seed in range(4):
        best = db.explore(ARM, ADAPT, n=30, rng=seed).effects[:, 0].argmax()
        plain[seed] = [tuple(run) for run in explored([SHORT] * 2, rng=int(best), jobs=1)]
    assert dict(db.explore_many(SHORT.over(range(4)), keep=keep, jobs=2)) == plain


def test_many_at_once_from_several_threads():
    found = at_once(partial(explored, [SHORT] * 5, rng=k, jobs=2) for k in range(4))
    assert found == [explored([SHORT] * 5, rng=k, jobs=1) for k in range(4)]


TASK = Task(db.PlanarArm(2), db.MotorBabbling(), 10)


def test_over_seeds_differs_in_the_seed_alone():
    tasks = list(TASK.over([4, None, 2]))
    assert [task.rng for task in tasks] == [4, None, 2]
    assert all(task.environment is TASK.environment for task in tasks)
    assert all(task.strategy is TASK.strategy for task in tasks)
    assert all(task.n == 10 for task in tasks)
    assert TASK.rng is None


def test_over_takes_seeds_one_by_one():
    seeds = itertools.count()
    tasks = TASK.over(seeds)
    assert next(seeds) == 0
    assert next(tasks).rng == 1


def test_what_cannot_be_sent_from_a_worker_is_an_error():
    """Not the death of a worker, which would not say why."""
    tasks = [Task(db.FunctionEnvironment(ARM, ARM.motor_space), db.MotorBabbling(), n=5)] * 3
    with pytest.raises(TypeError, match=r"cannot pickle '_thread\.lock' object"):
        list(db.explore_many(tasks, rng=0, jobs=2, keep=lambda _: threading.Lock()))
