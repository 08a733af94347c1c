"""PushArm: laws of pushing over a thousand runs, cases worked out by hand, what arms promise."""

import math

import numpy as np
import pytest
import shapely

import divbandit as db
from divbandit.environments import Disc, Polygon, PushArm, Rectangle, Wall
from tests.reference import contact

#: How much ball, links and obstacles may overlap, in metres.
OVERLAP = 1e-6


def drawn_obstacle(rng):
    x, y = rng.uniform(-0.9, 0.9, 2)
    size = rng.uniform(0.02, 0.15)
    kind = rng.integers(4)
    if kind == 0:
        return Disc([x, y], size)
    if kind == 1:
        return Rectangle([x, y], [x + size, y + 0.05])
    if kind == 2:  # not convex
        hook = np.array([[0, 0], [1, 0], [1, 1], [0.8, 1], [0.8, 0.2], [0, 0.2]])
        return Polygon([x, y] + 2 * size * hook)
    return Wall([x, y], [x + size, y - 2 * size], thickness=rng.choice([0.0, 1e-6, 0.02]))


def drawn_scene(rng):
    """Return the arguments of a PushArm of 1 to 8 joints, and a command."""
    while True:
        ball = rng.uniform(-0.7, 0.7, 2)
        scene = {
            "joints": int(rng.integers(1, 9)),
            "limit": 2.6,
            "thickness": rng.choice([0.001, 0.01, 0.04]),
            "obstacles": [drawn_obstacle(rng) for _ in range(rng.integers(0, 6))],
            "self_contact": bool(rng.integers(2)),
            "ball": ball,
            "ball_radius": rng.uniform(0.01, 0.1),
        }
        try:
            arm = PushArm(**scene)
        except ValueError:  # at rest it touches something
            continue
        return arm, scene, rng.uniform(-2.6, 2.6, arm.joints)


def gaps(arm, command, path):
    """Return the gaps between the ball and links, and obstacles, wherever the path tells of it."""
    balls = shapely.points(path[:, 1:])
    joints = contact.postures(path[:, :1] * command)
    chains = shapely.linestrings(joints)
    links = shapely.distance(chains, balls) - arm.thickness / 2 - arm.ball_radius
    shapes = [contact.shape(each) for each in arm.obstacles]
    others = [shapely.distance(shape, balls) - radius - arm.ball_radius for shape, radius in shapes]
    return links, np.array(others).reshape(len(shapes), len(path))


def mirrored(obstacle):
    flip = np.array([1.0, -1.0])
    if isinstance(obstacle, Disc):
        return Disc(obstacle.center * flip, obstacle.radius)
    if isinstance(obstacle, Rectangle):
        low, high = obstacle.low, obstacle.high
        return Rectangle([low[0], -high[1]], [high[0], -low[1]])
    if isinstance(obstacle, Polygon):
        return Polygon(obstacle.points * flip)
    return Wall(obstacle.start * flip, obstacle.end * flip, thickness=obstacle.thickness)


def test_a_thousand_runs():
    rng = np.random.default_rng(6)
    touched = pinned = 0
    for _ in range(1000):
        arm, scene, command = drawn_scene(rng)
        effect, path = arm(command), arm.path(command)
        assert np.array_equal(path[-1, 1:], effect)
        links, others = gaps(arm, command, path)
        assert links.min() >= -OVERLAP
        assert others.min(initial=0.0) >= -OVERLAP
        assert (np.diff(path[:, 0]) >= 0).all()
        # The ball moves where a link pushes it, and nowhere else.
        moved = (np.diff(path[:, 1:], axis=0) != 0).any(axis=1)
        assert (links[1:][moved] < 1e-6).all()
        if not moved.any():
            assert np.array_equal(effect, arm.ball)
        own = {key: value for key, value in scene.items() if not key.startswith("ball")}
        without = db.PlanarArm(**own)
        assert path[-1, 0] == arm.progress(command) <= without.progress(command) + 1e-9
        touched += moved.any()
        pinned += arm.progress(command) < without.progress(command) - 1e-9
        scene["obstacles"] = [mirrored(each) for each in scene["obstacles"]]
        scene["ball"] = scene["ball"] * [1, -1]
        np.testing.assert_allclose(PushArm(**scene)(-command), effect * [1, -1], atol=1e-9)
    assert 100 < touched < 500
    assert pinned >= 5


def test_one_link_pushes_a_ball_out_along_its_side():
    # Displaced along the link's normal alone, a ball at radial * u + offset * n, where u is the
    # link's direction, has d(radial) = offset * d(angle).
    arm = PushArm(1, thickness=0.02, ball=[0.3, 0.3], ball_radius=0.04)
    offset, distance = 0.05, math.hypot(0.3, 0.3)
    touch = math.atan2(0.3, 0.3) - math.asin(offset / distance)
    for angle in (0.9, 1.2, 1.6):
        x, y = arm([angle])
        assert y * math.cos(angle) - x * math.sin(angle) == pytest.approx(offset, abs=1e-8)
        radial = math.sqrt(distance**2 - offset**2) + offset * (angle - touch)
        # Steps of a fiftieth of the ball's radius: an error of that order, of what it has moved.
        along = x * math.cos(angle) + y * math.sin(angle)
        assert along == pytest.approx(radial, abs=5e-4)


def test_a_ball_between_a_link_and_two_posts_is_pinned():
    posts = [Disc([0, 0.44], 0.02), Disc([0, 0.56], 0.02)]
    arm = PushArm(1, thickness=0.02, obstacles=posts, ball=[0.2, 0.45], ball_radius=0.1)
    corner = [math.sqrt(0.12**2 - 0.06**2), 0.5]
    assert arm([2.0]) == pytest.approx(corner, abs=1e-7)
    # The link's line is as far from the ball as both are thick.
    angle = math.atan2(corner[1], corner[0]) - math.asin(0.11 / math.hypot(*corner))
    assert float(arm.progress([2.0])) * 2.0 == pytest.approx(angle, abs=1e-6)


def test_a_ball_slides_along_a_wall():
    # The wall is too far up for the tip, not for the ball on it.
    wall = Wall([-1, 1.05], [1, 1.05])
    arm = PushArm(1, thickness=0.02, obstacles=[wall], ball=[0.35, 0.94], ball_radius=0.05)
    path = arm.path([2.0])
    assert path[:, 2].max() == pytest.approx(1.0, abs=1e-8)
    assert path[-1, 0] == 1
    assert path[-1, 1] < -0.3


def test_untouched_balls_stay_to_the_bit():
    arm = PushArm(5, ball=[-0.5, 0.5])
    commands = np.random.default_rng(0).uniform(-0.2, 0.2, (200, 5))
    assert np.array_equal(arm(commands), np.tile(arm.ball, (200, 1)))


def test_many_at_once_are_the_same_bits_as_one_by_one():
    arm = PushArm(6, ball=[0.3, 0.3], obstacles=[Disc([0, -0.5], 0.2)], self_contact=True)
    commands = np.random.default_rng(1).uniform(-arm.limit, arm.limit, (100, 6))
    assert np.array_equal(arm(commands), [arm(command) for command in commands])
    assert np.array_equal(arm.progress(commands), [arm.progress(command) for command in commands])
    assert arm(commands[:0]).shape == (0, 2)
    ways = np.stack([np.zeros_like(commands), commands], axis=1)
    assert np.array_equal(arm.follow(ways), arm(commands))


def test_followed_back_the_ball_stays_where_it_was_pushed():
    arm = PushArm(2, ball=[0.3, 0.3])
    there = [1.2, 0.1]
    pushed = arm(there)
    assert np.linalg.norm(pushed - arm.ball) > 0.1
    assert np.array_equal(arm.follow([[0, 0], there, [0, 0]]), pushed)


def test_the_engine_gives_the_same_bits():
    arm = PushArm(4, obstacles=[Wall([-0.5, 0.8], [0.5, 0.8])], ball=[0.3, 0.3])
    adapt = db.Adapt([db.MotorBabbling(), db.GoalBabbling(0.05)], tau=0.05)
    runs = [db.explore(arm, adapt, 400, rng=3, engine=engine) for engine in ("rust", "python")]
    assert np.array_equal(runs[0].effects, runs[1].effects)
    assert np.array_equal(runs[0].choices, runs[1].choices)


@pytest.mark.parametrize(
    ("wrong", "says"),
    [
        ({"ball": [0.5, 0.0]}, "ball must be clear of the arm at rest"),
        ({"ball": [0.3, 0.05]}, "in contact with the arm"),
        ({"ball": [0.0, 0.8]}, r"one in contact with obstacles\[0\]"),
        ({"ball": [0.3, math.nan]}, r"ball\[1\] must be finite"),
        ({"ball": [0.3]}, r"ball must have shape \(2,\)"),
        ({"ball_radius": 0.0}, "ball_radius must be from 0.001 to 1"),
        ({"ball_radius": math.nan}, "ball_radius must be from 0.001 to 1"),
        ({"thickness": 0.5}, "thickness must be at least 1e-6"),
        ({"obstacles": [Disc([0.5, 0], 0.1)]}, r"obstacles\[0\] must be clear of the arm"),
    ],
)
def test_what_is_refused(wrong, says):
    arguments = {"joints": 3, "obstacles": [Disc([0, 0.8], 0.1)]} | wrong
    with pytest.raises(ValueError, match=says):
        PushArm(**arguments)
