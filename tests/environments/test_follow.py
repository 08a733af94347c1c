"""An arm follows a trajectory as far as it can."""

import itertools
import math

import numpy as np
import pytest

import divbandit as db
from tests.environments.random_scenes import among, scene
from tests.reference import contact

#: A wall above the arm; the tip of one link meets it at this angle.
WALL = db.environments.Wall([-2, 0.8], [2, 0.8])
MEETS = math.asin(0.8 - 0.005)


def drawn(i):
    return scene(np.random.default_rng([8, i]))


def straight(command, parts):
    return np.outer(np.arange(parts + 1) / parts, command)


def test_a_straight_trajectory_is_the_call():
    for i in range(100):
        each = drawn(i)
        tip = each.arm(each.command)
        assert each.arm.follow(straight(each.command, 1)).tolist() == tip.tolist()
        # Where it is cut, contact is found to 1e-9 of a part.
        for parts in (2, 7):
            nearly = each.arm.follow(straight(each.command, parts))
            fastest = np.abs(np.cumsum(each.command)).max()
            np.testing.assert_allclose(nearly, tip, rtol=0, atol=2e-9 * (1 + fastest))


def test_a_trajectory_of_rest_alone_stays_there():
    arm = among(db.PlanarArm(3), [WALL])
    assert arm.follow(np.zeros((1, 3))).tolist() == [1, 0]
    assert arm.follow(np.zeros((5, 3))).tolist() == [1, 0]


def test_random_trajectories_against_small_steps():
    stopped = 0
    for i in range(150):
        each = drawn(i)
        rng = np.random.default_rng(i)
        size = min(each.arm.limit, 1.0) * np.array([[0], [0.3], [0.6], [1.0]])
        trajectory = size * rng.uniform(-1, 1, (4, each.arm.joints))
        tip = each.arm.follow(trajectory)
        low, high = where_it_stops(each.arm, trajectory)
        stopped += high is not None
        if high is None:
            free = db.PlanarArm(each.arm.joints, limit=each.arm.limit)
            assert tip.tolist() == free(trajectory[-1]).tolist(), i
        else:
            # On the tip's path between two steps, to second order the line between them.
            apart = math.dist(tip, low) + math.dist(tip, high)
            assert apart <= math.dist(low, high) * (1 + 1e-5) + 1e-9, i
    assert 30 < stopped < 120


def where_it_stops(arm, trajectory):
    """Return the tip at the last step that is clear and the first that touches, or two None."""
    steps = 2000
    for start, end in itertools.pairwise(trajectory):
        found = contact.first_contact(arm, end, start=start, steps=steps)
        if found is not None:
            shares = [found - 1 / steps, found]
            return [contact.postures(start + share * (end - start))[-1] for share in shares]
    return None, None


def test_it_doubles_back():
    arm = among(db.PlanarArm(1), [WALL])
    assert arm.follow([[0.0], [0.9 * MEETS], [0.0], [-1.0]]).tolist() == arm([-1.0]).tolist()
    # However near it was.
    assert arm.follow([[0.0], [MEETS - 1e-8], [0.0], [-1.0]]).tolist() == arm([-1.0]).tolist()


def test_it_stays_where_it_was_stopped():
    arm = among(db.PlanarArm(1), [WALL])
    stopped = arm([2.0])
    assert stopped == pytest.approx([math.cos(MEETS), math.sin(MEETS)], abs=1e-8)
    assert arm.follow([[0.0], [2.0], [0.0], [-1.0]]).tolist() == stopped.tolist()


def test_via_points_lead_round_an_obstacle():
    """Folded, the arm turns past a post that the outstretched arm does not pass."""
    post = db.environments.Disc([0, 0.8], 0.05)
    arm = db.PlanarArm(2, limit=3.0, obstacles=[post])
    goal = [2.5, 0.0]
    free = db.PlanarArm(2, limit=3.0)
    assert arm.progress(goal) < 1
    round_it = [[0.0, 0.0], [0.0, 2.9], [2.5, 2.9], goal]
    assert arm.follow(round_it).tolist() == free(goal).tolist()


def test_many_at_once_are_the_same_bits_as_one_by_one():
    for i in range(30):
        each = drawn(i)
        rng = np.random.default_rng(i)
        many = rng.uniform(-each.arm.limit, each.arm.limit, (rng.integers(8), 4, each.arm.joints))
        many[:, 0] = 0
        tips = each.arm.follow(many)
        assert tips.shape == (len(many), 2)
        assert tips.tolist() == [each.arm.follow(one).tolist() for one in many]


@pytest.mark.parametrize("obstacles", [(), (WALL,)], ids=["free", "obstructed"])
@pytest.mark.parametrize(
    "trajectory",
    [
        [[0.1, 0.0], [0.2, 0.0]],
        np.empty((0, 2)),
        [[0.0, 0.0, 0.0]],
        [[0.0, 0.0], [3.0, 0.0]],
        [[0.0, 0.0], [math.nan, 0.0]],
        [0.0, 0.0],
        np.zeros((1, 1, 1, 2)),
        [[[0.0, 0.0], [0.2, 0.0]], [[0.0, 0.1], [0.2, 0.0]]],
    ],
    ids=["not from rest", "no rows", "joints", "limit", "nan", "1-D", "4-D", "one of many"],
)
def test_what_cannot_be_followed_is_refused(trajectory, obstacles):
    with pytest.raises(ValueError, match="trajectory"):
        db.PlanarArm(2, obstacles=obstacles).follow(trajectory)
