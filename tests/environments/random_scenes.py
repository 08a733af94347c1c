"""Random scenes: an arm, a command, obstacles of all kinds around; about half end in contact."""

from dataclasses import dataclass

import numpy as np

import divbandit as db
from divbandit.environments import Disc, Polygon, Rectangle, Wall
from tests.reference import contact

#: No obstacle is nearer to the arm at rest.
MARGIN = 1e-5
#: Half the motor ranges, in radians: turns of a degree, of half a circle, of many circles.
LIMITS = (0.02, 1.0, np.radians(150), np.radians(150), np.pi, 10.0)


@dataclass
class Scene:
    """A command, and an arm that may not get all of the way."""

    arm: db.PlanarArm
    command: np.ndarray


def scene(rng):
    """Draw a scene; the same from a generator in the same state."""
    joints = int(rng.integers(1, 21))
    limit = LIMITS[rng.integers(len(LIMITS))]
    thickness = min(_powers(rng, 1e-4, 0.05), 0.9 / joints)
    command = rng.uniform(-limit, limit, joints)
    self_contact = bool(rng.random() < 0.3)
    if self_contact and rng.random() < 0.5:
        command = abs(command)  # the arm curls up
    free = db.PlanarArm(joints, limit=limit, thickness=thickness)
    obstacles = []
    wanted = int(rng.integers(1, 13))
    while len(obstacles) < wanted:
        obstacle = _obstacle(rng, _place(rng, command))
        if rest_clearance(free, obstacle) > MARGIN:
            obstacles.append(obstacle)
    return Scene(among(free, obstacles, self_contact=self_contact), command)


def among(arm, obstacles, *, self_contact=None):
    """Return the same arm among these obstacles."""
    return db.PlanarArm(
        arm.joints,
        limit=arm.limit,
        thickness=arm.thickness,
        obstacles=obstacles,
        self_contact=arm.self_contact if self_contact is None else self_contact,
    )


@dataclass
class Alone:
    """A single obstacle and the arm that it is near to, for the oracle."""

    thickness: float
    obstacles: list
    self_contact: bool = False


def rest_clearance(arm, obstacle):
    """Return how far an obstacle is from the arm at rest."""
    return contact.clearance(Alone(arm.thickness, [obstacle]), np.zeros(arm.joints))


def _place(rng, command):
    """Draw where an obstacle is: on the way, near the base, beside the arm at rest, anywhere."""
    match rng.choice(["way", "base", "rest", "anywhere"], p=[0.1, 0.05, 0.1, 0.75]):
        case "way":
            chain = contact.postures(command * rng.random())
            return chain[rng.integers(1, len(chain))] + rng.normal(0, 0.02, 2)
        case "base":
            angle = rng.uniform(0, 2 * np.pi)
            return _powers(rng, 0.01, 0.1) * np.array([np.cos(angle), np.sin(angle)])
        case "rest":
            return np.array([rng.uniform(0, 1.05), rng.choice([-1, 1]) * _powers(rng, 1e-3, 0.1)])
    return rng.uniform(-1.2, 1.2, 2)


def _obstacle(rng, place):
    size = _powers(rng, 1e-4, 0.08)
    match rng.integers(5):
        case 0:
            return Disc(place, size)
        case 1:
            half = size * rng.uniform(0.1, 1.0, 2)
            return Rectangle(place - half, place + half)
        case 2:
            return Polygon(place + size * _star(rng))
        case 3:
            return Polygon(place + size * _pocket(rng))
    angle = rng.uniform(0, 2 * np.pi)
    half = size * np.array([np.cos(angle), np.sin(angle)])
    thickness = rng.choice([0.0, 1e-6, _powers(rng, 1e-5, 0.05)])
    return Wall(place - half, place + half, thickness=thickness)


def _star(rng):
    """Draw a polygon around the origin whose corners go in and out, either way round."""
    corners = int(rng.integers(3, 12))
    angles = 2 * np.pi * (np.arange(corners) + rng.uniform(0, 0.9, corners)) / corners
    radii = rng.uniform(0.1, 1.0, corners)
    around = radii[:, None] * np.stack([np.cos(angles), np.sin(angles)], axis=-1)
    return around[:: rng.choice([-1, 1])]


def _pocket(rng):
    """Draw a box without its lid, turned by any angle."""
    wall = rng.uniform(0.02, 0.6)
    outer = [[-1, 1], [-1, -1], [1, -1], [1, 1]]
    inner = [[1 - wall, 1], [1 - wall, wall - 1], [wall - 1, wall - 1], [wall - 1, 1]]
    angle = rng.uniform(0, 2 * np.pi)
    turn = np.array([[np.cos(angle), np.sin(angle)], [-np.sin(angle), np.cos(angle)]])
    return np.array(outer + inner) @ turn / np.sqrt(2)


def _powers(rng, low, high):
    """Draw between two sizes, each order of magnitude as likely as another."""
    return float(low * (high / low) ** rng.random())
