"""Loops and polygons, from boundaries that are found by hand or from the discs' angles."""

import builtins
import copy
import math
import pickle
from math import pi, sqrt

import numpy as np
import pytest
import shapely

import divbandit as db
from divbandit.measures.boundary import Loop, to_shapely

LENS = 2 * pi / 3 - sqrt(3) / 2  # of two unit discs, one apart


def circle(x, y, tau=1.0):
    return Loop([[x, y, 0, 2 * pi]], tau)


def two_discs(tau=1.0, x=0.0, y=0.0):
    return Loop([[x, y, pi / 3, 5 * pi / 3], [x + tau, y, 4 * pi / 3, 8 * pi / 3]], tau)


def ring(n, radius, tau=1.0, x=0.0, y=0.0):
    """Outer loop and hole of n discs around (x, y); the latter clockwise, from disc to disc."""
    apart = 2 * radius * math.sin(pi / n)
    # As seen from a disc: how far from its neighbour's direction they cross, and that direction.
    crossing = math.acos(apart / 2 / tau)
    outer, hole = [], []
    for i in range(n):
        around = 2 * pi * i / n
        after, before = around + pi / 2 + pi / n, around - pi / 2 - pi / n
        centre = [x + radius * math.cos(around), y + radius * math.sin(around)]
        outer.append([*centre, before + crossing, after - crossing])
        hole.append([*centre, after + crossing, before + 2 * pi - crossing])
    return Loop(outer, tau), Loop(hole[::-1], tau)


def discs(loops):
    centres = np.concatenate([loop.arcs[:, :2] for loop in loops])
    return centres, loops[0].tau


def test_one_disc():
    loop = circle(3, -2, tau=0.5)
    assert loop.area == pytest.approx(pi / 4, rel=1e-15)
    assert loop.perimeter == pytest.approx(pi, rel=1e-15)
    assert (len(loop), loop.tau, loop.is_hole) == (1, 0.5, False)
    assert len(loop.vertices()) == 64


@pytest.mark.parametrize(("tau", "x", "y"), [(1, 0, 0), (0.02, 0.3, -0.7), (700, 1e6, 1e6)])
def test_two_discs(tau, x, y):
    loop = two_discs(tau, x, y)
    assert loop.area == pytest.approx((2 * pi - LENS) * tau**2, rel=1e-12)
    assert loop.perimeter == pytest.approx(8 * pi / 3 * tau, rel=1e-14)
    assert not loop.is_hole


@pytest.mark.parametrize("n", [6, 7, 12, 40])
@pytest.mark.parametrize("scale", [1.0, 1e-3, 1e50])
def test_rings(n, scale):
    radius = 0.8 / math.sin(pi / n) * scale
    outer, hole = ring(n, radius, scale)
    assert (outer.is_hole, hole.is_hole) == (False, True)
    area = db.coverage(discs([outer])[0], scale)
    assert outer.area + hole.area == pytest.approx(area, rel=1e-13)
    assert hole.area < 0 < outer.area


def test_the_tiniest_holes_keep_their_sign():
    for size in (1e-3, 1e-6, 1e-9):
        hole = ring(3, 1 + size)[1]
        assert hole.is_hole
        # A triangle but for its bulges: arcs meet the axes at the distance `size`.
        assert hole.area == pytest.approx(-3 * sqrt(3) * size**2, rel=3 * size + 1e-6)


def test_vertices_hold_every_start_as_it_is_and_lie_on_the_circles():
    for loop in (two_discs(), *ring(7, 1.8), circle(0, 0)):
        x, y, start, _ = loop.arcs.T
        starts = {*zip(x + np.cos(start), y + np.sin(start), strict=True)}
        for quad_segs in (1, 2, 16, 1000):
            corners = loop.vertices(quad_segs)
            assert starts <= {*map(tuple, corners)}
            assert (corners[0] == [x[0] + np.cos(start[0]), y[0] + np.sin(start[0])]).all()
            edges = np.roll(corners, -1, axis=0) - corners
            length = np.hypot(*edges.T)
            assert length.max() <= 2 * math.sin(pi / 4 / quad_segs) + 1e-12
            assert length.min() > 0
            distance = np.hypot(*(corners[:, None] - loop.arcs[:, :2]).T)
            assert abs(distance - 1).min(axis=0).max() < 1e-14


def test_polygons_tend_to_the_loop():
    for loop in (two_discs(), *ring(7, 1.8)):

        def area(quad_segs, loop=loop):
            x, y = loop.vertices(quad_segs).T
            return 0.5 * np.sum(x * np.roll(y, -1) - y * np.roll(x, -1))

        errors = [loop.area - area(quad_segs) for quad_segs in (64, 128)]
        # Inside of the union, for holes, too: the signed area is too small in either case.
        assert errors[1] > 0
        assert errors[0] / errors[1] == pytest.approx(4, rel=0.1)


def test_to_shapely_of_simple_boundaries():
    assert to_shapely([]).is_empty
    assert to_shapely([circle(0, 0)]).geom_type == "Polygon"
    assert to_shapely(iter([circle(0, 0), circle(3, 0)])).geom_type == "MultiPolygon"
    assert to_shapely([circle(0, 0)], quad_segs=1).area == pytest.approx(2)


def test_to_shapely_gives_holes_to_the_loops_around_them():
    """A ring around a ring around a disc, beside a ring, whatever the order."""
    wide, narrow, beside = ring(20, 5.0), ring(8, 2.0), ring(9, 2.2, x=20.0)
    loops = [*wide, *narrow, *beside, circle(0.0, 0.0, 0.25)]
    for seed in range(10):
        np.random.default_rng(seed).shuffle(loops)
        union = to_shapely(loops, quad_segs=32)
        assert union.is_valid
        found = sorted(union.geoms, key=lambda polygon: polygon.area)
        expected = sorted(outer.area + hole.area for outer, hole in (wide, narrow, beside))
        assert [len(polygon.interiors) for polygon in found] == [0, 1, 1, 1]
        assert [p.area for p in found] == pytest.approx([pi / 16, *expected], rel=2e-3)


@pytest.mark.parametrize("loops", [[two_discs()], [*ring(7, 1.8)], [*ring(30, 8.0, 1.0)]])
def test_to_shapely_equals_the_union_of_polygons(loops):
    centres, tau = discs(loops)
    union = shapely.union_all(shapely.buffer(shapely.points(centres), tau, quad_segs=100))
    found = to_shapely(loops, quad_segs=100)
    assert found.is_valid
    assert found.symmetric_difference(union).area < 1e-3 * union.area
    assert found.boundary.hausdorff_distance(union.boundary) < 1e-3


def test_loops_are_frozen_and_their_own():
    arcs = np.array([[0.0, 0, 0, 2 * pi]])
    loop = Loop(arcs, 1.0)
    arcs[0, 0] = 7.0
    assert loop.arcs[0, 0] == 0.0
    with pytest.raises(ValueError, match="read-only"):
        loop.arcs[0, 0] = 1.0
    for name in ("arcs", "tau", "area", "other"):
        with pytest.raises(AttributeError):
            setattr(loop, name, 1.0)
    for again in (pickle.loads(pickle.dumps(loop)), copy.deepcopy(loop)):  # noqa: S301
        assert (again, hash(again)) == (loop, hash(loop))
        assert not again.arcs.flags.writeable
    assert loop != circle(0, 0, tau=2.0)
    assert loop != circle(1, 0)
    assert loop != "loop"
    assert repr(ring(6, 1.5)[1]).startswith("<Loop of 6 arcs, hole, area=-")


@pytest.mark.parametrize(
    ("arcs", "tau", "error", "message"),
    [
        ([], 1, ValueError, r"arcs must have shape \(k, 4\)"),
        (np.empty((0, 4)), 1, ValueError, r"arcs must have shape \(k, 4\)"),
        ([[0, 0, 0]], 1, ValueError, r"got \(1, 3\)"),
        ([0, 0, 0, 1], 1, ValueError, r"got \(4,\)"),
        ([[0, 0, 0, 1], [0, math.nan, 0, 1]], 1, ValueError, r"arcs\[1, 1\] must be finite"),
        ([[0, 0, 1, 1]], 1, ValueError, r"arcs\[0\] must end at most 2 pi after"),
        ([[0, 0, 0, 1], [0, 0, 0, 6.3]], 1, ValueError, r"arcs\[1\] must end at most 2 pi after"),
        ([["a", 0, 0, 1]], 1, ValueError, "arcs must be an array of numbers"),
        ([[None, 0, 0, object()]], 1, TypeError, "arcs must be an array of numbers"),
        ([[0, 0, 0, 1]], 0, ValueError, "tau must be"),
        ([[0, 0, 0, 1]], "1", TypeError, "tau must be"),
    ],
)
def test_what_is_no_loop(arcs, tau, error, message):
    with pytest.raises(error, match=message):
        Loop(arcs, tau)


def test_what_is_no_boundary(monkeypatch):
    with pytest.raises(TypeError, match=r"loops\[1\] must be a Loop, got int"):
        to_shapely([circle(0, 0), 1])
    outer, hole = ring(6, 1.5)
    with pytest.raises(ValueError, match="outer loop around every hole"):
        to_shapely([hole])
    with pytest.raises(ValueError, match="outer loop around every hole"):
        to_shapely([circle(9, 9), hole])
    for wrong, error in ((0, ValueError), (100_001, ValueError), (1.5, TypeError)):
        with pytest.raises(error, match="quad_segs must be"):
            to_shapely([outer, hole], quad_segs=wrong)

    def without(name, *args, **kwargs):
        if name == "shapely":
            raise ImportError(name)
        return imported(name, *args, **kwargs)

    imported = builtins.__import__
    monkeypatch.setattr(builtins, "__import__", without)
    with pytest.raises(ImportError, match=r"divbandit\[peers\]"):
        to_shapely([outer])
