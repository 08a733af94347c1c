"""An exploration's diversity after each step, by any measure."""

import numpy as np
import pytest

import divbandit as db
from divbandit.measures import BallCoverage, Entropy, GridCoverage, Sparseness

ARM = db.PlanarArm(5)
RUN = db.explore(ARM, db.MotorBabbling(), n=200, rng=0)
MEASURES = [BallCoverage(0.1), GridCoverage(0.1), Sparseness(3), Entropy(0.1)]


def babbled(dim):
    space = db.Box([0] * dim, [1] * dim)
    environment = db.FunctionEnvironment(lambda x: x, space, space)
    return db.explore(environment, db.MotorBabbling(), n=30, rng=0)


@pytest.mark.parametrize("measure", MEASURES)
def test_is_the_measure_after_each_step(measure):
    diversity, step = RUN.diversity(measure), measure.start(2)
    assert (diversity.shape, diversity.dtype) == ((200,), np.float64)
    for effect, total in zip(RUN.effects, diversity, strict=True):
        step.add(effect)
        assert total == pytest.approx(step.measure, rel=1e-13)


@pytest.mark.parametrize("tau", [0.02, 0.3])
def test_coverage_is_its_short_form(tau):
    expected = np.cumsum(db.Coverage(tau).extend(RUN.effects))
    assert RUN.coverage(tau).tobytes() == expected.tobytes()
    assert RUN.diversity(BallCoverage(tau)).tobytes() == expected.tobytes()


@pytest.mark.parametrize("dim", [1, 2, 3, 4, 9])
def test_coverage_takes_the_dimension_of_the_effects(dim):
    run = babbled(dim)
    expected = np.cumsum(db.Coverage(0.2, dim=dim, rng=0).extend(run.effects))
    assert run.coverage(0.2).tobytes() == expected.tobytes()


@pytest.mark.parametrize("dim", [1, 3, 6])
def test_other_measures_take_any_dimension(dim):
    run = babbled(dim)
    cells = {tuple(row) for row in np.floor(run.effects / 0.5).tolist()}
    assert run.diversity(GridCoverage(0.5))[-1] == len(cells)


def test_the_dimension_must_be_that_of_the_effects():
    with pytest.raises(ValueError, match=r"cell must .*"):
        RUN.diversity(GridCoverage([0.5, 0.5, 0.5]))


@pytest.mark.parametrize("sensory_space", [None, ARM.sensory_space])
def test_of_nothing_there_is_none(sensory_space):
    run = db.Explorer(db.MotorBabbling(), ARM.motor_space, sensory_space).result()
    assert run.diversity(GridCoverage(0.5)).shape == (0,)
    assert run.coverage(0.5).shape == (0,)
