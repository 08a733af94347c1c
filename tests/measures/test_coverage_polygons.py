"""The coverage is what unions of finer and finer polygons tend to."""

from itertools import pairwise

import pytest
import shapely

import divbandit as db

SIDES = (16, 32, 64, 128)  # a quarter circle's


def polygon_area(effects, tau, sides):
    discs = shapely.buffer(shapely.points(effects), tau, quad_segs=sides)
    return shapely.union_all(discs).area


@pytest.mark.parametrize(
    ("strategy", "tau"),
    [(db.MotorBabbling(), 0.05), (db.GoalBabbling(0.05), 0.1), (db.GoalBabbling(0.001), 0.02)],
    ids=repr,
)
def test_inscribed_polygons_approach_it_quadratically(strategy, tau):
    effects = db.explore(db.PlanarArm(20), strategy, n=200, rng=0).effects
    exact = db.coverage(effects, tau)
    errors = [exact - polygon_area(effects, tau, sides) for sides in SIDES]
    assert errors[-1] > 0
    assert errors[-1] < 1e-4 * exact
    for coarse, fine in pairwise(errors):
        assert coarse / fine == pytest.approx(4, rel=0.2)
