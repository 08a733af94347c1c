"""Adapt where effects are not in the plane: its measure has their dimension, or says so."""

import math

import numpy as np
import pytest

import divbandit as db
from divbandit.bandits import Gain
from divbandit.measures import BallCoverage, Entropy, GridCoverage
from tests.bandits.script import both_engines
from tests.reference.adapt_replay import beliefs

RMB = db.MotorBabbling


def cube(dim, *, known):
    space = db.Box([0] * dim, [1] * dim)
    return db.FunctionEnvironment(lambda x: x, space, space if known else None)


@both_engines
@pytest.mark.parametrize("known", [True, False], ids=["known", "unknown"])
@pytest.mark.parametrize("dim", [1, 3, 5])
def test_effects_of_any_dimension(dim, known, engine):
    grid = GridCoverage(0.25)
    adapt = db.Adapt([RMB(), RMB()], reward=Gain(grid))
    run = db.explore(cube(dim, known=known), adapt, n=60, rng=0, engine=engine)
    assert np.array_equal(run.estimates, beliefs(adapt, run, grid.start(dim)))


@both_engines
@pytest.mark.parametrize("known", [True, False], ids=["known", "unknown"])
def test_a_measure_says_which_dimensions_it_takes(known, engine):
    adapt = db.Adapt([RMB()], reward=Gain(Entropy([0.25, 0.5])))
    with pytest.raises(ValueError, match=r"of a dimension that Adapt takes, got 3: .*cell"):
        db.explore(cube(3, known=known), adapt, n=1, rng=0, engine=engine)


@both_engines
@pytest.mark.parametrize("dim", [1, 2, 3, 4, 9])
def test_the_default_measures_in_whatever_dimension_coverage_takes(dim, engine):
    adapt = db.Adapt([RMB(), RMB()], tau=0.3, window=5)
    run = db.explore(cube(dim, known=True), adapt, n=60, rng=0, engine=engine)
    expected = beliefs(adapt, run, BallCoverage(0.3).start(dim))
    np.testing.assert_allclose(run.estimates, expected, rtol=1e-14)
    # Until the first effect tells the dimension, a disc stands for a ball.
    other = db.explore(cube(dim, known=False), adapt, n=60, rng=0, engine=engine)
    assert other.commands.tobytes() == run.commands.tobytes()
    assert other.estimates[0].tolist() == [math.pi * 0.3 * 0.3] * 2
    assert other.estimates[1:].tobytes() == run.estimates[1:].tobytes()


@both_engines
@pytest.mark.parametrize("known", [True, False], ids=["known", "unknown"])
def test_the_default_says_which_dimensions_it_takes(known, engine):
    message = "effects must be of a dimension that Adapt takes, got 40: dim must be from 1 to 32"
    with pytest.raises(ValueError, match=message):
        db.explore(cube(40, known=known), db.Adapt([RMB()]), n=1, rng=0, engine=engine)
