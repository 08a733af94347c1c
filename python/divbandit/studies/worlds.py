"""Worlds: five black boxes in which strategies differ."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

from divbandit.environments import Disc, PlanarArm, Polygon, PushArm, Rectangle, Wall
from divbandit.environments.mujoco import pusher

if TYPE_CHECKING:
    from divbandit.environments import Environment


@dataclass(frozen=True)
class World:
    """A black box to explore.

    Attributes
    ----------
    name : str
    environment : Environment
        With effects in the plane, in metres.
    tau : float
        Radius of what an effect covers, in metres.
    costs : int
        It is explored for one step where others are for so many.
    """

    name: str
    environment: Environment
    tau: float = 0.02
    costs: int = 1


def worlds() -> list[World]:
    """Return them, empty space first; needs ``pip install 'divbandit[mujoco]'``.

    Examples
    --------
    >>> [world.name for world in worlds()]
    ['empty space', 'corridor', 'cluttered room', 'pushing', 'MuJoCo Pusher']
    """
    return [
        World("empty space", PlanarArm(20)),
        World("corridor", PlanarArm(20, obstacles=corridor())),
        World("cluttered room", PlanarArm(20, obstacles=clutter())),
        World("pushing", PushArm(7)),
        World("MuJoCo Pusher", pusher(), tau=0.01, costs=20),
    ]


def corridor() -> list[Rectangle]:
    """Return a corridor along the arm at rest, 40 cm wide and open behind it.

    Examples
    --------
    >>> corridor()[0]
    Rectangle([-0.4, 0.2], [1.1, 0.3])
    """
    return [Rectangle([-0.4, 0.2], [1.1, 0.3]), Rectangle([-0.4, -0.3], [1.1, -0.2])]


def clutter() -> list[Disc | Polygon | Rectangle | Wall]:
    """Return a room 1.6 m wide with furniture in it.

    Examples
    --------
    >>> len(clutter())
    11
    """
    return [
        Wall([-0.8, -0.8], [1.2, -0.8], thickness=0.02),
        Wall([-0.8, 0.8], [1.2, 0.8], thickness=0.02),
        Wall([-0.8, -0.8], [-0.8, 0.8], thickness=0.02),
        Disc([0.45, 0.35], 0.06),
        Disc([0.15, 0.55], 0.05),
        Disc([-0.25, -0.3], 0.08),
        Disc([0.75, -0.45], 0.05),
        Rectangle([0.3, -0.35], [0.55, -0.25]),
        Rectangle([-0.55, 0.1], [-0.45, 0.45]),
        Polygon([[-0.2, 0.3], [0.05, 0.3], [0.05, 0.36], [-0.14, 0.36], [-0.14, 0.6], [-0.2, 0.6]]),
        Polygon([[0.05, -0.6], [0.2, -0.5], [0.1, -0.45]]),
    ]
