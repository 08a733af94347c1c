"""The oracles themselves: known areas, and two that share no idea agree with each other."""

import math

import pytest

from tests.reference.families import FAMILIES, family
from tests.reference.many_digits import exact_area
from tests.reference.sections import section_area
from tests.reference.union_area import union_area

LENS = 2 * math.pi / 3 - math.sqrt(3) / 2  # common to two unit discs one radius apart


@pytest.mark.parametrize("area", [union_area, section_area, exact_area])
def test_areas_known_on_paper(area):
    assert area([], 1.0) == 0
    assert area([(3, 4)], 2.0) == pytest.approx(4 * math.pi, rel=1e-15)
    assert area([(0, 0), (2, 0)], 1.0) == pytest.approx(2 * math.pi, rel=1e-15)
    assert area([(0, 0), (0.6, 0.8)], 1.0) == pytest.approx(2 * math.pi - LENS, rel=1e-15)
    assert area([(0, 0), (0, 0), (0, 0)], 1.0) == pytest.approx(math.pi, rel=1e-15)


@pytest.mark.parametrize("area", [union_area, section_area, exact_area])
def test_a_ring_around_a_hole(area):
    """Six unit discs around a hexagon of side 1.8: neighbours overlap, the middle is free."""
    side = 1.8
    ring = [(side * math.cos(k * math.pi / 3), side * math.sin(k * math.pi / 3)) for k in range(6)]
    lens = 2 * math.acos(side / 2) - side / 2 * math.sqrt(4 - side**2)
    assert area(ring, 1.0) == pytest.approx(6 * math.pi - 6 * lens, rel=1e-14)


@pytest.mark.parametrize("tau", [0.05, 0.3, 1.0])
@pytest.mark.parametrize("name", FAMILIES)
def test_both_agree(name, tau):
    points = family(name, 60, 2)
    assert union_area(points, tau) == pytest.approx(section_area(points, tau), rel=1e-13)


@pytest.mark.parametrize("name", FAMILIES)
def test_fifty_digits_agree(name):
    points = family(name, 15, 2)
    assert union_area(points, 0.3) == pytest.approx(exact_area(points, 0.3), rel=1e-13)
