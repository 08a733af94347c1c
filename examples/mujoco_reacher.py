"""MuJoCo's Reacher: two compliant joints follow trajectories, so that its fingertip moves.

Needs MuJoCo: ``pip install 'divbandit[mujoco]'``. Nothing is rendered.
"""

from functools import partial

import gymnasium
import numpy as np

import divbandit as db
from divbandit.environments.mujoco import fingertip, reacher_positions, reacher_velocities

# A command is ten weights and two goals of movement primitives, whose trajectories of 50 steps are
# followed by springs and dampers that are weak. `divbandit.environments.mujoco.reacher(primitives)`
# is the same, ready-made.
primitives = db.controllers.MovementPrimitives(2, basis=5, steps=50)
controller = db.controllers.Tracking(
    primitives,
    reacher_positions,
    reacher_velocities,
    dt=0.02,
    stiffness=0.03,
    damping=0.03,
    turns=True,
)
make = partial(gymnasium.make, "Reacher-v5", reward_control_weight=0.0)
reachable = db.Box([-0.21, -0.21], [0.21, 0.21])

with db.environments.GymnasiumEnvironment(
    make, controller, fingertip, 50, seed=0, sensory_space=reachable
) as reacher:
    babblings = [db.MotorBabbling(), db.GoalBabbling(0.05), db.GoalBabbling(0.2)]
    adapt = db.Adapt(babblings, tau=0.01)
    names = ("motor babbling", "goals, d = 0.05", "goals, d = 0.20", "ADAPT")
    for name, strategy in zip(names, [*babblings, adapt], strict=True):
        run = db.explore(reacher, strategy, n=300, rng=0)
        print(f"{name:16} covers {1e4 * run.coverage(0.01)[-1]:.0f} cm2")
print("ADAPT chose each of the three:", np.bincount(run.choices, minlength=3))
