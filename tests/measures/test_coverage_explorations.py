"""The coverage of whole explorations, thousands of discs deep in places, in any order.

The archived effects are those of figure 1 and of each panel of figure 2, 5000 each, from the
archived results of the paper (doi:10.1109/devlrn.2015.7346130).
"""

from functools import cache
from pathlib import Path

import numpy as np
import pytest

import divbandit as db
from tests.reference.union_area import union_area

ARCHIVE = Path(__file__).parents[1] / "reference" / "figures_1_2_effects.npz"
ARCHIVED = ("figure1_motor_babbling", "figure2_d0.001", "figure2_d0.05", "figure2_d0.5")
GENERATED = {
    "motor babbling": db.MotorBabbling(),
    "goal babbling, d = 0.001": db.GoalBabbling(0.001),
    "goal babbling, d = 0.05": db.GoalBabbling(0.05),
}


@cache
def archived(name):
    with np.load(ARCHIVE) as saved:
        return saved[name]


@cache
def generated(name):
    return db.explore(db.PlanarArm(20), GENERATED[name], n=2000, rng=0).effects


def orders(n):
    """Return the orders of arrival to try: as it was, reversed, and two at random."""
    rng = np.random.default_rng(2)
    return [np.arange(n), np.arange(n)[::-1], rng.permutation(n), rng.permutation(n)]


def check(effects, tau):
    expected = union_area(effects, tau)
    assert db.coverage(effects, tau) == pytest.approx(expected, rel=1e-10, abs=0)
    for order in orders(len(effects)):
        gains = db.Coverage(tau).extend(effects[order])
        assert gains.sum() == pytest.approx(expected, rel=1e-10, abs=0)
        assert gains.min() >= 0


@pytest.mark.parametrize("tau", [0.005, 0.02, 0.1])
@pytest.mark.parametrize("name", ARCHIVED)
def test_archived_effects(name, tau):
    effects = archived(name)
    assert effects.shape == (5000, 2)
    check(effects, tau)


@pytest.mark.parametrize("tau", [0.005, 0.02, 0.1])
@pytest.mark.parametrize("name", GENERATED)
def test_generated_effects(name, tau):
    check(generated(name), tau)
