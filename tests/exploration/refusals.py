"""What the engine refuses: parts of a user's own; and environments with spaces of all kinds."""

import re

import pytest

import divbandit as db
from tests.generators import state

ENGINES = ("auto", "python", "rust")
N = 60
ARM = db.PlanarArm(3)


class Mine:
    """The arm, as an environment of a user's own, with other spaces where they are given."""

    def __init__(self, **spaces):
        self.motor_space, self.sensory_space = ARM.motor_space, ARM.sensory_space
        vars(self).update(spaces)

    def __call__(self, command):
        return ARM(command)


def assert_refused(part, kind, strategy, rng):
    """Check that the engine names `part` and what it is, and draws nothing."""
    before = state(rng)
    with pytest.raises(ValueError, match=rf'"rust" .* {re.escape(f"got {part}, a {kind}")}$'):
        db.explore(ARM, strategy, N, rng=rng, engine="rust")
    assert state(rng) == before
