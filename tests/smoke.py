"""A first use of an installed wheel, with NumPy and nothing else beside it.

Run as a script by an interpreter that cannot see the sources: ``python -I tests/smoke.py``.
"""

import importlib.util
import pathlib
import subprocess
import sys

import numpy as np

import divbandit as db

assert "site-packages" in db.__file__, db.__file__
assert (pathlib.Path(db.__file__).parent / "py.typed").exists()
assert importlib.util.find_spec("matplotlib") is None

adapt = db.Adapt([db.MotorBabbling(), db.GoalBabbling(0.05)], tau=0.02)
run = db.explore(db.PlanarArm(20), adapt, n=1000, rng=0)
assert run.effects.shape == (1000, 2)
assert abs(run.coverage(0.02)[-1] - db.coverage(run.effects, 0.02)) < 1e-12
task = db.experiments.Task(db.PlanarArm(20), adapt, n=1000)
many = dict(db.explore_many(task.over(range(4)), keep=lambda one: one.effects, jobs=2))
assert np.array_equal(many[0], run.effects)
run.save("smoke.npz")
again = db.Exploration.load("smoke.npz")
assert np.array_equal(again.commands, run.commands)

try:
    db.plot.spread(run)
except ImportError as error:
    assert "divbandit[plot]" in str(error), error  # noqa: PT017 - no pytest here
else:
    raise AssertionError("plots work without matplotlib?")

command = pathlib.Path(sys.executable).with_name("divbandit")
told = subprocess.run([command, "reproduce"], capture_output=True, text=True, check=False)  # noqa: S603
assert told.returncode == 1, told
assert "divbandit[cli]" in told.stderr, told
print("smoke test passed")
