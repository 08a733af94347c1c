"""Explorations in many threads at once, with either engine: the same bits, and no lost draw."""

from functools import partial

import numpy as np
import pytest

import divbandit as db
from tests.exploration.sameness import differences
from tests.generators import BIT_GENERATORS, state, twins
from tests.threads import at_once

ENGINES = ("auto", "python", "rust")
ARM = db.PlanarArm(20)
RMB, RGB = db.MotorBabbling, db.GoalBabbling
THREADS, EACH, N = 8, 20, 100


def explored(strategy, seeds, engine):
    """Return one exploration after another, of a generator each."""
    return [
        db.explore(ARM, strategy, N, rng=np.random.default_rng(seed), engine=engine)
        for seed in seeds
    ]


def compositions():
    schedule = db.Schedule([(10, RMB()), (None, RGB(0.05))])
    return {
        "adapt": db.Adapt([RMB(), RGB(0.05)], window=10),
        "shared parts": db.Mixture([schedule, db.Adapt([schedule, RMB()], tau=0.1), schedule]),
    }


@pytest.mark.parametrize("engine", ENGINES)
@pytest.mark.parametrize("name", compositions())
def test_one_strategy_and_arm_in_many_threads(name, engine):
    """Each thread explores as if it were alone, though the objects are the same for all."""
    strategy = compositions()[name]
    seeds = [range(EACH * thread, EACH * (thread + 1)) for thread in range(THREADS)]
    found = at_once(partial(explored, strategy, each, engine) for each in seeds)
    for runs, each in zip(found, seeds, strict=True):
        alone = explored(compositions()[name], each, "python")
        assert [differences(*pair) for pair in zip(runs, alone, strict=True)] == [[]] * EACH


@pytest.mark.parametrize("engines", [("python",) * 4, ("rust",) * 4, ("rust", "python") * 2])
@pytest.mark.parametrize("bit_generator", BIT_GENERATORS)
def test_one_generator_for_four_threads(bit_generator, engines):
    """Which thread gets which draw is chance; each draw is made once, by one of them."""
    rng, plain = twins(bit_generator)

    def babbled(engine):
        runs = [db.explore(ARM, RMB(), 3 * N, rng=rng, engine=engine) for _ in range(2 * EACH)]
        return np.concatenate([run.commands for run in runs])

    commands = np.concatenate(at_once(partial(babbled, engine) for engine in engines))
    low, high = -ARM.limit, ARM.limit
    stream = low + (high - low) * plain.random(commands.size)
    assert np.sort(commands, axis=None).tolist() == np.sort(stream).tolist()
    assert state(rng) == state(plain)


@pytest.mark.parametrize("engine", ENGINES)
def test_one_generator_for_bandits(engine):
    """Two draws a choice, as many a command, whoever chooses: the stream's end is known."""
    rng, plain = twins(np.random.PCG64)
    adapt = db.Adapt([RMB(), RMB()], window=10)

    def explored_often():
        return [db.explore(ARM, adapt, N, rng=rng, engine=engine) for _ in range(EACH)]

    for runs in at_once([explored_often] * 4):
        for run in runs:
            assert run.effects.tobytes() == ARM(run.commands).tobytes()
    plain.random(4 * EACH * N * (2 + ARM.joints))
    assert state(rng) == state(plain)


def test_drawing_in_python_while_rust_explores():
    """The caller's own draws and the engine's are from one stream, each made once."""
    rng, plain = twins(np.random.PCG64)
    calls = [
        lambda: [db.explore(ARM, RMB(), N, rng=rng, engine="rust").commands for _ in range(EACH)],
        lambda: [rng.random() for _ in range(20_000)],
    ]
    commands, own = at_once(calls * 2)[:2]
    assert len(commands) == EACH
    assert all(0 <= draw < 1 for draw in own)
    plain.random(2 * (EACH * N * ARM.joints + 20_000))
    assert state(rng) == state(plain)


def test_long_explorations_from_one_generator():
    """Long enough for the engine to look after Python's signals many times on the way."""
    arm, n = db.PlanarArm(1), 500_000
    rng, plain = twins(np.random.PCG64)
    calls = [lambda: db.explore(arm, RMB(), n, rng=rng, engine="rust")] * 2
    *runs, own = at_once([*calls, lambda: [rng.random() for _ in range(1000)]])
    stream = plain.random(2 * n + len(own))
    assert state(rng) == state(plain)
    for run in runs:
        assert run.effects.tobytes() == arm(run.commands).tobytes()
    drawn = np.concatenate([np.concatenate([run.commands for run in runs])[:, 0], angles(arm, own)])
    assert np.sort(drawn).tolist() == np.sort(angles(arm, stream)).tolist()


def angles(arm, draws):
    """Return what motor babbling makes of draws with one joint."""
    return -arm.limit + 2 * arm.limit * np.asarray(draws)
