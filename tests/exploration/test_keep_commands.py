"""keep_commands=False: the same exploration, without its motor commands."""

import copy
import pickle

import numpy as np
import pytest

import divbandit as db
from tests.compositions import NAMES, compositions
from tests.generators import state

ARM = db.PlanarArm(4)
ADAPT = db.Adapt([db.MotorBabbling(), db.GoalBabbling(0.05)])
OTHERS = ("effects", "paths", "choices", "estimates")


def without(engine="auto", n=60):
    return db.explore(ARM, ADAPT, n, rng=0, engine=engine, keep_commands=False)


def assert_missing(run):
    assert not hasattr(run, "commands")
    with pytest.raises(AttributeError, match=r"commands were not kept.*keep_commands=True"):
        _ = run.commands


@pytest.mark.parametrize("engine", ["auto", "python"])
@pytest.mark.parametrize("name", NAMES)
def test_all_else_is_the_same(name, engine):
    rng, other = np.random.default_rng(3), np.random.default_rng(3)
    full = db.explore(ARM, compositions()[name], 60, rng=rng)
    run = db.explore(ARM, compositions()[name], 60, rng=other, engine=engine, keep_commands=False)
    for array in OTHERS:
        assert np.array_equal(getattr(run, array), getattr(full, array))
    assert state(rng) == state(other)
    assert_missing(run)


@pytest.mark.parametrize("engine", ["rust", "python"])
def test_what_does_not_need_them_works(engine, tmp_path):
    run = without(engine)
    assert (len(run), repr(run)) == (60, "<Exploration of 60 evaluations, 4 -> 2>")
    assert run.coverage(0.02).shape == (60,)
    run.save(tmp_path / "run")
    for again in (db.Exploration.load(tmp_path / "run"), copy.deepcopy(run)):
        assert_missing(again)
        assert all(np.array_equal(getattr(again, a), getattr(run, a)) for a in OTHERS)
        assert again.motor_space == run.motor_space
    assert_missing(pickle.loads(pickle.dumps(run)))  # noqa: S301


def test_an_explorer_can_leave_them_out():
    explorer = db.Explorer(ADAPT, ARM.motor_space, ARM.sensory_space, rng=0)
    explorer.tell(explorer.ask(), [0.5, 0.5])
    assert explorer.result().commands.shape == (1, 4)
    assert_missing(explorer.result(keep_commands=False))


def test_another_missing_name_is_said_as_always():
    with pytest.raises(AttributeError, match="object has no attribute 'command'"):
        _ = without().command


@pytest.mark.parametrize("value", [None, 1, "no", [True]])
def test_it_must_be_true_or_false(value):
    with pytest.raises(TypeError, match="keep_commands must be True or False, got"):
        db.explore(ARM, ADAPT, 10, keep_commands=value)
