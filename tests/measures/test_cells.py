"""CellCoverage is the coverage that a grid archive of pyribs reports."""

import numpy as np
import pytest
from ribs.archives import GridArchive

import divbandit as db
from divbandit.measures import CellCoverage


@pytest.mark.parametrize(
    ("cells", "low", "high"),
    [(10, [-1, -1], [1, 1]), ([3, 7], [0, -50], [1, 20]), ([4, 2, 3], [-1, 0, 5], [1, 3, 6])],
)
def test_it_is_that_of_pyribs(cells, low, high):
    dim, rng = len(low), np.random.default_rng(0)
    measure = CellCoverage(cells, db.Box(low, high)).start(dim)
    archive = GridArchive(
        solution_dim=1,
        dims=[cells] * dim if isinstance(cells, int) else cells,
        ranges=list(zip(low, high, strict=True)),
    )
    width = np.subtract(high, low)
    for _ in range(40):
        effects = low + width * rng.normal(0.5, 0.4, (4, dim))  # some of them outside
        measure.extend(effects)
        archive.add(np.zeros((4, 1)), np.ones(4), effects)
        assert measure.measure == pytest.approx(archive.stats.coverage)


def test_gains_add_up_to_the_whole():
    measure = CellCoverage(2, db.Box([0, 0], [1, 1])).start(2)
    gains = [measure.add(effect) for effect in ([0, 0], [0.4, 0.4], [9, 9], [-1, 5], [1, 0])]
    assert gains == [0.25, 0.0, 0.25, 0.25, 0.25]
    assert measure.measure == 1.0
    assert measure.largest_gain == 0.25


def test_a_box_without_width():
    measure = CellCoverage(3, db.Box([0, 2], [1, 2])).start(2)
    assert measure.extend([[0.5, 2], [0.5, 1], [0.5, 3]]).tolist() == [1 / 9, 0, 1 / 9]


def test_bad_input():
    box = db.Box([0, 0], [1, 1])
    for cells, kind in ((0, ValueError), ([2], ValueError), (5000, ValueError), (2.0, TypeError)):
        with pytest.raises(kind, match="cells"):
            CellCoverage(cells, box)
    with pytest.raises(TypeError, match="box"):
        CellCoverage(3, 5)
    with pytest.raises(ValueError, match="box must have length 3, got 2"):
        CellCoverage(3, box).start(3)
