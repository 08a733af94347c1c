"""Two arms of MuJoCo as black boxes: Gymnasium's Reacher and Pusher, driven by primitives.

Needs MuJoCo: ``pip install 'divbandit[mujoco]'``. The simulations are deterministic, but effects
may differ between versions of MuJoCo and between processors.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from divbandit._library import library
from divbandit.box import Box
from divbandit.controllers import Tracking, ViaPoints
from divbandit.environments.gymnasium import GymnasiumEnvironment

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from divbandit.controllers import Trajectories
    from divbandit.environments.episode import Episode

#: The duration of a step in seconds, and the number of steps.
REACHER_DT, REACHER_STEPS = 0.02, 50
PUSHER_DT, PUSHER_STEPS = 0.05, 100

#: The angles of the Pusher's seven joints, in radians, lie between these: about half of the range
#: that the joints allow, in front of the arm and down to the table.
PUSHER_LOW = (-1.0, 0.0, -0.5, -1.5, -0.5, -1.0, -1.0)
PUSHER_HIGH = (1.5, 1.3, 0.5, 0.0, 0.5, 0.0, 1.0)

#: In N m per radian and N m s per radian; the joints near the gripper move less mass.
PUSHER_STIFFNESS = (10.0, 10.0, 2.0, 5.0, 1.5, 1.5, 1.5)
PUSHER_DAMPING = (3.0, 3.0, 0.4, 0.8, 0.25, 0.25, 0.25)

#: With this seed the object is 0.73 m from the Pusher's shoulder, at (0.645, -0.252).
PUSHER_SEED = 8


def reacher(primitives: Trajectories | None = None) -> GymnasiumEnvironment:
    """Return Reacher-v5 as a black box: where two joints lead the fingertip in a second.

    Weak springs and dampers pull the joints along a trajectory. The joints lag behind and cut
    corners, so that the final position of the fingertip depends on the whole trajectory.

    Parameters
    ----------
    primitives : object with ``motor_space`` and ``trajectory(command)``, optional
        Makes trajectories of two joints, in radians, one row per 0.02 s. By default, `ViaPoints`
        through five points in [-pi, pi] x [-2.8, 2.8].

    Returns
    -------
    GymnasiumEnvironment
        Effects are the position (x, y) of the fingertip in metres; the arm is 0.21 m long.

    Raises
    ------
    ModuleNotFoundError
        If MuJoCo or Gymnasium is not installed.
    TypeError, ValueError
        If `primitives` is not what it must be.

    Examples
    --------
    >>> import numpy as np
    >>> from divbandit.environments.mujoco import reacher
    >>> with reacher() as environment:
    ...     tip = environment(np.tile([np.pi / 2, 0.0], 5))  # move up and stay there
    >>> environment.motor_space.dim, bool(tip[1] > 0.15)
    (10, True)
    """
    library("mujoco", user="reacher")
    if primitives is None:
        far = (np.pi, 2.8)
        primitives = ViaPoints(np.negative(far), far, steps=REACHER_STEPS, points=5)
    tracking = Tracking(
        primitives,
        reacher_positions,
        reacher_velocities,
        dt=REACHER_DT,
        stiffness=0.03,  # of the largest torque, 200 N m, per radian
        damping=0.03,
        turns=True,
    )
    return GymnasiumEnvironment(
        "Reacher-v5",
        tracking,
        fingertip,
        REACHER_STEPS,
        seed=0,
        sensory_space=Box([-0.21, -0.21], [0.21, 0.21]),
    )


def pusher(primitives: Trajectories | None = None) -> GymnasiumEnvironment:
    """Return Pusher-v5 as a black box: where an arm's motion of five seconds moves an object.

    The arm has seven joints and is initially stretched out above the table. Two of three random
    commands miss the object. A fast gripper pushes it aside; a slow one carries it along, up to
    15 cm.

    Parameters
    ----------
    primitives : object with ``motor_space`` and ``trajectory(command)``, optional
        Makes trajectories of seven joints, in radians, one row per 0.05 s; they should start at 0.
        By default, `ViaPoints` through two points between `PUSHER_LOW` and `PUSHER_HIGH`.

    Returns
    -------
    GymnasiumEnvironment
        Effects are the final position (x, y) of the object in metres; the sensory space is a
        square around its initial position.

    Raises
    ------
    ModuleNotFoundError
        If MuJoCo or Gymnasium is not installed.
    TypeError, ValueError
        If `primitives` is not what it must be.

    Examples
    --------
    >>> import numpy as np
    >>> from divbandit.environments.mujoco import pusher
    >>> with pusher() as environment:
    ...     still = environment(np.zeros(14))
    >>> still.round(3)
    array([ 0.645, -0.252])
    """
    library("mujoco", user="pusher")
    if primitives is None:
        primitives = ViaPoints(PUSHER_LOW, PUSHER_HIGH, steps=PUSHER_STEPS, points=2)
    tracking = Tracking(
        primitives,
        pusher_positions,
        pusher_velocities,
        dt=PUSHER_DT,
        stiffness=PUSHER_STIFFNESS,
        damping=PUSHER_DAMPING,
    )
    return GymnasiumEnvironment(
        "Pusher-v5",
        tracking,
        pushed_object,
        PUSHER_STEPS,
        seed=PUSHER_SEED,
        sensory_space=Box([0.45, -0.45], [0.85, -0.05]),
    )


def reacher_positions(observation: NDArray[np.float64]) -> NDArray[np.float64]:
    """Return Reacher's two joint angles in radians, in (-pi, pi].

    Examples
    --------
    >>> import numpy as np
    >>> reacher_positions(np.array([0.0, 1.0, 1.0, 0.0, 0, 0, 0, 0, 0, 0])).round(3)
    array([1.571, 0.   ])
    """
    angles: NDArray[np.float64] = np.arctan2(observation[2:4], observation[:2])
    return angles


def reacher_velocities(observation: NDArray[np.float64]) -> NDArray[np.float64]:
    """Return the velocities of Reacher's two joints, in radians per second.

    Examples
    --------
    >>> import numpy as np
    >>> reacher_velocities(np.arange(10.0))
    array([6., 7.])
    """
    return observation[6:8]


def fingertip(episode: Episode) -> NDArray[np.float64]:
    """Return the final position (x, y) of Reacher's fingertip in metres.

    Observations hold its position relative to the target, and the position of the target.

    Examples
    --------
    >>> import numpy as np
    >>> from divbandit.environments import Episode
    >>> last = np.array([0, 0, 0, 0, 0.1, -0.1, 0, 0, 0.05, 0.2])
    >>> fingertip(Episode(last[None], np.zeros(0), np.zeros(0), False, False, {})).round(12)
    array([0.15, 0.1 ])
    """
    last: NDArray[np.float64] = episode.observations[-1]
    tip: NDArray[np.float64] = last[4:6] + last[8:10]
    return tip


def pusher_positions(observation: NDArray[np.float64]) -> NDArray[np.float64]:
    """Return the angles of Pusher's seven joints, in radians.

    Examples
    --------
    >>> import numpy as np
    >>> pusher_positions(np.arange(23.0))
    array([0., 1., 2., 3., 4., 5., 6.])
    """
    return observation[:7]


def pusher_velocities(observation: NDArray[np.float64]) -> NDArray[np.float64]:
    """Return the velocities of Pusher's seven joints, in radians per second.

    Examples
    --------
    >>> import numpy as np
    >>> pusher_velocities(np.arange(23.0))
    array([ 7.,  8.,  9., 10., 11., 12., 13.])
    """
    return observation[7:14]


def pushed_object(episode: Episode) -> NDArray[np.float64]:
    """Return the final position (x, y) of Pusher's object in metres.

    Examples
    --------
    >>> import numpy as np
    >>> from divbandit.environments import Episode
    >>> last = np.arange(23.0)
    >>> pushed_object(Episode(last[None], np.zeros(0), np.zeros(0), False, False, {}))
    array([17., 18.])
    """
    last: NDArray[np.float64] = episode.observations[-1]
    return last[17:19]
