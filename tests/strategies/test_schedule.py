"""A schedule changes phase after its own proposals, wherever it stands."""

import numpy as np
import pytest

import divbandit as db
from divbandit.strategies import Starter

ARM = db.PlanarArm(2)
RMB = db.MotorBabbling()


def choices(schedule, n):
    return db.explore(ARM, schedule, n=n, rng=0).choices.tolist()


@pytest.mark.parametrize(
    ("steps", "expected"),
    [
        ([3, None], [0, 0, 0, 1, 1, 1, 1]),
        ([1, 1, None], [0, 1, 2, 2, 2, 2, 2]),
        ([2, 3, 1], [0, 0, 1, 1, 1, 2, 2]),
        ([1], [0] * 7),
        ([None], [0] * 7),
        ([100, None], [0] * 7),
        ([7, None], [0] * 7),
        ([6, None], [0] * 6 + [1]),
    ],
)
def test_boundaries(steps, expected):
    assert choices(db.Schedule([(count, RMB) for count in steps]), n=7) == expected


def test_a_schedule_in_a_schedule():
    inner = db.Schedule([(2, RMB), (None, RMB)])
    outer = db.Schedule([(1, RMB), (4, inner), (None, inner)])
    run = db.explore(ARM, outer, n=8, rng=0)
    expected = [(0, -1), (1, 0), (1, 0), (1, 1), (1, 1), (2, 1), (2, 1), (2, 1)]
    assert [tuple(path) for path in run.paths] == expected


@pytest.mark.parametrize("outer", [db.Mixture, db.Adapt])
def test_as_a_part_it_counts_its_own_proposals_alone(outer):
    schedule = db.Schedule([(5, RMB), (3, RMB), (None, RMB)])
    run = db.explore(ARM, outer([RMB, schedule]), n=100, rng=0)
    own = run.paths[run.choices == 1]
    assert len(own) > 8
    assert own[:, 1].tolist() == [0] * 5 + [1] * 3 + [2] * (len(own) - 8)
    assert len(own) < 100


def test_choosing_draws_nothing():
    rng, plain = np.random.default_rng(0), np.random.default_rng(0)
    schedule = db.Schedule([(1, RMB), (None, RMB)])
    history = db.History(ARM.motor_space)
    running = Starter(history)(schedule)
    assert [running.choose(history, rng) for _ in range(3)] == [0, 1, 1]
    assert rng.random() == plain.random()
