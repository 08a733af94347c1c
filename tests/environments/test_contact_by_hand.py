"""When an arm touches something, in scenes simple enough for a formula."""

import math

import pytest

import divbandit as db
from divbandit.environments import Disc, Polygon, Rectangle, Wall

#: The share of the way to which contact is found.
PRECISION = 1e-9
LINK = 1 / 3


def polar(distance, angle):
    return [distance * math.cos(angle), distance * math.sin(angle)]


def turning(*obstacles, thickness=0.02, limit=3.0):
    """Return an arm of one link."""
    return db.PlanarArm(1, limit=limit, thickness=thickness, obstacles=obstacles)


def stops_at(arm, command, angle):
    """Check that the first angle is `angle` when the arm stops: at it or less than 1e-9 before."""
    contact = angle / command[0]
    assert 0 < contact < 1
    progress = float(arm.progress(command))
    assert contact - PRECISION <= progress <= contact + 1e-14 * max(1, abs(command[0]))


@pytest.mark.parametrize("turn", [1, -1])
@pytest.mark.parametrize("radius", [1e-9, 1e-3, 0.2])
@pytest.mark.parametrize("thickness", [1e-6, 1e-3, 0.1])
@pytest.mark.parametrize("distance", [0.3, 0.7, 0.99])
def test_a_link_sweeps_onto_a_disc(distance, thickness, radius, turn):
    arm = turning(Disc(polar(distance, turn), radius), thickness=thickness)
    stops_at(arm, [3.0 * turn], turn * (1 - math.asin((radius + thickness / 2) / distance)))


@pytest.mark.parametrize("radius", [0.11, 0.3])
@pytest.mark.parametrize("thickness", [1e-6, 0.1])
def test_a_tip_meets_a_disc(thickness, radius):
    """The tip is the nearest point of the link: a triangle of known sides."""
    distance, apart = 1.1, radius + thickness / 2
    aside = math.acos((1 + distance**2 - apart**2) / (2 * distance))
    arm = turning(Disc(polar(distance, 2.0), radius), thickness=thickness)
    stops_at(arm, [3.0], 2 - aside)


@pytest.mark.parametrize("wide", [0.0, 1e-6, 0.02])
@pytest.mark.parametrize("thickness", [1e-6, 1e-3, 0.1])
def test_a_link_sweeps_onto_the_end_of_a_wall(thickness, wide):
    wall = Wall(polar(0.6, 1.5), polar(2, 1.5), thickness=wide)
    stops_at(turning(wall, thickness=thickness), [3], 1.5 - math.asin((thickness + wide) / 1.2))


@pytest.mark.parametrize("wide", [0.0, 1e-6, 0.02])
def test_a_link_comes_to_lie_flat_on_a_wall(wide):
    """At the angle of the wall both touch all along, and never before."""
    (x, y), (across, up) = polar((0.02 + wide) / 2, 1 + math.pi / 2), polar(1, 1)
    start, end = ([x + along * across, y + along * up] for along in (0.2, 0.8))
    wall = Wall(start, end, thickness=wide)
    arm = turning(wall)
    progress = float(arm.progress([2.0]))
    assert progress == pytest.approx(0.5, rel=0, abs=PRECISION)


@pytest.mark.parametrize("wide", [0.0, 1e-6, 0.02])
def test_a_link_that_does_not_turn_lands_flat_on_a_wall(wide):
    """The second link goes up as it is; all of its points touch at once."""
    wall = Wall([-2, 0.3], [2, 0.3], thickness=wide)
    arm = db.PlanarArm(2, limit=2.0, thickness=0.02, obstacles=[wall])
    stops_at(arm, [1.5, -1.5], math.asin(2 * (0.3 - (0.02 + wide) / 2)))


@pytest.mark.parametrize("speed", [1.5, 100.0])
@pytest.mark.parametrize(
    "ceiling",
    [
        Wall([-2, 0.8], [2, 0.8]),
        Wall([-2, 0.8 + 5e-7], [2, 0.8 + 5e-7], thickness=1e-6),
        Rectangle([0.1, 0.8], [0.9, 1.2]),
        Rectangle([-1, 0.8], [1, 0.8 + 1e-6]),
        # An angle whose inner corner is where the tip arrives; its convex hull is met earlier.
        Polygon([[0.2, 0.8], [1.2, 0.8], [1.2, 0.2], [1.4, 0.2], [1.4, 1], [0.2, 1]]),
    ],
    ids=["line", "thin wall", "rectangle", "thin rectangle", "polygon"],
)
def test_a_tip_meets_a_ceiling(ceiling, speed):
    stops_at(turning(ceiling, limit=speed), [speed], math.asin(0.8 - 0.01))


@pytest.mark.parametrize(
    "corner",
    [
        Rectangle([0.5, 0.3], [0.9, 0.6]),
        Polygon([[0.9, 0.3], [0.9, 0.6], [0.2, 0.6]]),
        Polygon([[0.9, 0.3], [0.6, 0.4], [0.2, 0.6], [0.9, 0.6]]),
    ],
    ids=["rectangle", "triangle", "nonconvex"],
)
def test_a_link_sweeps_onto_a_corner(corner):
    distance, angle = math.hypot(0.9, 0.3), math.atan2(0.3, 0.9)
    stops_at(turning(corner), [1.0], angle - math.asin(0.01 / distance))


def test_an_elbow_meets_a_ceiling():
    arm = db.PlanarArm(2, limit=3.0, thickness=0.02, obstacles=[Wall([-2, 0.4], [2, 0.4])])
    stops_at(arm, [1.4, -2.8], math.asin(2 * (0.4 - 0.01)))


@pytest.mark.parametrize("speed", [3.0, 100.0])
@pytest.mark.parametrize("wide", [0.0, 1e-6])
@pytest.mark.parametrize("start", [0.2, 0.99, 1 - 1e-7])
def test_a_fast_link_meets_a_thin_wall_at_right_angles(start, wide, speed):
    wall = Wall(polar(start, 2), polar(2, 2), thickness=wide)
    arm = turning(wall, limit=speed, thickness=1e-6)
    stops_at(arm, [speed], 2 - math.asin((1e-6 + wide) / 2 / start))


@pytest.mark.parametrize("wide", [0.0, 1e-6])
def test_a_fast_tip_of_many_links_meets_a_thin_wall_at_right_angles(wide):
    """All links but the first keep in line, so the arm turns as one link does."""
    wall = Wall(polar(0.95, 2), polar(2, 2), thickness=wide)
    arm = db.PlanarArm(20, limit=100.0, thickness=1e-4, obstacles=[wall])
    stops_at(arm, [100.0] + [0.0] * 19, 2 - math.asin((1e-4 + wide) / 2 / 0.95))


@pytest.mark.parametrize("speed", [3.0, 50.0])
@pytest.mark.parametrize("radius", [1e-3, 0.3])
@pytest.mark.parametrize("make", [Disc, lambda end, r: Wall(end, polar(3, 2), thickness=2 * r)])
def test_a_tip_that_just_misses_goes_on(make, radius, speed):
    near = 1 + 0.01 + radius + 1e-7
    assert turning(make(polar(near, 2), radius), limit=speed).progress([speed]) == 1


@pytest.mark.parametrize("speed", [3.0, 50.0])
@pytest.mark.parametrize("radius", [1e-3, 0.3])
@pytest.mark.parametrize("make", [Disc, lambda end, r: Wall(end, polar(3, 2), thickness=2 * r)])
def test_a_tip_that_just_touches_stops(make, radius, speed):
    """The triangle of `test_a_tip_meets_a_disc`, written so that nothing cancels."""
    apart, deep = 0.01 + radius, 1e-7
    near = 1 + apart - deep
    half = math.asin(math.sqrt(deep * (apart + near - 1) / (4 * near)))
    arm = turning(make(polar(near, 2), radius), limit=speed)
    stops_at(arm, [speed], 2 - 2 * half)


@pytest.mark.parametrize("apart", [1e-7, -1e-7])
def test_a_corner_is_just_missed_or_just_touched(apart):
    """The nearest corner of a square on its tip, outside of where the arm's tip gets."""
    near = 1.01 + apart
    square = Polygon([[0, near], [0.2, near + 0.2], [0, near + 0.4], [-0.2, near + 0.2]])
    arm = turning(square)
    if apart > 0:
        assert arm.progress([3.0]) == 1
    else:
        half = math.asin(math.sqrt(-apart * (0.01 + near - 1) / (4 * near)))
        stops_at(arm, [3.0], math.pi / 2 - 2 * half)


@pytest.mark.parametrize("first", [0.0, -3.0])
@pytest.mark.parametrize("thickness", [1e-6, 0.01, 0.1])
def test_a_triangle_closes_at_the_base(thickness, first):
    """Three links, each turned by the same angle more: the tip comes back to the base.

    Both ends are (1 + 2 cos angle) / 3 apart, and nothing else is nearer.
    """
    arm = db.PlanarArm(3, limit=3.0, thickness=thickness, self_contact=True)
    command = [first, 2.5, 2.5]
    contact = math.acos((thickness / LINK - 1) / 2) / 2.5
    assert contact - PRECISION <= float(arm.progress(command)) <= contact + 1e-14
    assert db.PlanarArm(3, limit=3.0, thickness=thickness).progress(command) == 1


@pytest.mark.parametrize("first", [0.0, 3.0])
@pytest.mark.parametrize("turn", [1, -1])
@pytest.mark.parametrize("thickness", [1e-6, 0.01, 0.1])
def test_a_tip_comes_down_on_the_first_link(thickness, turn, first):
    """The third link turns twice as fast: the tip is above the first by 4/3 sin a cos² a.

    That is the thickness where sin a - sin³ a is three quarters of it.
    """
    arm = db.PlanarArm(3, limit=4.0, thickness=thickness, self_contact=True)
    command = [first, 1.6 * turn, 3.2 * turn]  # whichever way the whole arm turns
    sine = 1.0  # Newton's method, from above the larger root
    for _ in range(100):
        sine -= (sine - sine**3 - 0.75 * thickness) / (1 - 3 * sine**2)
    contact = math.asin(sine) / 1.6
    assert contact - PRECISION <= float(arm.progress(command)) <= contact + 1e-14


def test_neighbours_may_fold():
    arm = db.PlanarArm(2, limit=4.0, thickness=0.1, self_contact=True)
    assert arm.progress([0.0, math.pi]) == 1


def test_the_first_of_two_is_what_counts():
    """A disc on the way to the wall, or behind it."""
    wall = Wall([-2, 0.8], [2, 0.8])
    early, late = (Disc(polar(0.5, 0.4), 0.01), Disc(polar(0.5, 2.0), 0.01))
    stops_at(turning(wall, early), [2.5], 0.4 - math.asin(0.02 / 0.5))
    stops_at(turning(wall, late), [2.5], math.asin(0.79))
