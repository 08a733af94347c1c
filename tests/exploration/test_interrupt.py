"""Ctrl-C ends an exploration, wherever its steps are made; so does what is called in between."""

import signal
import subprocess
import sys
import time

import numpy as np
import pytest

import divbandit as db

#: Interrupted in the middle, it says whether what it holds is the beginning of another run.
SCRIPT = """
import divbandit as db
arm = db.PlanarArm(20)
adapt = db.Adapt([db.MotorBabbling(), db.GoalBabbling(0.05)])
class Mine:
    motor_space, sensory_space = arm.motor_space, arm.sensory_space
    def __call__(self, command):
        return arm(command)
try:
    print("begun", flush=True)
    db.explore({environment}, adapt, 3 * 10**7, rng=0, engine={engine!r}, keep_commands=False)
except KeyboardInterrupt as error:
    history = error.explorer.history
    begun = db.explore(arm, adapt, min(1000, len(history)), rng=0).effects
    same = begun.tolist() == history.effects[:1000].tolist()
    print("interrupted, with", "all" if same else "something else", flush=True)
"""


@pytest.mark.skipif(sys.platform == "win32", reason="no SIGINT for another process")
@pytest.mark.parametrize("environment", ["arm", "Mine()"])
@pytest.mark.parametrize("engine", ["python", "rust"])
def test_ctrl_c(engine, environment):
    """Thirty million steps would take minutes."""
    command = [sys.executable, "-c", SCRIPT.format(engine=engine, environment=environment)]
    with subprocess.Popen(command, stdout=subprocess.PIPE, text=True) as process:  # noqa: S603
        try:
            assert process.stdout.readline() == "begun\n"
            time.sleep(0.3)
            process.send_signal(signal.SIGINT)
            out, _ = process.communicate(timeout=30)
        except BaseException:
            process.kill()
            raise
    assert (process.returncode, out) == (0, "interrupted, with all\n")


@pytest.mark.parametrize("engine", ["python", "rust"])
def test_what_is_called_between_ends_it(engine):
    calls = []

    def between(explorer, trial):
        del explorer, trial
        calls.append(1)
        if len(calls) == 3:
            raise TimeoutError

    arm, rng = db.PlanarArm(20), np.random.default_rng(0)
    options = {"engine": engine, "callbacks": [db.callbacks.Every("50ms", between)]}
    with pytest.raises(TimeoutError):
        db.explore(arm, db.MotorBabbling(), 10**7, rng=rng, keep_commands=False, **options)
    assert len(calls) == 3
    assert 0 <= rng.random() < 1  # the generator is free again


@pytest.mark.parametrize("n", [2**62, 2**70])
def test_more_steps_than_memory_has_room_for(n):
    rng = np.random.default_rng(0)
    with pytest.raises(ValueError, match=r"^n must be .*, got"):
        db.explore(db.PlanarArm(20), db.MotorBabbling(), n, rng=rng, engine="rust")
    assert rng.random() == np.random.default_rng(0).random()
