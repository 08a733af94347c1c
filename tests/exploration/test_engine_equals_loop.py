"""The engine makes of any composition what the loop in Python makes of it, bit by bit."""

import numpy as np
import pytest
from hypothesis import HealthCheck, given, note, settings
from hypothesis import strategies as st

import divbandit as db
from divbandit.bandits import UCB, CompetenceProgress, WholePast
from tests.compositions import bandits, composed
from tests.exploration.random_compositions import compositions as random_compositions
from tests.exploration.random_environments import environments
from tests.exploration.sameness import differences
from tests.generators import BIT_GENERATORS, MOST, scripted, state, twins

RMB, RGB = db.MotorBabbling, db.GoalBabbling

CHECKS = [HealthCheck.too_slow, HealthCheck.data_too_large]
FULL = settings(max_examples=300, deadline=None, derandomize=True, suppress_health_check=CHECKS)


def outcome(environment, strategy, n, rng, engine):
    """Return a run and None, or what was observed until an error, and that error in words."""
    try:
        return db.explore(environment, strategy, n, rng=rng, engine=engine), None
    except ValueError as error:
        return error.explorer.result(), str(error)


def assert_same(environment, strategy, n, rngs):
    """Explore with both engines, from generators in the same state, and compare all there is."""
    (run, error), (other, other_error) = (
        outcome(environment, strategy, n, rng, engine)
        for rng, engine in zip(rngs, ("python", "rust"), strict=True)
    )
    assert error == other_error
    assert differences(run, other) == []
    assert state(rngs[0]) == state(rngs[1])
    return error


def used(rngs, doubles, words):
    """Draw from each of the generators, also half of a 64-bit word, which some of them keep."""
    for rng in rngs:
        rng.random(doubles)
        rng.integers(2**32, size=words, dtype=np.uint32)
    return rngs


@given(st.data())
@FULL
def test_any_composition_in_any_environment(data):
    environment, dim = data.draw(environments())
    needs_goals = environment.sensory_space is None
    strategy = data.draw(random_compositions(dim=dim, needs_goals=needs_goals))
    rngs = twins(data.draw(st.sampled_from(BIT_GENERATORS)), data.draw(st.integers(0, 2**64)))
    used(rngs, data.draw(st.integers(0, 700)), data.draw(st.integers(0, 3)))
    note(f"motor_space={environment.motor_space}, sensory_space={environment.sensory_space}")
    assert_same(environment, strategy, data.draw(st.integers(1, 120)), rngs)


EDGES = st.sampled_from([0.0, 2.0**-53, 0.25, 0.5, 1 - 2.0**-52, 1 - 2.0**-53])
DRAWS = st.lists(
    st.one_of(EDGES, EDGES, st.integers(0, 2**53 - 1).map(lambda k: k * 2.0**-53)), min_size=1
)


@given(DRAWS, st.integers(1, 3), random_compositions())
@settings(FULL, max_examples=200)
def test_any_draws(draws, joints, strategy):
    """Also those that come once in 2**53 times: what lies on an edge falls to the same side."""
    draws = (draws * MOST)[:MOST]
    rngs = scripted(*draws), scripted(*draws)
    assert [rng.random() for rng in rngs] == [draws[0]] * 2
    assert_same(db.PlanarArm(joints), strategy, 60, rngs)


LONGER = composed() | bandits()


@pytest.mark.parametrize("name", LONGER)
def test_a_longer_run(name):
    assert assert_same(db.PlanarArm(20), LONGER[name], 1000, twins(np.random.PCG64)) is None


def shared_schedule():
    """Return a mixture whose parts go through one and the same schedule."""
    schedule = db.Schedule([(5, RMB()), (20, RGB(0.5)), (None, RGB(0.001))])
    return db.Mixture([schedule, db.Mixture([schedule, RMB()]), schedule])


def shared_adapt():
    """Return a mixture whose parts learn for one and the same bandit."""
    adapt = db.Adapt([RMB(), RGB(0.05)], tau=0.1, window=7)
    return db.Mixture([adapt, db.Adapt([adapt, RGB(0.5)], tau=0.05, window=9), adapt])


def progress_twice():
    """Return bandits that are paid the same progress, of which each goal counts for its own."""
    inner = db.Bandit(
        [RGB(0.5), RGB(0.01)], reward=CompetenceProgress(), estimator=WholePast(), policy=UCB()
    )
    return db.Adapt([inner, RGB(0.05), inner], reward=CompetenceProgress(), window=5)


def ties():
    """Return goal babbling whose goals are so far away that all effects are equally near."""
    return db.Mixture([RMB(), RGB(0.05, goals=db.Box([1e200, 0], [2e200, 0]))])


@pytest.mark.parametrize(
    "make", [shared_schedule, shared_adapt, progress_twice, ties], ids=lambda make: make.__name__
)
def test_parts_that_keep_state(make):
    assert_same(db.PlanarArm(7), make(), 500, twins(np.random.PCG64))


@pytest.mark.parametrize("bit_generator", BIT_GENERATORS)
def test_one_exploration_after_another_from_one_generator(bit_generator):
    """Each goes on in the stream where the one before it ended, whoever drew."""
    adapt = db.Adapt([RMB(), RGB(0.05)], window=10)
    rngs = used(twins(bit_generator), 3, 1)
    for n in (1, 2, 313, 40):
        assert_same(db.PlanarArm(3), adapt, n, rngs)
        assert_same(db.PlanarArm(3), adapt, n, rngs[::-1])
        assert rngs[0].integers(2**32, dtype=np.uint32) == rngs[1].integers(2**32, dtype=np.uint32)


@pytest.mark.parametrize("engine", ["python", "rust"])
def test_the_arrays_are_the_callers_own(engine):
    adapt = db.Adapt([RMB(), RGB(0.05)])
    run = db.explore(db.PlanarArm(3), adapt, 50, rng=0, engine=engine)
    for array in (run.commands, run.effects, run.paths, run.estimates):
        assert array.flags.writeable
        assert array.flags.c_contiguous
        assert array.flags.aligned
    again = db.explore(db.PlanarArm(3), adapt, 50, rng=0, engine=engine)
    run.effects[:], run.commands[:] = 7, 7
    assert differences(again, db.explore(db.PlanarArm(3), adapt, 50, rng=0, engine="python")) == []
