"""Adapt where effects are not in the plane: its measure has their dimension, or says so."""

import math

import numpy as np
import pytest

import divbandit as db
from tests.bandits.beliefs import replay

RMB = db.MotorBabbling


def cube(dim, *, known):
    space = db.Box([0] * dim, [1] * dim)
    return db.FunctionEnvironment(lambda x: x, space, space if known else None)


@pytest.mark.parametrize("known", [True, False], ids=["known", "unknown"])
@pytest.mark.parametrize("dim", [1, 3, 5])
def test_effects_of_any_dimension(dim, known):
    adapt = db.Adapt([RMB(), RMB()], measure=db.GridCoverage(0.25, dim=dim))
    run = db.explore(cube(dim, known=known), adapt, n=60, rng=0)
    assert np.array_equal(run.diversities, replay(adapt, run, 1.0, db.GridCoverage(0.25, dim=dim)))


@pytest.mark.parametrize("known", [True, False], ids=["known", "unknown"])
def test_the_dimension_is_that_of_the_measure(known):
    adapt = db.Adapt([RMB()], measure=db.Entropy(0.25))
    with pytest.raises(ValueError, match="measure must have the dimension of the effects, 3, got"):
        db.explore(cube(3, known=known), adapt, n=1, rng=0)


@pytest.mark.parametrize("dim", [1, 2, 3, 4, 9])
def test_the_default_measures_in_whatever_dimension_coverage_takes(dim):
    ball = db.Coverage(0.3, dim=dim).add([0.0] * dim)
    adapt = db.Adapt([RMB(), RMB()], tau=0.3, window=5)
    run = db.explore(cube(dim, known=True), adapt, n=60, rng=0)
    expected = replay(adapt, run, ball, db.Coverage(0.3, dim=dim, rng=0))
    np.testing.assert_allclose(run.diversities, expected, rtol=1e-14)
    # Until the first effect tells the dimension, a disc stands for a ball.
    other = db.explore(cube(dim, known=False), adapt, n=60, rng=0)
    assert other.commands.tobytes() == run.commands.tobytes()
    assert other.diversities[0].tolist() == [math.pi * 0.3 * 0.3] * 2
    assert other.diversities[1:].tobytes() == run.diversities[1:].tobytes()


@pytest.mark.parametrize("known", [True, False], ids=["known", "unknown"])
def test_the_default_says_which_dimensions_it_takes(known):
    message = "effects must be of a dimension that Adapt takes, got 40: dim must be from 1 to 32"
    with pytest.raises(ValueError, match=message):
        db.explore(cube(40, known=known), db.Adapt([RMB()]), n=1, rng=0)
