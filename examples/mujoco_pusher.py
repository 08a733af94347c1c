"""MuJoCo's Pusher: an arm of seven joints above a table pushes an object.

Needs MuJoCo: ``pip install 'divbandit[mujoco]'``. Nothing is rendered.
"""

import numpy as np

import divbandit as db
from divbandit.environments.mujoco import pusher

# A command is three weights and a goal for each joint: movement primitives, five seconds long.
primitives = db.controllers.MovementPrimitives(7, basis=3, steps=100, weights=0.5)

with pusher(primitives) as environment:
    start = environment(np.zeros(environment.motor_space.dim))  # the arm stays where it is
    babblings = [db.MotorBabbling(), db.GoalBabbling(0.05)]
    strategies = {
        "motor babbling": babblings[0],
        "goals": db.Schedule([(30, db.MotorBabbling()), (None, babblings[1])]),
        "ADAPT": db.Adapt(babblings, tau=0.01),
    }
    for name, strategy in strategies.items():
        run = db.explore(environment, strategy, n=300, rng=0)
        moved = np.hypot(*(run.effects - start).T)
        print(
            f"{name:15} covers {1e4 * run.coverage(0.01)[-1]:.0f} cm2, pushed the object "
            f"{np.sum(moved > 0.001)} times of {len(run)}, up to {100 * moved.max():.0f} cm"
        )
