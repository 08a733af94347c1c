"""Two arms of MuJoCo as black boxes: Gymnasium's Reacher and its Pusher, driven by primitives.

Needs MuJoCo: ``pip install 'divbandit[mujoco]'``. The simulations are deterministic, but another
version of MuJoCo or another processor may well compute other effects.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from divbandit._library import library
from divbandit.box import Box
from divbandit.controllers import Tracking, ViaPoints
from divbandit.environments.gymnasium import GymnasiumEnvironment

if TYPE_CHECKING:
    from typing import Literal

    from numpy.typing import NDArray

    from divbandit.controllers import Trajectories
    from divbandit.environments.episode import Episode

#: How long a step of each takes, in seconds, and how many they have.
REACHER_DT, REACHER_STEPS = 0.02, 50
PUSHER_DT, PUSHER_STEPS = 0.05, 100

#: Between which angles the Pusher's seven joints are led, in radians: about the half of what
#: their limits allow, in front of it and down to the table.
PUSHER_LOW = (-1.0, 0.0, -0.5, -1.5, -0.5, -1.0, -1.0)
PUSHER_HIGH = (1.5, 1.3, 0.5, 0.0, 0.5, 0.0, 1.0)

#: In N m a radian and N m s a radian; the farther down the arm, the less there is to move.
PUSHER_STIFFNESS = (10.0, 10.0, 2.0, 5.0, 1.5, 1.5, 1.5)
PUSHER_DAMPING = (3.0, 3.0, 0.4, 0.8, 0.25, 0.25, 0.25)

#: With this seed the object stands 0.73 m from the Pusher's shoulder, at (0.645, -0.252).
PUSHER_SEED = 8


def reacher(
    primitives: Trajectories | None = None,
    *,
    envs: int = 1,
    vector: Literal["sync", "async"] = "sync",
) -> GymnasiumEnvironment:
    """Return Reacher-v5 as a black box: where two soft joints have led the fingertip in a second.

    Weak springs and dampers pull the joints along a trajectory; they come late and cut corners,
    so that where the fingertip is at the end depends on all of the way there.

    Parameters
    ----------
    primitives : object with ``motor_space`` and ``trajectory(command)``, optional
        Makes trajectories of two joints, in radians, a row each 0.02 s. Without one, `ViaPoints`
        through five points in [-pi, pi] x [-2.8, 2.8].
    envs, vector
        As those of `GymnasiumEnvironment`.

    Returns
    -------
    GymnasiumEnvironment
        Effects are the fingertip's (x, y) in metres; the arm is 0.21 m long.

    Raises
    ------
    ModuleNotFoundError
        If MuJoCo or Gymnasium is not installed.
    TypeError, ValueError
        If an argument is not what it must be.

    Examples
    --------
    >>> import numpy as np
    >>> from divbandit.environments.mujoco import reacher
    >>> with reacher() as environment:
    ...     tip = environment(np.tile([np.pi / 2, 0.0], 5))  # up, and stay there
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
        stiffness=0.03,  # of the motors' largest torque, 200 N m, for each radian
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
        envs=envs,
        vector=vector,
    )


def pusher(
    primitives: Trajectories | None = None,
    *,
    envs: int = 1,
    vector: Literal["sync", "async"] = "sync",
) -> GymnasiumEnvironment:
    """Return Pusher-v5 as a black box: where the object is after five seconds of an arm's motion.

    The arm of seven joints begins stretched out above the table. Two of three random commands
    miss the object. It yields to a gripper that passes quickly, and is carried along by one that
    goes on slowly, up to 15 cm.

    Parameters
    ----------
    primitives : object with ``motor_space`` and ``trajectory(command)``, optional
        Makes trajectories of seven joints, in radians, a row each 0.05 s; they should start at 0.
        Without one, `ViaPoints` through two points, from `PUSHER_LOW` to `PUSHER_HIGH`.
    envs, vector
        As those of `GymnasiumEnvironment`.

    Returns
    -------
    GymnasiumEnvironment
        Effects are the object's (x, y) in metres; the sensory space is a square around where it
        stands.

    Raises
    ------
    ModuleNotFoundError
        If MuJoCo or Gymnasium is not installed.
    TypeError, ValueError
        If an argument is not what it must be.

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
        envs=envs,
        vector=vector,
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
    """Return the velocities of Reacher's two joints, in radians a second.

    Examples
    --------
    >>> import numpy as np
    >>> reacher_velocities(np.arange(10.0))
    array([6., 7.])
    """
    return observation[6:8]


def fingertip(episode: Episode) -> NDArray[np.float64]:
    """Return where Reacher's fingertip was last, (x, y) in metres.

    It is observed relative to the target, which is observed as well.

    Examples
    --------
    >>> import numpy as np
    >>> import divbandit as db
    >>> last = np.array([0, 0, 0, 0, 0.1, -0.1, 0, 0, 0.05, 0.2])
    >>> fingertip(db.Episode(last[None], np.zeros(0), np.zeros(0), False, False, {})).round(12)
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
    """Return the velocities of Pusher's seven joints, in radians a second.

    Examples
    --------
    >>> import numpy as np
    >>> pusher_velocities(np.arange(23.0))
    array([ 7.,  8.,  9., 10., 11., 12., 13.])
    """
    return observation[7:14]


def pushed_object(episode: Episode) -> NDArray[np.float64]:
    """Return where Pusher's object was last, (x, y) in metres.

    Examples
    --------
    >>> import numpy as np
    >>> import divbandit as db
    >>> last = np.arange(23.0)
    >>> pushed_object(db.Episode(last[None], np.zeros(0), np.zeros(0), False, False, {}))
    array([17., 18.])
    """
    last: NDArray[np.float64] = episode.observations[-1]
    return last[17:19]
