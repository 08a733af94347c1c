"""A robot tries one trial at a time; the program dies half-way, and the next one resumes.

The robot may fall, which makes the trial a failure. After each trial the explorer is saved; the
next program continues as the first would have, bit by bit.
"""

import tempfile
from pathlib import Path

import divbandit as db

arm = db.PlanarArm(7)
strategy = db.Adapt([db.MotorBabbling(), db.GoalBabbling(0.05)], tau=0.05)


class FallError(Exception):
    """The robot has fallen."""


def try_on_robot(command):
    """Stand in for a robot: it falls where its first two joints both bend far to the left."""
    if min(command[:2]) > 1.0:
        raise FallError("the robot fell")
    return arm(command)


def one_trial(explorer, trial):
    """Try one command, and tell what came of it."""
    try:
        explorer.tell(trial, try_on_robot(trial.command))
    except FallError as error:
        explorer.fail(trial, str(error))


with tempfile.TemporaryDirectory() as folder:
    path = Path(folder, "exploration")
    explorer = db.Explorer(strategy, arm.motor_space, arm.sensory_space, rng=0)
    for _ in range(60):
        trial = explorer.ask()
        explorer.save(path)
        one_trial(explorer, trial)
    del explorer  # the power fails: the last trial is still open in the file

    explorer = db.Explorer.load(path)
    print(f"loaded {len(explorer.history)} effects, {len(explorer.open_trials)} trial under way")
    for trial in explorer.open_trials:
        one_trial(explorer, trial)
    for _ in range(240):
        one_trial(explorer, explorer.ask())

    run = explorer.result()
    print(f"{len(run.effects)} effects cover {run.coverage(0.05)[-1]:.2f} m2")
    print(f"the robot fell {len(explorer.history.failures)} times of 300")
