"""A run with a checkpoint after each evaluation, to be killed: a program.

``python -m tests.real_life.killed FILE N JOBS`` goes on where FILE left off, until N evaluations
are known. It prints the number of each trial when it has been told, and what it is in the end.
"""

import sys
import time
from pathlib import Path

import divbandit as db
from tests.exploration.robot import ARM, digest, strategy


def box(command):
    time.sleep(0.002)
    if command[0] > 2:
        raise ValueError("slipped")
    return ARM(command)


def say(word):
    sys.stdout.write(f"{word}\n")
    sys.stdout.flush()


def main(path, n, jobs):
    if path.exists():
        explorer = db.Explorer.load(path, strategy())
    else:
        explorer = db.Explorer(strategy(), ARM.motor_space, ARM.sensory_space, rng=0)
    environment = db.FunctionEnvironment(box, ARM.motor_space, ARM.sensory_space)
    explorer.run(
        environment,
        n - explorer.evaluations,
        jobs=jobs or None,
        on_error="record",
        callbacks=[lambda _, trial: say(trial.command[0].hex())],
        checkpoint=path,
        every=1,
    )
    say(digest(explorer))


if __name__ == "__main__":
    main(Path(sys.argv[1]), int(sys.argv[2]), int(sys.argv[3]))
