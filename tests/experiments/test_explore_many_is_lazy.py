"""explore_many draws tasks when there is room, and holds no more than it promises."""

import gc
import threading
import weakref

import pytest

import divbandit as db
from tests.threads import HAS_GIL

TASK = db.experiments.Task(db.PlanarArm(3), db.MotorBabbling(), n=5)


def endless(drawn):
    """Yield tasks without end and keep a list of their places."""
    while True:
        drawn.append(len(drawn))
        yield TASK


def test_nothing_happens_before_the_first_is_asked_for():
    drawn, before = [], threading.enumerate()
    many = db.explore_many(endless(drawn))
    assert drawn == []
    assert threading.enumerate() == before
    many.close()


@pytest.mark.parametrize("jobs", [1, 2, 5])
def test_two_for_each_job_are_drawn_ahead(jobs):
    drawn = []
    many = db.explore_many(endless(drawn), jobs=jobs)
    for count in range(20):
        next(many)
        assert len(drawn) == 2 * jobs + count
    many.close()


def test_tasks_are_drawn_by_the_thread_that_asks():
    drawers = set()

    def tasks():
        for _ in range(10):
            drawers.add(threading.current_thread())
            yield TASK

    list(db.explore_many(tasks(), jobs=3))
    assert drawers == {threading.current_thread()}


@pytest.mark.parametrize("jobs", [1, 2, 5])
def test_the_threads_go_on_while_the_first_is_looked_at(jobs):
    finished = threading.Semaphore(0)
    many = db.explore_many(endless([]), keep=lambda _: finished.release(), jobs=jobs)
    next(many)
    for _ in range(2 * jobs):
        assert finished.acquire(timeout=60)
    many.close()
    assert not finished.acquire(blocking=False)


@pytest.mark.parametrize(("tasks", "threads"), [(1, 1), (3, 3), (50, 4)])
def test_no_more_threads_than_tasks_or_jobs(tasks, threads):
    workers = set()
    everyone_is_here = threading.Barrier(threads)

    def keep(_):
        if threading.current_thread() not in workers:
            workers.add(threading.current_thread())
            everyone_is_here.wait(60)

    list(db.explore_many([TASK] * tasks, keep=keep, jobs=4))
    assert len(workers) == threads


@pytest.mark.parametrize("jobs", [1, 3])
def test_explorations_do_not_outlive_what_is_kept_of_them(jobs):
    alive, most, lock = [], [], threading.Lock()

    def keep(run):
        with lock:
            alive[:] = [one for one in alive if one() is not None]
            alive.append(weakref.ref(run))
            most.append(len(alive))
        return float(run.effects[-1, 0])

    before = explorations()
    kept = dict(db.explore_many(TASK.over(range(2000)), keep=keep, jobs=jobs))
    assert len(kept) == 2000
    assert max(most) <= jobs
    assert all(one() is None for one in alive)
    assert explorations() == before


def test_whole_explorations_are_forgotten_when_they_were_yielded():
    alive, most = weakref.WeakSet(), 0
    for _, run in db.explore_many(TASK.over(range(300)), jobs=2):
        alive.add(run)
        del run
        most = max(most, len(alive))
    # A thread may be just about to forget its last; without the global lock it is the one that made
    # an object that frees it, when it comes to it.
    assert most <= (2 if HAS_GIL else 30)
    gc.collect()
    assert len(alive) == 0


def explorations():
    gc.collect()
    return sum(isinstance(one, db.Exploration) for one in gc.get_objects())
