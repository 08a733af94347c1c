"""A mixture chooses with the probabilities that its weights say, and observes nothing amiss.

Frequencies are tested by a two-sided binomial test at level 1e-4, with fixed seeds.
"""

import numpy as np
import pytest
from scipy import stats

import divbandit as db
from divbandit._core import proportionally
from divbandit.strategies import Starter

LEVEL = 1e-4
SPACE = db.Box([0], [1])


def choices(weights, n=20_000, seed=0):
    mixture = db.Mixture([db.MotorBabbling() for _ in weights], weights=weights)
    history, rng = db.History(SPACE), np.random.default_rng(seed)
    running = Starter(history)(mixture)
    return np.array([running.choose(history, rng) for _ in range(n)])


@pytest.mark.parametrize("seed", [0, 1])
@pytest.mark.parametrize(
    "weights",
    [[1.0], [0.3, 0.7], [3, 7], [1, 1, 1], [0.001, 0.999], [0, 0.5, 0, 0.5], [1e300, 1e300]],
)
def test_frequencies(weights, seed):
    chosen = choices(weights, seed=seed)
    for index, weight in enumerate(weights):
        count = int(np.sum(chosen == index))
        probability = weight / max(weights) / sum(w / max(weights) for w in weights)
        assert stats.binomtest(count, len(chosen), probability).pvalue > LEVEL


@pytest.mark.parametrize("weights", [[0, 1], [1, 0], [0, 1, 0], [0, 0, 1], [5e-324, 0]])
def test_weight_zero_is_never_chosen(weights):
    assert set(choices(weights, n=5000)) == {int(np.argmax(weights))}


def test_weights_are_equal_by_default():
    parts = [db.MotorBabbling(), db.GoalBabbling(), db.GoalBabbling(0.5)]
    assert db.Mixture(parts).weights == (1.0, 1.0, 1.0)


@pytest.mark.parametrize(
    ("weights", "u", "index"),
    [
        ([1, 3], 0.0, 0),
        ([1, 3], 0.2499, 0),
        ([1, 3], 0.25, 1),
        ([0, 1, 3], 0.0, 1),
        ([1, 0, 3], 0.25, 2),
        ([1, 3, 0], 1 - 2**-53, 1),
        ([0.1] * 10 + [0], 1 - 2**-53, 9),
        ([0, 0, 0], 0.0, 0),
        ([0, 0, 0], 0.34, 1),
        ([0, 0, 0], 1 - 2**-53, 2),
    ],
)
def test_choice_of_a_number(weights, u, index):
    assert proportionally(weights, u) == index


def test_nested_frequencies_multiply():
    inner = db.Mixture([db.MotorBabbling(), db.MotorBabbling()], weights=[1, 4])
    mixture = db.Mixture([db.MotorBabbling(), inner], weights=[1, 3])
    run = db.explore(db.PlanarArm(1), mixture, n=5000, rng=0)
    for path, probability in [((0, -1), 0.25), ((1, 0), 0.15), ((1, 1), 0.6)]:
        count = int(np.sum(np.all(run.paths == path, axis=1)))
        assert stats.binomtest(count, len(run), probability).pvalue > LEVEL


def test_a_choice_is_one_draw():
    rng, plain = np.random.default_rng(0), np.random.default_rng(0)
    mixture = db.Mixture([db.MotorBabbling(), db.MotorBabbling()])
    trial = mixture.propose(db.History(SPACE), rng)
    assert trial.path == (int(plain.random() * 2),)
    assert trial.command.tolist() == [plain.random()]
