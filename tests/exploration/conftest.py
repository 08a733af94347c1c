"""A saved exploration, as the bytes of its file."""

import pytest

import divbandit as db


@pytest.fixture(scope="module")
def saved(tmp_path_factory):
    """Return the bytes of a saved exploration."""
    path = tmp_path_factory.mktemp("saved") / "run"
    adapt = db.Adapt([db.MotorBabbling(), db.GoalBabbling(0.05)])
    db.explore(db.PlanarArm(3), adapt, n=30, rng=0).save(path)
    return path.read_bytes()
