"""One stream of randomness: a draw made in Rust is the caller's own `rng.random()`."""

import threading

import numpy as np
import pytest

import divbandit as db
from divbandit.inverse import Nearest
from tests.generators import BIT_GENERATORS, state, twins

LOW, HIGH = np.array([-1.0, 0.0, 5.0]), np.array([1.0, 0.25, 5.0])


def uniform(low, high, rng):
    """Return what a draw must be, one `rng.random()` a coordinate."""
    return np.array([a + (b - a) * rng.random() for a, b in zip(low, high, strict=True)])


def near(parent, d, rng):
    reach = d * (HIGH - LOW)
    return uniform(np.maximum(LOW, parent - reach), np.minimum(HIGH, parent + reach), rng)


def is_free(lock):
    """Say whether another thread could take the lock."""
    taken = []

    def take():
        taken.append(lock.acquire(blocking=False))
        if taken[0]:
            lock.release()

    thread = threading.Thread(target=take)
    thread.start()
    thread.join()
    return taken[0]


def observed_history():
    history = db.History(db.Box(LOW, HIGH), db.Box([0], [1]))
    history.append([-0.95, 0.1, 5.0], [0.2])
    history.append([0.5, 0.25, 5.0], [0.7])
    return history


@pytest.mark.parametrize("bit_generator", BIT_GENERATORS)
def test_draws_are_the_generators_own_and_leave_its_state(bit_generator):
    rng, plain = twins(bit_generator)
    box, history, model = db.Box(LOW, HIGH), observed_history(), Nearest(0.1)
    for _ in range(300):
        assert box.sample(rng).tolist() == uniform(LOW, HIGH, plain).tolist()
        assert rng.random() == plain.random()
        command = model.command([0.6], history, rng)
        assert command.tolist() == near(history.commands[1], 0.1, plain).tolist()
        assert rng.integers(1000) == plain.integers(1000)
        assert rng.normal() == plain.normal()
        parent = box.sample(rng)
        assert parent.tolist() == uniform(LOW, HIGH, plain).tolist()
        perturbed = box.bounds.perturb(parent, 0.3, rng)
        assert perturbed.tolist() == near(parent, 0.3, plain).tolist()
    assert state(rng) == state(plain)


@pytest.mark.parametrize("bit_generator", BIT_GENERATORS)
def test_the_lock_is_free_afterwards(bit_generator):
    rng, _ = twins(bit_generator)
    lock, history = rng.bit_generator.lock, observed_history()
    db.Box(LOW, HIGH).sample(rng)
    assert is_free(lock)
    Nearest(0.1).command([0.6], history, rng)
    assert is_free(lock)


@pytest.mark.parametrize("bit_generator", BIT_GENERATORS)
@pytest.mark.parametrize(
    "fail",
    [
        lambda history, rng: Nearest().command([0.5, 0.5], history, rng),
        lambda history, rng: Nearest().command([np.nan], history, rng),
        lambda history, rng: history.motor_space.bounds.perturb([9, 9, 9], 0.1, rng),
        lambda history, rng: history.motor_space.bounds.perturb([0, 0, 5], -1, rng),
    ],
    ids=["goal's shape", "goal's value", "parent outside", "d below 0"],
)
def test_an_error_draws_nothing_and_frees_the_lock(fail, bit_generator):
    rng, plain = twins(bit_generator)
    with pytest.raises(ValueError, match="must"):
        fail(observed_history(), rng)
    assert state(rng) == state(plain)
    assert is_free(rng.bit_generator.lock)
