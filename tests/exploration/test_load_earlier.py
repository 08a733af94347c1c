"""Files of the first format: explorations are read, explorers refused with what to do.

Both were written by the first version, with ``rng=0``: an exploration of 12 steps, and an explorer
that was told 5.
"""

from pathlib import Path

import numpy as np
import pytest

import divbandit as db

FOLDER = Path(__file__).parent / "earlier"
ARM = db.PlanarArm(3)
ADAPT = db.Adapt([db.MotorBabbling(), db.GoalBabbling(0.05)], tau=0.1, window=5)


def test_an_exploration_is_read():
    run, again = (
        db.Exploration.load(FOLDER / "exploration_1.npz"),
        db.explore(ARM, ADAPT, n=12, rng=0),
    )
    for name in ("commands", "effects", "paths", "estimates"):
        assert (getattr(run, name) == getattr(again, name)).all()


def test_an_explorer_is_refused_with_a_way_to_go_on():
    with pytest.raises(ValueError, match="past="):
        db.Explorer.load(FOLDER / "explorer_1.npz")


def test_the_way_to_go_on():
    with np.load(FOLDER / "explorer_1.npz") as arrays:
        commands, effects = arrays["commands"], arrays["effects"]
    explorer = db.Explorer(ADAPT, ARM.motor_space, ARM.sensory_space, rng=0)
    explorer.add_past(commands, effects)
    assert (explorer.history.effects == db.explore(ARM, ADAPT, n=5, rng=0).effects).all()
    explorer.tell(trial := explorer.ask(), ARM(trial.command))
    assert len(explorer.history) == 6
