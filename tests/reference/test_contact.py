"""The oracle of contact: what is known on paper, and two ways that agree with each other."""

import numpy as np
import pytest

import divbandit as db
from divbandit.environments import Disc, Polygon, Rectangle, Wall
from tests.environments.random_scenes import scene
from tests.reference import contact

UPRIGHT = [np.pi / 2, 0.0]


@pytest.mark.parametrize(
    ("obstacle", "apart"),
    [
        (Disc([0.6, 0.5], 0.1), 0.45),
        (Disc([0.0, 1.6], 0.1), 0.45),
        (Rectangle([0.3, 0.1], [0.9, 0.6]), 0.25),
        (Polygon([[0.3, 0.1], [0.9, 0.1], [0.9, 0.9], [0.3, 0.9], [0.5, 0.5]]), 0.25),
        (Wall([-2, 1.3], [2, 1.3], thickness=0.2), 0.15),
        (Wall([-0.5, 0.5], [-1, 0.5]), 0.45),
        (Wall([-0.5, 0.5], [0.5, 0.5]), -0.05),
        (Disc([0.1, 0.5], 0.1), -0.05),
    ],
)
def test_clearances_known_on_paper(obstacle, apart):
    arm = db.PlanarArm(2, thickness=0.1, obstacles=[obstacle])
    assert contact.clearance(arm, UPRIGHT) == pytest.approx(apart, abs=1e-15)


def test_a_square_of_links():
    """Three links round a square; the fourth passes its last corner, half a diagonal away."""
    arm = db.PlanarArm(4, thickness=0.1, self_contact=True)
    square = np.array([0, np.pi / 2, np.pi / 2, np.pi / 4])
    assert contact.clearance(arm, square) == pytest.approx(0.25 * np.sqrt(0.5) - 0.1)
    assert contact.clearance(db.PlanarArm(4), square) == np.inf


def test_steps_stop_where_the_clearance_is_used_up():
    for i in range(60):
        each = scene(np.random.default_rng([9, i]))
        shares = np.arange(1, 301) / 300
        left = contact.clearance(each.arm, np.outer(shares, each.command))
        found = contact.first_contact(each.arm, each.command, steps=300)
        assert found == (shares[(left <= 0).argmax()] if (left <= 0).any() else None)
