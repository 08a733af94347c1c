"""GridCoverage: cells counted by hand, and by a plain oracle."""

import math

import numpy as np
import pytest

from divbandit.measures import GridCoverage


def test_counts_by_hand():
    grid = GridCoverage(1.0).start(2)
    effects = [[0.5, 0.5], [0.9, 0.1], [1.0, 0.5], [-0.1, 0.5], [-0.0, 0.0], [-1.0, 0.5]]
    assert grid.extend(effects).tolist() == [1.0, 0.0, 1.0, 1.0, 0.0, 0.0]
    assert (grid.measure, len(grid), grid.dim, grid.largest_gain) == (3.0, 6, 2, 1.0)


def test_cells_are_closed_below_and_open_above():
    grid = GridCoverage(0.25).start(1)
    assert grid.extend([[0.25], [math.nextafter(0.5, 0)], [0.5]]).tolist() == [1, 0, 1]
    assert grid.extend([[math.nextafter(0.25, 0)], [0.0], [-(2.0**-1074)]]).tolist() == [1, 0, 1]


def test_the_two_zeros_lie_in_one_cell():
    grid = GridCoverage(1.0).start(2)
    zeros = [[0.0, 0.0], [-0.0, 0.0], [0.0, -0.0], [-0.0, -0.0]]
    assert grid.extend(zeros).tolist() == [1, 0, 0, 0]


def test_an_edge_for_each_coordinate():
    grid = GridCoverage([1.0, 10.0]).start(2)
    assert grid.extend([[0, 0], [0, 9], [0.5, 9.5], [1, 0], [0, 10]]).tolist() == [1, 0, 0, 1, 1]


def test_the_origin_is_a_corner():
    def gains(**origin):
        return GridCoverage(1.0, **origin).start(2).extend([[-0.5, 0], [0.4, 0], [0.5, 0]]).tolist()

    assert gains() == [1, 1, 0]
    assert gains(origin=0.5) == [1, 0, 1]
    assert gains(origin=[-0.5, 7]) == [1, 0, 1]


@pytest.mark.parametrize("far", [1e16, 1e100, 1e300, -1e300, 1.7e308, -1.7e308])
def test_far_effects_have_cells(far):
    grid = GridCoverage(1.0).start(2)
    assert grid.add([far, 0.0]) == 1.0
    assert grid.add([far, 0.0]) == 0.0
    assert grid.add([math.nextafter(far, 0), 0.0]) == 1.0


@pytest.mark.parametrize("cell", [5e-324, 1e-300, 1e300, 1.7e308])
def test_cells_of_any_size(cell):
    grid = GridCoverage(cell).start(1)
    assert grid.extend([[0.0], [cell / 2], [cell], [-cell]]).tolist()[2:] == [1.0, 1.0]


@pytest.mark.parametrize(
    ("cell", "origin", "effect"),
    [(1e-10, 0.0, 1e300), (5e-324, 0.0, -1.0), (1.0, -1.7e308, 1.7e308)],
)
def test_too_many_cells_away(cell, origin, effect):
    grid = GridCoverage(cell, origin=[0.0, origin]).start(2)
    if origin == 0.0:
        grid.add([0.0, 0.0])
    before = (len(grid), grid.measure)
    message = r"must be within 1.7e308 cells of .*with cell"
    with pytest.raises(ValueError, match=r"effect\[1\] " + message):
        grid.add([0.0, effect])
    with pytest.raises(ValueError, match=r"effect\[2, 1\] " + message):
        grid.gain([[0.0, origin], [0.0, origin], [0.0, effect]])
    with pytest.raises(ValueError, match=r"effects\[1, 1\] " + message):
        grid.extend([[0.0, origin], [0.0, effect]])
    assert (len(grid), grid.measure) == before


@pytest.mark.parametrize(
    ("grid", "dim", "message"),
    [
        (GridCoverage([1.0, 2.0]), 3, "cell must have length 3, got 2"),
        (GridCoverage(1.0, origin=[1.0, 2.0]), 1, "origin must have length 1, got 2"),
        (GridCoverage(1.0), 0, "dim must be from 1 to 1000000, got 0"),
        (GridCoverage(1.0), 1_000_001, "dim must be from 1 to 1000000, got 1000001"),
    ],
)
def test_a_dimension_that_does_not_fit(grid, dim, message):
    with pytest.raises(ValueError, match=f"^{message}$"):
        grid.start(dim)


def test_fields_are_numbers_or_tuples_of_them():
    grid = GridCoverage(np.array([1, 2]), origin=np.float32(0.5))
    assert (grid.cell, grid.origin) == ((1.0, 2.0), 0.5)
    assert [type(x) for x in (*grid.cell, grid.origin)] == [float] * 3


def test_says_what_it_is():
    grid = GridCoverage(0.5).start(2)
    grid.extend([[0, 0], [0, 1], [0, 1]])
    assert repr(grid) == "<GridCoverage(0.5) of 3 effects in R^2, measure=2.0>"
