"""The Rust engine makes of any composition what the Python loop makes of it, bit by bit."""

import numpy as np
import pytest
from hypothesis import HealthCheck, given, note, settings
from hypothesis import strategies as st

import divbandit as db
from tests.compositions import adapted, compositions
from tests.exploration.chosen_stream import BELOW_ONE, MOST, stream
from tests.exploration.random_arms import arms
from tests.exploration.random_compositions import compositions as random_compositions
from tests.exploration.sameness import differences
from tests.generators import BIT_GENERATORS, state, twins

RMB, RGB = db.MotorBabbling, db.GoalBabbling


def assert_same(arm, strategy, n, rngs, engine="rust"):
    """Explore with both engines, from generators in the same state, and compare all there is."""
    engines = ("python", engine)
    run, other = (
        db.explore(arm, strategy, n, rng=rng, engine=each)
        for rng, each in zip(rngs, engines, strict=True)
    )
    assert differences(run, other) == []
    assert state(rngs[0]) == state(rngs[1])


def used(rngs, doubles, words):
    """Draw from each of the generators, also half of a 64-bit word, which some of them keep."""
    for rng in rngs:
        rng.random(doubles)
        rng.integers(2**32, size=words, dtype=np.uint32)
    return rngs


@given(st.data())
@settings(
    max_examples=300,
    deadline=None,
    derandomize=True,
    suppress_health_check=[HealthCheck.too_slow, HealthCheck.data_too_large],
)
def test_any_composition(data):
    arm = data.draw(arms())
    strategy = data.draw(random_compositions(needs_goals=arm.sensory_space is None))
    rngs = twins(data.draw(st.sampled_from(BIT_GENERATORS)), data.draw(st.integers(0, 2**64)))
    used(rngs, data.draw(st.integers(0, 700)), data.draw(st.integers(0, 3)))
    note(f"motor_space={arm.motor_space}, sensory_space={arm.sensory_space}")
    assert_same(arm, strategy, data.draw(st.integers(1, 120)), rngs)


EDGES = st.sampled_from([0.0, 2.0**-53, 0.25, 0.5, 1 - 2.0**-52, BELOW_ONE])
DRAWS = st.lists(
    st.one_of(EDGES, EDGES, st.integers(0, 2**53 - 1).map(lambda k: k * 2.0**-53)), min_size=1
)


@given(DRAWS, st.integers(1, 3), random_compositions())
@settings(
    max_examples=200,
    deadline=None,
    derandomize=True,
    suppress_health_check=[HealthCheck.too_slow, HealthCheck.data_too_large],
)
def test_any_draws(draws, joints, strategy):
    """Also those that come once in 2**53 times: what lies on an edge falls to the same side."""
    draws = (draws * MOST)[:MOST]
    rngs = stream(draws), stream(draws)
    assert [rng.random() for rng in rngs] == [draws[0]] * 2
    assert_same(db.PlanarArm(joints), strategy, 60, rngs)


PLAIN = {
    name: each
    for name, each in compositions().items()
    if ", by " not in name and not name.startswith(("bandit, ", "the default"))
}
PLAIN = {name: each for name, each in PLAIN.items() if name not in adapted()}
PLAIN.pop("adapt by the grid, of an adapt")


@pytest.mark.parametrize("name", PLAIN)
def test_a_longer_run(name):
    assert_same(db.PlanarArm(20), PLAIN[name], 1000, twins(np.random.PCG64))


def shared_schedule():
    """Return a mixture whose parts go through one and the same schedule."""
    schedule = db.Schedule([(5, RMB()), (20, RGB(0.5)), (None, RGB(0.001))])
    return db.Mixture([schedule, db.Mixture([schedule, RMB()]), schedule])


def shared_adapt():
    """Return a mixture whose parts learn for one and the same bandit."""
    adapt = db.Adapt([RMB(), RGB(0.05)], tau=0.1, window=7)
    return db.Mixture([adapt, db.Adapt([adapt, RGB(0.5)], tau=0.05, window=9), adapt])


def used_schedules():
    inner = db.Schedule([(3, RMB()), (4, RGB(0.5)), (None, RGB(0.05))])
    outer = db.Schedule([(9, RMB()), (8, inner), (2, RMB())])
    for _ in range(5):
        inner.choose(None, None)
    for _ in range(11):
        outer.choose(None, None)
    return outer


def used_adapt():
    """Return a bandit that has learned all it could in another history."""
    adapt, arm = db.Adapt([RMB(), RGB(0.05)], head_start=0, alpha=0), db.PlanarArm(2)
    history, rng = db.History(arm.motor_space, arm.sensory_space), np.random.default_rng(0)
    for _ in range(100):
        trial = adapt.propose(history, rng)
        history.append(trial.command, arm(trial.command), path=trial.path)
        adapt.observe(trial, arm(trial.command))
    assert any(adapt.diversities)
    return adapt


def ties():
    """Return goal babbling whose goals are so far away that all effects are equally near."""
    return db.Mixture([RMB(), RGB(0.05, goals=db.Box([1e200, 0], [2e200, 0]))])


@pytest.mark.parametrize(
    "make",
    [shared_schedule, shared_adapt, used_schedules, used_adapt, ties],
    ids=lambda f: f.__name__,
)
def test_parts_that_remember(make):
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


@pytest.mark.parametrize("seed", [0, 2**200, np.int64(7), np.random.SeedSequence(5)])
def test_any_seed(seed):
    runs = [
        db.explore(db.PlanarArm(3), RMB(), 50, rng=seed, engine=engine)
        for engine in ("python", "rust")
    ]
    assert differences(*runs) == []


@pytest.mark.parametrize(
    ("strategy", "change"),
    [
        (RGB(0.05), {"d": 0.5}),
        (RGB(0.05), {"goals": db.Box([0, 0], [1, 0])}),
        (db.Mixture([RMB(), RGB(0.05)]), {"weights": (0.0, 1.0)}),
        (db.Mixture([RMB(), RGB(0.05)]), {"strategies": (RGB(0.5), RMB())}),
        (db.Schedule([(10, RMB()), (None, RGB(0.05))]), {"steps": (3, None)}),
        (db.Adapt([RMB(), RGB(0.05)], tau=0.2), {"alpha": 1.0}),
        (db.Adapt([RMB(), RGB(0.05)], tau=0.2), {"window": 3}),
        (db.Adapt([RMB(), RGB(0.05)], tau=0.2), {"head_start": 0}),
        (db.Adapt([RMB(), RGB(0.05)], tau=0.2), {"tau": 0.3}),
    ],
    ids=str,
)
def test_attributes_count_as_they_are_when_the_exploration_begins(strategy, change):
    arm = db.PlanarArm(5)
    before = db.explore(arm, strategy, 200, rng=0, engine="rust")
    for name, value in change.items():
        setattr(strategy, name, value)
    assert differences(before, db.explore(arm, strategy, 200, rng=0, engine="rust")) != []
    assert_same(arm, strategy, 200, twins(np.random.PCG64))


@pytest.mark.parametrize("engine", ["python", "rust"])
def test_the_arrays_are_the_callers_own(engine):
    adapt = db.Adapt([RMB(), RGB(0.05)])
    run = db.explore(db.PlanarArm(3), adapt, 50, rng=0, engine=engine)
    for array in (run.commands, run.effects, run.paths, run.diversities):
        assert array.flags.writeable
        assert array.flags.c_contiguous
        assert array.flags.aligned
    again = db.explore(db.PlanarArm(3), adapt, 50, rng=0, engine=engine)
    run.effects[:], run.commands[:] = 7, 7
    assert differences(again, db.explore(db.PlanarArm(3), adapt, 50, rng=0, engine="python")) == []
