"""Ctrl-C at random moments inside `ask`, `tell`, `run` and the rest, caught: a program.

``python -m tests.real_life.pressed ENGINE MOMENTS SEED FOLDER``. Another process presses it. After
every few dozen trials the explorer is saved (or `run` has written a checkpoint) and loaded, and
both go on: to the same bits.
"""

import random
import signal
import subprocess
import sys
from contextlib import contextmanager
from pathlib import Path

import divbandit as db
from tests.exploration.robot import Drifting
from tests.exploration.sameness import everything

ARM = db.PlanarArm(4)


def fragile(command):
    if command[0] > 2:
        raise ValueError("no")
    return ARM(command)


FRAGILE = db.FunctionEnvironment(fragile, ARM.motor_space, ARM.sensory_space)

#: Sends SIGINT at random moments until it is ended, or the process that it works for has.
PRESS = """
import os, random, signal, sys, time
chance, parent = random.Random(int(sys.argv[1])), os.getppid()
while os.getppid() == parent:
    time.sleep(0.0005 + chance.random() * 0.002)
    os.kill(parent, signal.SIGINT)
"""


def strategies(engine):
    """Return some: those of the library, or with one of a user's among them."""
    parts = [db.MotorBabbling(), db.GoalBabbling(0.05)]
    if engine == "mine":
        parts.append(Drifting())
    return db.Schedule([(3, db.MotorBabbling()), (None, db.Adapt(parts, window=20))])


def live(explorer, chance, path):
    """Ask for one or many, tell late and in any order, singly and in lists, fail and save."""
    while explorer.evaluations < 60:
        for _ in range(chance.randrange(1, 4)):
            explorer.ask()
        explorer.ask(2)
        under_way = list(explorer.open_trials)
        chance.shuffle(under_way)
        done = under_way[: chance.randrange(1, 6)]
        if chance.random() < 0.3:
            explorer.tell(done, [ARM(trial.command) for trial in done])
        else:
            for trial in done:
                if chance.random() < 0.2:
                    explorer.fail(trial, f"reason {trial.number}")
                else:
                    explorer.tell(trial, ARM(trial.command))
        if chance.random() < 0.1:
            explorer.add_past([[0.1] * 4, [0.2] * 4], [[0.5, 0.5], [0.25, 0.5]])
        if chance.random() < 0.1:
            explorer.save(path)


def run(explorer, path):
    """Run with a checkpoint, in Rust and in Python, with failures."""
    while (left := 60 - explorer.evaluations) > 0:
        explorer.run(ARM, min(left, 10), checkpoint=path, every=3)
        left = max(1, 60 - explorer.evaluations)
        explorer.run(FRAGILE, left, checkpoint=path, every=1, on_error="record")


class Ear:
    """What hears Ctrl-C, once at a time: what follows is not interrupted again."""

    def __init__(self):
        self.listens = False
        signal.signal(signal.SIGINT, self.hear)

    def hear(self, *_):
        if self.listens:
            self.listens = False
            raise KeyboardInterrupt

    def interrupted(self, work):
        """Do something until it ends by itself; return how often it was interrupted."""
        heard = 0
        while True:
            try:
                self.listens = True
                work()
                self.listens = False
            except KeyboardInterrupt:
                heard += 1
            else:
                return heard


@contextmanager
def pressing(seed):
    command = [sys.executable, "-c", PRESS, str(seed)]
    with subprocess.Popen(command) as process:  # noqa: S603
        try:
            yield
        finally:
            process.kill()


def main(engine, moments, seed, folder):
    chance, path = random.Random(seed), Path(folder) / "run"  # noqa: S311
    heard, files, ear = 0, 0, Ear()
    with pressing(seed):
        while heard < moments:
            explorer = db.Explorer(
                strategies(engine),
                ARM.motor_space,
                ARM.sensory_space,
                rng=files,
                engine="auto" if engine == "mine" else engine,
            )
            if files % 2:
                heard += ear.interrupted(lambda e=explorer: run(e, path))
                explorer.run(
                    ARM, 1, checkpoint=path
                )  # the last Ctrl-C may have come before a block
            else:
                heard += ear.interrupted(lambda e=explorer: live(e, chance, path))
                explorer.save(path)
            again = db.Explorer.load(path, strategies(engine))
            assert everything(again) == everything(explorer)
            for each in (explorer, again):
                for _ in range(20):
                    trial = each.ask()
                    each.tell(trial, ARM(trial.command))
            assert everything(again) == everything(explorer)
            files += 1
    assert [file.name for file in Path(folder).iterdir()] == ["run"]
    sys.stdout.write(f"{heard} times, {files} files\n")


if __name__ == "__main__":
    main(sys.argv[1], int(sys.argv[2]), int(sys.argv[3]), sys.argv[4])
