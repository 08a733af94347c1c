"""An arm stops at first contact: random scenes against small steps, and laws of all scenes."""

import math

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

import divbandit as db
from divbandit.environments import Disc, Polygon, Rectangle, Wall
from tests.environments.random_scenes import Scene, among, rest_clearance, scene
from tests.reference import contact

SCENES = 500
STEPS = 5_000
#: What may be left between the arm and what it touches, in metres.
LEFT = 1e-6
#: The share of the way to which contact is found, and what is contact, in metres, for rounding.
PRECISION, TOUCH = 1e-9, 2e-13
#: Samples of the oracle are this far apart at most in the share of the way, plus rounding.
STEP = 1 / STEPS + 1e-12


def drawn(i):
    return scene(np.random.default_rng([7, i]))


@pytest.fixture(scope="module")
def first_contacts():
    """Each scene with the first of its steps at which the oracle finds contact."""
    scenes = [drawn(i) for i in range(SCENES)]
    return [(each, contact.first_contact(each.arm, each.command, steps=STEPS)) for each in scenes]


def test_a_good_share_of_scenes_end_in_contact(first_contacts):
    share = np.mean([found is not None for _, found in first_contacts])
    assert 0.3 < share < 0.7
    stopped = [each for each, found in first_contacts if found is not None]
    kinds = {type(obstacle) for each in stopped for obstacle in touched(each)}
    assert kinds == {Disc, Rectangle, Polygon, Wall, type(None)}


def touched(each):
    """Yield the obstacles at which the arm stopped; None for one of its own links."""
    chain = contact.postures(each.arm.progress(each.command) * each.command)
    for k in np.flatnonzero(contact.clearances(each.arm, chain[None])[0] < LEFT):
        yield each.arm.obstacles[k] if k < len(each.arm.obstacles) else None


def test_random_scenes_against_small_steps(first_contacts):
    grazes = 0
    for each, found in first_contacts:
        progress = float(each.arm.progress(each.command))
        last = 1.0 if found is None else found
        assert progress <= last, each
        # All that there is to say where it stopped at what the steps stepped over.
        holds_the_laws(each)
        grazes += progress < last - (0 if found is None else STEP)
    assert grazes <= SCENES // 50


def test_where_it_stops_is_where_posture_and_effect_are(first_contacts):
    for each, _ in first_contacts:
        progress = each.arm.progress(each.command)
        posture = each.arm.posture(each.command)
        expected = contact.postures(progress * each.command)
        np.testing.assert_allclose(posture, expected, rtol=0, atol=1e-13)
        assert each.arm(each.command).tolist() == posture[-1].tolist()


def holds_the_laws(each):
    """Check that the arm is clear where it stopped and before, and touches 1e-9 of the way on."""
    progress = float(each.arm.progress(each.command))
    assert 0 <= progress <= 1
    posture = each.arm.posture(each.command)
    left = contact.clearances(each.arm, posture[None]).min()
    assert left >= 0
    before = [progress * share for share in (0, 0.25, 0.5, 0.9, 0.999, 1 - 1e-6)]
    before += [progress - ago for ago in (1e-3, 1e-5, 1e-7) if ago < progress]
    assert (contact.clearance(each.arm, np.outer(before, each.command)) > 0).all()
    if progress < 1:
        assert left < LEFT
        after = min(1.0, progress + PRECISION)
        assert contact.clearance(each.arm, after * each.command) <= TOUCH
    return progress


@given(seed=st.integers(0, 2**32 - 1))
@settings(max_examples=300)
def test_laws_of_random_scenes(seed):
    holds_the_laws(scene(np.random.default_rng(seed)))


numbers = st.floats(-1.25, 1.25, width=32)
points = st.tuples(numbers, numbers)
walls = st.builds(
    lambda start, end, thickness: Wall(start, end, thickness=thickness),
    points,
    points.map(lambda point: (point[0], point[1] + 2.5)),  # elsewhere than its start
    st.sampled_from([0.0, 1e-9, 1e-6, 0.01]),
)
discs = st.builds(Disc, points, st.sampled_from([1e-9, 1e-6, 0.01, 0.3]))
rectangles = st.builds(
    lambda low, width, height: Rectangle(low, (low[0] + width, low[1] + height)),
    points,
    st.sampled_from([1e-6, 0.01, 1.0]),
    st.sampled_from([1e-6, 0.01, 1.0]),
)


@given(
    angles=st.lists(st.floats(-3, 3), min_size=1, max_size=8),
    obstacles=st.lists(st.one_of(walls, discs, rectangles), max_size=4),
    thickness=st.sampled_from([1e-6, 1e-4, 0.01, 0.1]),
    self_contact=st.booleans(),
)
@settings(max_examples=300)
def test_laws_of_scenes_that_hypothesis_draws(angles, obstacles, thickness, self_contact):
    """Lines that cross at special places: on the axes, at right angles, through the base."""
    joints = len(angles)
    free = db.PlanarArm(joints, limit=3.0, thickness=thickness, self_contact=self_contact)
    clear = [obstacle for obstacle in obstacles if rest_clearance(free, obstacle) > 1e-9]
    each = Scene(among(free, clear), np.array(angles))
    progress = holds_the_laws(each)
    found = contact.first_contact(each.arm, each.command, steps=500)
    assert progress <= (1 if found is None else found)


def test_the_order_of_obstacles_does_not_matter():
    rng = np.random.default_rng(1)
    for i in range(200):
        each = drawn(i)
        shuffled = [each.arm.obstacles[k] for k in rng.permutation(len(each.arm.obstacles))]
        other = among(each.arm, shuffled)
        assert other.progress(each.command) == each.arm.progress(each.command)
        assert other(each.command).tolist() == each.arm(each.command).tolist()


@pytest.mark.parametrize("joints", [1, 2, 3, 8, 20])
@pytest.mark.parametrize("limit", [math.radians(150), 10.0])
def test_what_is_out_of_reach_changes_no_bit(joints, limit):
    free = db.PlanarArm(joints, limit=limit)
    far = [
        Disc([1.5, 0], 0.4),
        Rectangle([-3, -3], [3, -1.01]),
        Wall([-2, 1.01], [2, 1.01], thickness=0.005),
        Polygon([[-1.1, -1], [-1.2, 1], [-1.3, 0]]),
    ]
    arm = among(free, far)
    commands = np.random.default_rng(2).uniform(-limit, limit, (500, joints))
    assert (arm.progress(commands) == 1).all()
    assert arm(commands).tolist() == free(commands).tolist()
    for command in commands[:20]:
        assert arm(command).tolist() == free(command).tolist()
        assert arm.posture(command).tolist() == free.posture(command).tolist()


def test_what_is_in_reach_but_not_on_the_way_changes_no_bit(first_contacts):
    for each, _ in first_contacts:
        if each.arm.progress(each.command) == 1:
            free = db.PlanarArm(each.arm.joints, limit=each.arm.limit)
            assert each.arm(each.command).tolist() == free(each.command).tolist()
            assert each.arm.posture(each.command).tolist() == free.posture(each.command).tolist()


def test_many_at_once_are_the_same_bits_as_one_by_one():
    for i in range(50):
        each = drawn(i)
        rng = np.random.default_rng(i)
        commands = rng.uniform(-each.arm.limit, each.arm.limit, (rng.integers(20), each.arm.joints))
        tips, progress = each.arm(commands), each.arm.progress(commands)
        assert tips.shape == (len(commands), 2)
        assert progress.shape == (len(commands),)
        assert tips.tolist() == [each.arm(command).tolist() for command in commands]
        assert progress.tolist() == [each.arm.progress(command).tolist() for command in commands]


def test_no_motion_meets_nothing():
    for i in range(50):
        each = drawn(i)
        assert each.arm.progress(np.zeros(each.arm.joints)) == 1
        assert each.arm(np.zeros(each.arm.joints)).tolist() == [1, 0]
