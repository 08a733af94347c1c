"""An arm that touches something at rest is refused, and told what."""

import numpy as np
import pytest

import divbandit as db
from divbandit.environments import Disc, Polygon, Rectangle, Wall

CLEAR = Disc([0, 2], 0.5)
#: Around each kind's place: what touches the rest posture, and the same moved away.
TOUCHING = {
    "disc on the arm": lambda y: Disc([0.5, y], 0.1),
    "disc that touches": lambda y: Disc([0.5, y + 0.1], 0.0951),
    "disc at the tip": lambda y: Disc([1.01, y], 0.006),
    "disc of a trillionth": lambda y: Disc([0.33, y], 1e-12),
    "disc around all": lambda y: Disc([0, y - 5], 6.0) if y else Disc([0, 0], 3.0),
    "rectangle on the arm": lambda y: Rectangle([0.4, y - 0.1], [0.6, y + 0.1]),
    "rectangle around all": lambda y: Rectangle([-2, y - 0.5], [2, y + 0.5]),
    "polygon on the arm": lambda y: Polygon([[0.4, y - 0.1], [0.6, y], [0.4, y + 0.1]]),
    "polygon around all": lambda y: Polygon([[-9, y - 0.9], [9, y - 0.9], [0, y + 0.9]]),
    "wall across": lambda y: Wall([0.5, y - 0.1], [0.5, y + 0.1]),
    "wall along": lambda y: Wall([0.1, y], [0.9, y]),
    "wall around all": lambda y: Wall([-1, y], [2, y], thickness=0.5),
    # The base alone: behind it is the round end of the first link.
    "base in a disc": lambda y: Disc([-0.01, y], 0.0099),
    "base in a rectangle": lambda y: Rectangle([-0.1, y - 0.1], [-0.004, y + 0.1]),
    "base in a polygon": lambda y: Polygon([[-0.2, y - 0.1], [-0.004, y], [-0.2, y + 0.1]]),
    "base in a wall": lambda y: Wall([-0.02, y], [-0.011, y], thickness=0.0121),
    "base on the end of a line": lambda y: Wall([-0.5, y], [-0.004, y]),
}


@pytest.mark.parametrize("joints", [1, 2, 20])
@pytest.mark.parametrize("name", TOUCHING)
def test_what_touches_the_arm_at_rest_is_named(name, joints):
    touching = TOUCHING[name](0.0)
    for index in range(3):
        obstacles = [CLEAR] * 3
        obstacles[index] = touching
        with pytest.raises(ValueError, match=rf"^obstacles\[{index}\] must .*rest"):
            db.PlanarArm(joints, thickness=0.01, obstacles=obstacles)


@pytest.mark.parametrize("name", TOUCHING)
def test_the_same_elsewhere_is_not(name):
    arm = db.PlanarArm(3, thickness=0.01, obstacles=[CLEAR, TOUCHING[name](-1.6)])
    assert arm(np.zeros(3)).tolist() == [1, 0]


@pytest.mark.parametrize(
    "obstacle",
    [
        Disc([0.5, 0.1], 0.094999),
        Rectangle([0.4, 0.005001], [0.6, 0.1]),
        Polygon([[0.4, 0.1], [0.5, 0.005001], [0.6, 0.1]]),
        Wall([0.1, -0.006001], [0.9, -0.006001], thickness=0.002),
        Wall([1.005001, -1], [1.005001, 1]),
        Wall([-0.005001, -1], [-0.005001, 1]),
        # Around the arm, but not on it.
        Polygon(
            [[-1, -1], [2, -1], [2, 1], [-1, 1], [-1, 0.9], [1.9, 0.9], [1.9, -0.9], [-1, -0.9]]
        ),
    ],
    ids=["disc", "rectangle", "polygon", "wall", "before the tip", "behind the base", "around"],
)
def test_what_is_a_millionth_away_is_clear(obstacle):
    arm = db.PlanarArm(5, thickness=0.01, obstacles=[obstacle])
    assert arm(np.zeros(5)).tolist() == [1, 0]


def test_no_more_obstacles_than_one_need_be_in_the_way():
    """What is at fault is an obstacle that touches, not one that is near."""
    near = Wall([0.1, 0.00501], [0.9, 0.00501])
    with pytest.raises(ValueError, match=r"^obstacles\[1\]"):
        db.PlanarArm(5, thickness=0.01, obstacles=[near, Disc([0.5, 0], 0.1), near])
