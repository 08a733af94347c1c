"""Adapt's choices: uniform with probability alpha, else in proportion to the diversities.

Frequencies are tested by chi-square at level 1e-4, with fixed seeds.
"""

import numpy as np
import pytest
from scipy import stats

import divbandit as db
from tests.bandits.script import Drive

LEVEL = 1e-4
N = 20_000


def prepared(alpha, *, count=2, **parameters):
    """Return a Drive whose first strategy has a quarter, the second three quarters of a ball."""
    run = Drive(count, tau=0.5, window=4, alpha=1.0, **parameters)
    for new in (True, False, False, False):
        run.step(0, new=new)
    for new in (True, False, True, True):
        run.step(1, new=new)
    run.adapt.alpha = alpha
    return run


def counts(run, seed=0):
    rng = np.random.default_rng(seed)
    chosen = [run.adapt.choose(run.history, rng) for _ in range(N)]
    return np.bincount(chosen, minlength=len(run.adapt.strategies))


def fits(observed, probabilities):
    return stats.chisquare(observed, N * np.array(probabilities)).pvalue > LEVEL


@pytest.mark.parametrize("seed", [0, 1])
@pytest.mark.parametrize("alpha", [0.0, 0.1, 0.5, 1.0])
def test_frequencies(alpha, seed):
    run = prepared(alpha)
    assert run.adapt.diversities[1] == pytest.approx(3 * run.adapt.diversities[0], rel=1e-15)
    expected = alpha * np.array([0.5, 0.5]) + (1 - alpha) * np.array([0.25, 0.75])
    assert fits(counts(run, seed), expected)


def test_alpha_one_is_uniform_whatever_the_diversities():
    run = prepared(1.0, count=3)
    for _ in range(4):
        run.step(2, new=False)
    assert run.adapt.diversities[2] == 0
    assert fits(counts(run), [1 / 3] * 3)


def test_diversity_zero_is_never_chosen_with_alpha_zero():
    run = Drive(3, tau=0.5, window=2, alpha=1.0)
    for index in (0, 2):
        for _ in range(3):
            run.step(index, new=False)
    run.adapt.alpha = 0.0
    assert counts(run).tolist() == [0, N, 0]


@pytest.mark.parametrize("alpha", [0.0, 0.1])
def test_all_diversities_zero_is_uniform(alpha):
    run = Drive(4, tau=0.5, window=1, alpha=1.0)
    for index in (0, 0, 1, 2, 3):
        run.step(index, new=False)
    assert run.adapt.diversities == (0, 0, 0, 0)
    run.adapt.alpha = alpha
    assert fits(counts(run), [1 / 4] * 4)


def test_no_head_start_is_uniform_until_one_gains():
    run = Drive(3, tau=0.5, window=5, alpha=1.0, head_start=0)
    run.adapt.alpha = 0.0
    assert fits(counts(run), [1 / 3] * 3)
    run.adapt.alpha = 1.0
    run.step(1, new=True)
    run.adapt.alpha = 0.0
    assert counts(run).tolist() == [0, N, 0]


@pytest.mark.parametrize(
    ("numbers", "index"),
    [
        ((0.0999, 0.49), 0),  # below alpha: uniform
        ((0.0999, 0.5), 1),
        ((0.1, 0.2499), 0),  # not below alpha: a quarter to three quarters
        ((0.1, 0.2501), 1),
        ((0.9, 0.0), 0),
        ((0.9, 1 - 2**-53), 1),
    ],
)
def test_a_choice_is_two_draws(numbers, index):
    run = prepared(0.1)
    assert run.choice(*numbers) == index  # one number more or fewer would be an error


def test_a_choice_advances_the_stream_by_two():
    rng, plain = np.random.default_rng(0), np.random.default_rng(0)
    for alpha in (0.0, 1.0):
        prepared(alpha).choice(rng.random(), rng.random())
        plain.random(2)
    adapt, history = db.Adapt([db.MotorBabbling()]), db.History(db.Box([0], [1]))
    adapt.choose(history, rng)
    assert rng.random() == plain.random(3)[2]
