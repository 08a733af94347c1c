"""Quasi-random babbling: SciPy's sequence, one point after the other, whatever block it is in."""

import inspect

import numpy as np
import pytest
from scipy import stats
from scipy.stats import qmc

import divbandit as db
from divbandit.adapters import QuasiRandomBabbling
from divbandit.strategies.base import Starter

LEVEL = 1e-4
SPACE = db.Box([-1, 5, 2], [1, 5, 12])


def proposed(n, seed=0, space=SPACE):
    history, rng = db.History(space), np.random.default_rng(seed)
    running = Starter(history)(QuasiRandomBabbling())
    return np.array([running.propose(history, rng).command for _ in range(n)])


def test_one_draw_seeds_the_whole_sequence():
    rng, plain = np.random.default_rng(0), np.random.default_rng(0)
    history = db.History(SPACE)
    running = Starter(history)(QuasiRandomBabbling())
    commands = [running.propose(history, rng).command.tolist() for _ in range(300)]
    plain.random()
    assert rng.random() == plain.random()
    assert commands == proposed(300).tolist() != proposed(300, seed=1).tolist()


def test_every_coordinate_is_uniform():
    commands = np.array([proposed(1, seed)[0] for seed in range(2000)])
    for j in (0, 2):
        whole = stats.uniform(SPACE.low[j], SPACE.high[j] - SPACE.low[j])
        assert stats.kstest(commands[:, j], whole.cdf).pvalue > LEVEL
    assert set(commands[:, 1]) == {5.0}


@pytest.mark.parametrize("m", [1, 2, 5])
def test_points_are_spread_more_evenly_than_random_ones(m):
    space = db.Box([0] * m, [1] * m)
    evenly = qmc.discrepancy(proposed(512, space=space))
    assert evenly < 0.9 * qmc.discrepancy(np.random.default_rng(0).random((512, m)))


def test_each_of_512_intervals_has_one_of_512_points():
    """Also across blocks, and from the first point on."""
    commands = proposed(512, space=db.Box([0, 0], [1, 1]))
    for j in range(2):
        assert sorted((512 * commands[:, j]).astype(int).tolist()) == list(range(512))


def test_it_is_scipys_sequence():
    """Across blocks as well."""
    seed = int(np.random.default_rng(0).random() * 2**53)
    rng = np.random.Generator(np.random.PCG64(seed))
    name = "rng" if "rng" in inspect.signature(qmc.Sobol).parameters else "seed"
    points = qmc.Sobol(3, scramble=True, bits=53, **{name: rng}).random(1024)[:700]
    np.testing.assert_allclose(
        proposed(700), SPACE.low + points * (SPACE.high - SPACE.low), rtol=1e-15
    )


def test_too_many_coordinates_are_refused_before_the_first_step():
    space = db.Box([0] * 21202, [1] * 21202)
    with pytest.raises(ValueError, match="motor_space must have at most 21201 coordinates"):
        db.Explorer(QuasiRandomBabbling(), space)
