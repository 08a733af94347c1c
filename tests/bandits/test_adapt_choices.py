"""Adapt's choices: uniform with probability alpha, else in proportion to the diversities.

Frequencies are tested by chi-square at level 1e-4, with fixed seeds.
"""

import numpy as np
import pytest
from scipy import stats

from tests.bandits.script import Drive, both_engines

LEVEL = 1e-4
N = 20_000


def prepared(engine, alpha):
    """Return a Drive whose first strategy has a quarter, the second three quarters of a ball."""
    run = Drive(engine, 2, tau=0.5, window=4, alpha=alpha)
    for new in (True, False, False, False):
        run.step(0, new=new)
    for new in (True, False, True, True):
        run.step(1, new=new)
    return run


def counts(run):
    run.explorer.rng = np.random.default_rng(0)
    chosen = [run.explorer.ask().path[0] for _ in range(N)]
    return np.bincount(chosen, minlength=len(run.estimates))


def fits(observed, probabilities):
    return stats.chisquare(observed, N * np.array(probabilities)).pvalue > LEVEL


@both_engines
@pytest.mark.parametrize("alpha", [0.0, 0.1, 0.5, 1.0])
def test_frequencies(engine, alpha):
    run = prepared(engine, alpha)
    assert run.estimates[1] == pytest.approx(3 * run.estimates[0], rel=1e-15)
    assert fits(counts(run), alpha * np.array([0.5, 0.5]) + (1 - alpha) * np.array([0.25, 0.75]))


@both_engines
def test_diversity_zero_is_never_chosen_with_alpha_zero(engine):
    run = Drive(engine, 3, tau=0.5, window=5, alpha=0.0, head_start=0)
    assert fits(counts(run), [1 / 3] * 3)  # until one gains
    run.step(1, new=True)
    assert counts(run).tolist() == [0, N, 0]


@both_engines
@pytest.mark.parametrize("alpha", [0.0, 0.1])
def test_all_diversities_zero_is_uniform(engine, alpha):
    run = Drive(engine, 4, tau=0.5, window=1, alpha=alpha)
    for index in (0, 0, 1, 2, 3):
        run.step(index, new=False)
    assert run.estimates == (0, 0, 0, 0)
    assert fits(counts(run), [1 / 4] * 4)


@both_engines
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
def test_a_choice_is_two_draws(engine, numbers, index):
    run = prepared(engine, 0.1)
    assert run.choice(*numbers) == index
