"""A loop that asks, tells and saves after each step, to be killed: run as a program.

``python -m tests.exploration.robot FILE STEPS`` goes on where FILE left off, until STEPS
evaluations are known, and prints a line after each.
"""

import hashlib
import sys
import time
from pathlib import Path

import divbandit as db

ARM = db.PlanarArm(7)


class Drifting(db.Strategy):
    """One of a user's own, with a state that depends on all that it did and was told."""

    def __init__(self):
        self.at = 0.0

    def propose(self, history, rng):
        self.at = 0.9 * self.at + 0.1 * rng.random()
        return history.motor_space.low * self.at

    def observe(self, trial, effect):
        del trial
        self.at *= 1 - 0.1 * abs(float(effect[0]))


def strategy():
    parts = [db.MotorBabbling(), db.GoalBabbling(0.05), Drifting()]
    return db.Schedule([(5, db.MotorBabbling()), (None, db.Adapt(parts, window=20))])


def digest(explorer):
    """Return a word for all that an exploration is, and will be."""
    run = explorer.result()
    parts = [run.commands, run.effects, run.paths, run.estimates]
    words = [
        repr(explorer.rng.bit_generator.state),
        repr(explorer.strategy.strategies[1].estimates),
    ]
    words += [repr((f.command.tolist(), *f[1:])) for f in run.failures]
    words += [repr((t.number, t.command.tolist())) for t in explorer.open_trials]
    data = b"".join(b"-" if part is None else part.tobytes() for part in parts)
    return hashlib.sha256(data + "".join(words).encode()).hexdigest()


def main(path, steps):
    if Path(path).exists():
        explorer = db.Explorer.load(path, strategy())
    else:
        explorer = db.Explorer(strategy(), ARM.motor_space, ARM.sensory_space, rng=0)
    history = explorer.history
    while len(history) + len(history.failures) < steps:
        # Three under way, of which the youngest but one is told: late, and out of order.
        while len(explorer.open_trials) < 3:
            explorer.ask()
        trial = explorer.open_trials[1]
        if trial.number % 7 == 3:
            explorer.fail(trial, f"slipped after {len(history)}")
        else:
            explorer.tell(trial, ARM(trial.command))
        explorer.save(path)
        time.sleep(0.002)  # time enough to kill it
        sys.stdout.write(f"{len(history) + len(history.failures)}\n")
        sys.stdout.flush()
    sys.stdout.write(f"{digest(explorer)}\n")


if __name__ == "__main__":
    main(sys.argv[1], int(sys.argv[2]))
