"""A user-defined black box, and ADAPT over a user-defined strategy and others."""

import numpy as np

import divbandit as db


def stroke(command):
    """Return where a ball stops that is hit with some speed, angle and spin."""
    speed, angle, spin = command
    turned = angle + spin * speed
    return speed**2 * np.array([np.cos(turned), np.sin(turned)])


lawn = db.FunctionEnvironment(stroke, db.Box([0, -1, -1], [1, 1, 1]), db.Box([0, -1], [1, 1]))


class Farther(db.Strategy):
    """Repeat the command that went farthest, with one coordinate drawn again."""

    best, distance = None, 0.0

    def propose(self, history, rng):
        """Draw a command; keep all but one coordinate of the best, once there is one."""
        command = history.motor_space.sample(rng)
        changed = np.arange(3) == int(3 * rng.random())
        return command if self.best is None else np.where(changed, command, self.best)

    def observe(self, trial, effect):
        """Remember the command that went farthest."""
        if np.hypot(*effect) > self.distance:
            self.best, self.distance = trial.command, np.hypot(*effect)


alone = {"motor babbling": db.MotorBabbling(), "goals": db.GoalBabbling(), "farther": Farther()}
for name, strategy in {**alone, "ADAPT": db.Adapt(alone.values(), tau=0.05)}.items():
    run = db.explore(lawn, strategy, n=1000, rng=0)
    print(f"{name:14} covers {run.coverage(0.05)[-1]:.2f}")
print("ADAPT chose each of the three:", np.bincount(run.choices))
