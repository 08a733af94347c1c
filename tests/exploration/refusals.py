"""What the Rust engine refuses: other environments and spaces; a check that it names the part."""

import re

import pytest

import divbandit as db
from tests.generators import state

ENGINES = ("auto", "python", "rust")
N = 60


class Mine:
    """An environment that is the arm, but not of its class."""

    def __init__(self):
        self.arm = db.PlanarArm(3)
        self.motor_space, self.sensory_space = self.arm.motor_space, self.arm.sensory_space

    def __call__(self, command):
        return self.arm(command)


def spaced(**spaces):
    """Return an arm with other spaces."""
    arm = db.PlanarArm(3)
    for name, space in spaces.items():
        object.__setattr__(arm, name, space)
    return arm


PART = r"(?:strategy|environment)(?:\.strategies\[\d+\]|\.\w+)*|\brng\b"


def assert_refused(part, kind, environment, strategy, rng):
    """Check that the Rust engine names `part` and what it is, and draws nothing."""
    before = state(rng)
    with pytest.raises(ValueError, match=re.escape(kind)) as caught:
        db.explore(environment, strategy, N, rng=rng, engine="rust")
    message = str(caught.value)
    # The longest, and a method in the way may be a part of it.
    assert max(re.findall(PART, message), key=len) in (part, f"{part}.{kind}")
    assert "rust" in message
    assert state(rng) == before
