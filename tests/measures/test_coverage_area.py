"""The coverage of few effects: known areas, both oracles, and where discs barely touch."""

import math
from itertools import pairwise

import numpy as np
import pytest
import shapely

import divbandit as db
from tests.reference.families import FAMILIES, family
from tests.reference.sections import section_area
from tests.reference.union_area import union_area

BALL = math.pi


def lens(distance):
    """Return the area common to two unit discs, for 0 < distance < 2."""
    return 2 * math.acos(distance / 2) - distance / 2 * math.sqrt(4 - distance**2)


def test_no_effect_covers_nothing():
    assert db.coverage(np.empty((0, 2)), 1.0) == 0
    assert db.Coverage(1.0).measure == 0


@pytest.mark.parametrize("distance", [1e-12, 1e-3, 0.5, 1.0, 1.5, 1.999, 2 - 1e-9])
def test_second_disc_gains_all_but_the_lens(distance):
    cov = db.Coverage(1.0)
    assert cov.add([0.0, 0.0]) == BALL
    assert cov.add([distance, 0.0]) == pytest.approx(BALL - lens(distance), abs=1e-14)


def test_enclosed_effect_gains_nothing_and_a_hole_is_filled_exactly():
    ring = [(1.5 * math.cos(k * math.pi / 3), 1.5 * math.sin(k * math.pi / 3)) for k in range(6)]
    cov = db.Coverage(1.0)
    cov.extend(ring)
    hole = section_area([*ring, (0, 0)], 1.0) - section_area(ring, 1.0)
    assert cov.add([0, 0]) == pytest.approx(hole, abs=1e-13)
    assert cov.add([0.01, 0.02]) == pytest.approx(0, abs=1e-15)


@pytest.mark.parametrize("tau", [0.01, 0.1, 0.5, 1.0])
@pytest.mark.parametrize("name", FAMILIES)
@pytest.mark.parametrize("area", [union_area, section_area])
def test_families_agree_with_the_oracles(area, name, tau):
    points = family(name, 50, 2, seed=3)
    assert db.coverage(points, tau) == pytest.approx(area(points, tau), rel=1e-12)


@pytest.mark.parametrize("tau", [0.25, 0.5, math.sqrt(0.5)])
def test_a_lattice_where_circles_touch_and_cross_in_common_points(tau):
    lattice = [(x, y) for x in range(6) for y in range(6)]
    shuffled = np.random.default_rng(0).permutation(lattice)
    assert db.coverage(shuffled, tau) == pytest.approx(section_area(lattice, tau), rel=1e-13)


def test_a_straight_row_of_circles_on_a_line_of_touching_points():
    row = [(2.0 * k, 0.0) for k in range(50)]
    assert db.coverage(row, 1.0) == pytest.approx(50 * BALL, rel=1e-14)


@pytest.mark.parametrize("tau", [1e-100, 1e-30, 1e-3, 1e30, 1e100])
def test_area_scales_with_the_square_of_the_radius(tau):
    points = family("uniform", 30, 2, seed=1)
    expected = db.coverage(3 * points, 1.0) * tau**2
    assert db.coverage(3 * points * tau, tau) == pytest.approx(expected, rel=1e-11)


def test_effects_beyond_all_integers():
    far = [(1e300, -1e300), (-1e300, 1e300), (0, 0), (1e300, -1e300)]
    assert db.Coverage(1.0).extend(far).tolist() == [BALL, BALL, BALL, 0]


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
