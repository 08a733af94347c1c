"""Arms drawn at random, some with spaces of the user's own."""

from types import SimpleNamespace

import numpy as np
from hypothesis import strategies as st

import divbandit as db
from tests.exploration.random_compositions import planes

#: What an edge of a motor space of one's own may be: the arm's, a part of it, a single angle, 0.
EDGES = ("whole", "part", "point", "zero")


@st.composite
def arms(draw):
    """Draw an arm of 1 to 40 joints; its spaces may have been replaced."""
    limit = draw(st.one_of(st.floats(0.01, 3.14), st.sampled_from([1e-300, 40.0])))
    arm = db.PlanarArm(draw(st.integers(1, 40)), limit=limit, **draw(surroundings()))
    if draw(st.booleans()):
        edges = draw(st.sampled_from([*EDGES, "mixed"]))
        low, high = _within(arm, edges, draw(st.integers(0, 2**32 - 1)))
        arm.motor_space = draw(st.sampled_from([db.Box] * 4 + [_namespace]))(low, high)
    if draw(st.booleans()):
        arm.sensory_space = draw(st.one_of(planes(), planes(), planes(), st.none()))
    return arm


def surroundings():
    """Draw what an arm of any number of joints can have in its way."""
    walls = [db.Wall([-1, 0.2], [1, 0.2]), db.Wall([0.3, -0.5], [0.3, -0.05], thickness=0.01)]
    discs = [db.Disc([x, y], 0.05) for x in (-0.5, 0, 0.6) for y in (-0.3, 0.15)]
    among = {"obstacles": [*walls, *discs], "thickness": 0.001}
    return st.sampled_from([{}, {}, among, {**among, "self_contact": True}])


def _namespace(low, high):
    """Return a box that is no Box."""
    return SimpleNamespace(low=low.tolist(), high=high.tolist())


def _within(arm, edges, seed):
    """Return the corners of a box within the arm's limits, every edge of one kind or `mixed`."""
    rng = np.random.default_rng(seed)
    low, high = np.sort(rng.uniform(-arm.limit, arm.limit, (2, arm.joints)), axis=0)
    drawn = rng.choice(EDGES, arm.joints) if edges == "mixed" else np.full(arm.joints, edges)
    low[drawn == "whole"], high[drawn == "whole"] = -arm.limit, arm.limit
    high[drawn == "point"] = low[drawn == "point"]
    low[drawn == "zero"], high[drawn == "zero"] = -0.0, 0.0
    return low, high
