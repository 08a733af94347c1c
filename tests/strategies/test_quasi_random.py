"""Quasi-random babbling: SciPy's sequence, one point after the other, whatever block it is in."""

import copy
import subprocess
import sys

import numpy as np
import pytest
from scipy import stats
from scipy.stats import qmc

import divbandit as db

LEVEL = 1e-4
SPACE = db.Box([-1, 5, 2], [1, 5, 12])


def proposed(n, seed=0, space=SPACE):
    history, rng = db.History(space), np.random.default_rng(seed)
    strategy = db.QuasiRandomBabbling()
    return np.array([strategy.propose(history, rng).command for _ in range(n)])


def test_one_draw_seeds_the_whole_sequence():
    rng, plain = np.random.default_rng(0), np.random.default_rng(0)
    trials = db.QuasiRandomBabbling().propose_many(db.History(SPACE), 300, rng)
    assert plain.random() != rng.random()
    assert plain.random() != 0
    rng, plain = np.random.default_rng(0), np.random.default_rng(0)
    again = db.QuasiRandomBabbling().propose_many(db.History(SPACE), 300, rng)
    assert [t.command.tolist() for t in again] == [t.command.tolist() for t in trials]
    plain.random()
    assert rng.random() == plain.random()


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


@pytest.mark.parametrize("n", [1, 100, 255, 256, 257, 700])
def test_a_copy_goes_on_anywhere_in_a_block(n):
    history, rng = db.History(SPACE), np.random.default_rng(0)
    strategy = db.QuasiRandomBabbling()
    strategy.propose_many(history, n, rng)
    other = copy.deepcopy(strategy)
    expected = [t.command.tolist() for t in strategy.propose_many(history, 300, rng)]
    assert [t.command.tolist() for t in other.propose_many(history, 300, rng)] == expected


def test_another_motor_space_begins_a_sequence_of_its_own():
    strategy, rng = db.QuasiRandomBabbling(), np.random.default_rng(0)
    for m in (2, 3, 2):
        history = db.History(db.Box([0] * m, [1] * m))
        assert strategy.propose(history, rng).command.shape == (m,)


def test_too_many_coordinates_are_refused_before_the_first_step():
    space = db.Box([0] * 21202, [1] * 21202)
    with pytest.raises(ValueError, match="motor_space must have at most 21201 coordinates"):
        db.Explorer(db.QuasiRandomBabbling(), space)


WITHOUT = """
import sys
sys.modules["scipy"] = sys.modules["scipy.stats"] = None
import divbandit as db
strategy = db.QuasiRandomBabbling()
try:
    db.explore(db.PlanarArm(2), strategy, 1)
except ImportError as error:
    print(error)
"""


def test_without_scipy_it_says_what_to_install():
    command = [sys.executable, "-c", WITHOUT]
    done = subprocess.run(command, capture_output=True, text=True, check=True)  # noqa: S603
    assert done.stdout == "QuasiRandomBabbling needs SciPy: pip install 'divbandit[qmc]'\n"


def test_scipy_is_loaded_only_when_it_is_used():
    script = "import sys, divbandit; divbandit.QuasiRandomBabbling(); print('scipy' in sys.modules)"
    command = [sys.executable, "-c", script]
    done = subprocess.run(command, capture_output=True, text=True, check=True)  # noqa: S603
    assert done.stdout == "False\n"
