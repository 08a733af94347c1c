"""Same seed, same bits: run twice, driven from outside, or seeded in another way."""

import numpy as np
import pytest

import divbandit as db
from tests.generators import BIT_GENERATORS, state

ARM = db.PlanarArm(20)
ADAPT = db.Adapt([db.MotorBabbling(), db.GoalBabbling(0.05)], window=10)
N = 300


def bits(run):
    return [array.tobytes() for array in (run.commands, run.effects, run.paths, run.estimates)]


def explored(rng, n=N):
    return bits(db.explore(ARM, ADAPT, n=n, rng=rng))


def test_seeds_differ():
    assert len({explored(seed)[0] for seed in range(20)}) == 20


def test_without_a_seed_runs_differ():
    assert explored(None, n=2) != explored(None, n=2)


@pytest.mark.parametrize("seed", [0, 1, 2**40, 2**200, np.int64(7)])
def test_an_int_a_seed_sequence_and_a_generator_agree(seed):
    expected = explored(seed, n=30)
    assert explored(np.random.SeedSequence(int(seed)), n=30) == expected
    assert explored(np.random.default_rng(int(seed)), n=30) == expected


@pytest.mark.parametrize("bit_generator", BIT_GENERATORS)
def test_a_generator_is_advanced_in_place(bit_generator):
    rng = np.random.Generator(bit_generator(0))
    before = state(rng)
    first = explored(rng, n=50)
    assert state(rng) != before
    assert explored(rng, n=50) != first
    assert explored(np.random.Generator(bit_generator(0)), n=50) == first


def test_a_longer_run_begins_like_a_shorter_one():
    short, long = (db.explore(ARM, ADAPT, n=n, rng=1) for n in (100, 200))
    assert long.commands[:100].tobytes() == short.commands.tobytes()
    assert long.estimates[:100].tobytes() == short.estimates.tobytes()


def test_ask_and_tell_accepts_what_any_lab_sends_back():
    """The effect may come as a list, in another type, or with another layout."""
    plain, varied = (
        db.Explorer(ADAPT, ARM.motor_space, ARM.sensory_space, rng=2) for _ in range(2)
    )
    sent = [
        lambda effect: effect.tolist(),
        tuple,
        lambda effect: np.repeat(effect, 2)[::2],
        lambda effect: effect.astype(">f8"),
        lambda effect: effect.astype(np.longdouble),
        unaligned,
    ]
    for n in range(60):
        trial, other = plain.ask(), varied.ask()
        effect = ARM(trial.command)
        plain.tell(trial, effect)
        varied.tell(other, sent[n % len(sent)](effect))
    assert bits(varied.result()) == bits(plain.result())


def unaligned(values):
    """Return the same numbers at an odd address."""
    memory = np.frombuffer(b"\0" + values.tobytes(), dtype=np.uint8)[1:]
    return memory.view(np.float64)


def test_a_result_half_way_does_not_disturb():
    explorer = db.Explorer(ADAPT, ARM.motor_space, ARM.sensory_space, rng=2)
    for n in range(N):
        trial = explorer.ask()
        explorer.tell(trial, ARM(trial.command))
        if n % 50 == 0:
            half_way = explorer.result()
            half_way.effects[:] = 0
            half_way.commands[:] = 0
    assert bits(explorer.result()) == explored(2)
    assert len(half_way) == 251
