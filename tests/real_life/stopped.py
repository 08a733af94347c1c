"""Runs that Ctrl-C ends, again and again: a program.

``python -m tests.real_life.stopped WHERE TIMES FOLDER`` prints "begun" when a run begins, and
"over" when it has ended, by an interruption. All that was told must be there.
"""

import sys
import threading
import time
from multiprocessing import active_children
from pathlib import Path

import numpy as np

import divbandit as db

ARM = db.PlanarArm(4)
#: For each place, seconds that an evaluation takes, and options.
PLACES = {
    "engine": (0, {}),
    "here": (0.005, {}),
    "batches": (0.002, {"batch": 3}),
    "jobs": (0.02, {"jobs": 2}),
    "jobs, long": (60, {"jobs": 2}),
}


def say(word):
    sys.stdout.write(f"{word}\n")
    sys.stdout.flush()


def slow(seconds):
    def box(command):
        end = time.monotonic() + seconds
        while time.monotonic() < end:
            time.sleep(0.001)
        return ARM(command)

    return db.FunctionEnvironment(box, ARM.motor_space, ARM.sensory_space)


def adapt():
    return db.Adapt([db.MotorBabbling(), db.GoalBabbling(0.05)])


def one(where, path):
    """Run until interrupted; check that all that was told is there, also in the file."""
    seconds, options = PLACES[where]
    box = slow(seconds) if seconds else ARM
    explorer = db.Explorer(adapt(), ARM.motor_space, ARM.sensory_space, rng=0)
    told = []
    watch = [] if where == "engine" else [lambda _, trial: told.append(trial.command.tolist())]
    try:
        say("begun")
        explorer.run(box, 10**7, callbacks=watch, checkpoint=path, every="20ms", **options)
    except KeyboardInterrupt as error:
        if getattr(error, "explorer", None) not in (explorer, None):
            raise AssertionError from None
    say("over")
    if told:
        assert explorer.history.commands[: len(told)].tolist() == told
    assert explorer.evaluations - len(told) in (0, 1) or where == "engine"
    np.testing.assert_array_equal(explorer.history.effects, ARM(explorer.history.commands))
    known = explorer.evaluations
    explorer.run(ARM, 5, checkpoint=path)
    again = db.Explorer.load(path)
    assert again.evaluations == known + 5 == len(again.history)


def many():
    """The same for many explorations at once."""
    box = slow(0.005)
    tasks = (db.experiments.Task(env, adapt(), n=10**6) for env in [box, ARM] * 10)
    try:
        say("begun")
        list(db.explore_many(tasks, rng=0, jobs=2))
    except KeyboardInterrupt:
        pass
    say("over")


def main(where, times, folder):
    for index in range(times):
        one(where, Path(folder) / str(index)) if where in PLACES else many()
        assert threading.enumerate() == [threading.main_thread()]
        assert active_children() == []
    say("done")


if __name__ == "__main__":
    main(sys.argv[1], int(sys.argv[2]), sys.argv[3])
