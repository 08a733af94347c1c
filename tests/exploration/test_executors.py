"""Evaluations through executors: as many as asked for, never more under way, failures survived."""

import os
import threading
import time
from concurrent.futures import BrokenExecutor, Executor, Future, ProcessPoolExecutor
from concurrent.futures import ThreadPoolExecutor as Threads
from multiprocessing import get_context

import numpy as np
import pytest

import divbandit as db

ARM = db.PlanarArm(4)
ADAPT = db.Adapt([db.MotorBabbling(), db.GoalBabbling(0.05)])


class AtOnce(Executor):
    """Evaluates when it is asked to, in the same thread."""

    def submit(self, function, *arguments, **options):
        future = Future()
        try:
            future.set_result(function(*arguments, **options))
        except Exception as error:  # noqa: BLE001 - handed on
            future.set_exception(error)
        return future


def box(function):
    return db.FunctionEnvironment(function, ARM.motor_space, ARM.sensory_space)


def test_one_at_a_time_is_the_plain_loop():
    plain = db.explore(ARM, ADAPT, n=200, rng=0)
    for executor in (AtOnce(), Threads(1), Threads(3)):
        with executor:
            run = db.explore(ARM, ADAPT, n=200, rng=0, executor=executor, in_flight=1)
        assert run.commands.tobytes() == plain.commands.tobytes()
        assert run.estimates.tobytes() == plain.estimates.tobytes()
        assert run.failures == ()


def test_several_under_way_are_asked_before_any_is_told():
    """With an executor that is done at once it is asking for k, telling all, and so on."""
    run = db.explore(ARM, ADAPT, n=200, rng=0, executor=AtOnce(), in_flight=5)
    explorer = db.Explorer(ADAPT, ARM.motor_space, ARM.sensory_space, rng=0)
    for _ in range(40):
        for trial in [explorer.ask() for _ in range(5)]:
            explorer.tell(trial, ARM(trial.command))
    assert run.effects.tobytes() == explorer.result().effects.tobytes()


def test_as_many_under_way_as_allowed_and_never_more():
    lock, now, seen = threading.Lock(), [0], []

    def slow(command):
        with lock:
            now[0] += 1
            seen.append(now[0])
        time.sleep(0.002)
        with lock:
            now[0] -= 1
        return ARM(command)

    with Threads(8) as executor:
        run = db.explore(box(slow), ADAPT, n=100, rng=0, executor=executor, in_flight=3)
    assert len(run) == 100
    assert max(seen) == 3  # how often depends on what else the machine does


def test_late_ones_are_told_late():
    """The first evaluation ends after all others have been told: it is the last in the log."""
    commands, others_told = [], threading.Event()

    def black_box(command):
        commands.append(command)
        if len(commands) == 1:
            others_told.wait(timeout=60)
        return ARM(command)

    def tell_the_first(explorer, _trial):
        if len(explorer.history) == 19:
            others_told.set()

    with Threads(2) as executor:
        run = db.explore(
            box(black_box),
            ADAPT,
            n=20,
            rng=0,
            executor=executor,
            in_flight=2,
            callbacks=[tell_the_first],
        )
    assert run.commands[-1].tolist() == commands[0].tolist()
    assert run.effects.tolist() == ARM(run.commands).tolist()


@pytest.mark.parametrize("in_flight", [1, 4])
def test_evaluations_that_raise_are_survived(in_flight):
    def fragile(command):
        if command[0] > 1:
            raise RuntimeError("fell over")
        return ARM(command) if command[0] > -2 else [np.nan, 0.0]

    with Threads(4) as executor:
        run = db.explore(
            box(fragile),
            ADAPT,
            n=200,
            rng=0,
            executor=executor,
            in_flight=in_flight,
            on_error="record",
        )
    assert len(run) + len(run.failures) == 200
    assert (run.commands[:, 0] <= 1).all()
    assert (run.commands[:, 0] > -2).all()
    reasons = {failure.reason for failure in run.failures}
    assert reasons == {"RuntimeError: fell over", "ValueError: effect[0] must be finite, got NaN"}
    for failure in run.failures:
        assert failure.command[0] > 1 or failure.command[0] <= -2


def test_nothing_but_failures_is_an_error():
    def broken(command):
        raise KeyError(len(command))

    with (
        Threads(2) as executor,
        pytest.raises(RuntimeError, match="all 7 evaluations failed, last: KeyError: 4"),
    ):
        db.explore(
            box(broken), ADAPT, n=7, rng=0, executor=executor, in_flight=3, on_error="record"
        )


def pid_and_tip(command):
    return [os.getpid(), float(ARM(command)[0])]


def die(command):
    os._exit(len(command))


@pytest.mark.parametrize("method", ["spawn", "forkserver"])
def test_processes(method):
    environment = db.FunctionEnvironment(pid_and_tip, ARM.motor_space)
    with ProcessPoolExecutor(2, mp_context=get_context(method)) as executor:
        run = db.explore(
            environment, db.MotorBabbling(), n=50, rng=0, executor=executor, in_flight=4
        )
    assert os.getpid() not in run.effects[:, 0]
    assert run.effects[:, 1].tolist() == ARM(run.commands)[:, 0].tolist()


def test_an_executor_that_breaks_down_is_an_error():
    environment = db.FunctionEnvironment(die, ARM.motor_space)
    with (
        ProcessPoolExecutor(1, mp_context=get_context("spawn")) as executor,
        pytest.raises(BrokenExecutor),
    ):
        db.explore(environment, db.MotorBabbling(), n=5, rng=0, executor=executor, in_flight=2)


def test_what_a_strategy_raises_is_no_failed_evaluation():
    class Broken(db.Strategy):
        def propose(self, history, rng):
            return history.motor_space.sample(rng)

        def observe(self, trial, effect):
            raise ZeroDivisionError(trial.number, len(effect))

    with Threads(2) as executor, pytest.raises(ZeroDivisionError):
        db.explore(ARM, Broken(), n=5, rng=0, executor=executor, in_flight=2)


BAD = {
    "no executor": ({"executor": 7, "in_flight": 2}, TypeError, "executor must be"),
    "no number": ({"executor": AtOnce()}, ValueError, "in_flight must be given"),
    "zero": ({"executor": AtOnce(), "in_flight": 0}, ValueError, "in_flight must be at least 1"),
    "a half": ({"executor": AtOnce(), "in_flight": 0.5}, TypeError, "in_flight must be a whole"),
    "nowhere": ({"in_flight": 2}, ValueError, "in_flight must be given with an executor"),
    "twice": (
        {"executor": AtOnce(), "in_flight": 2, "jobs": 2},
        ValueError,
        "jobs and executor must not both",
    ),
    "time": ({"timeout": 2.0}, ValueError, "timeout needs worker processes"),
    "no time": ({"timeout": 0, "jobs": 1}, ValueError, "timeout must be a positive"),
    "no jobs": ({"jobs": 0}, ValueError, "jobs must be at least 1"),
    "no batch": ({"batch": None}, TypeError, "batch must be a whole number"),
    "errors": ({"on_error": "ignore"}, ValueError, "on_error must be"),
    "no failures": ({"max_failures": 0}, ValueError, "max_failures must be at least 1"),
    "one callback": ({"callbacks": print}, TypeError, "callbacks must be a list of callables"),
    "a word": ({"callbacks": [7]}, TypeError, r"callbacks\[0\] must be a function"),
    "every": ({"every": "often"}, ValueError, "every must be a duration"),
}


@pytest.mark.parametrize(("options", "error", "words"), BAD.values(), ids=BAD)
def test_bad_arguments_are_refused_before_anything_is_drawn(options, error, words):
    rng = np.random.default_rng(0)
    with pytest.raises(error, match=words):
        db.explore(ARM, ADAPT, n=5, rng=rng, **options)
    assert rng.random() == np.random.default_rng(0).random()
