"""Task: what an exploration is made of, once or once for each seed."""

import itertools

import divbandit as db

TASK = db.experiments.Task(db.PlanarArm(2), db.MotorBabbling(), 10)


def test_it_holds_what_it_was_given():
    arm, strategy = db.PlanarArm(2), db.MotorBabbling()
    task = db.experiments.Task(environment=arm, strategy=strategy, n=10, rng=3)
    assert task.environment is arm
    assert task.strategy is strategy
    assert (task.n, task.rng) == (10, 3)


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
