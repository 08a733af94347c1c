"""Any program can be explored: here a pendulum whose simulator is a program of its own.

The motor command is written onto the program's command line - when to push, how hard, how long -
and what the program prints, as JSON, is the effect: the angle and the speed in the end. The
program may be written in any language; each evaluation is a process, and four run at once.
"""

import sys
import tempfile
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

import divbandit as db

SIMULATOR = """
import json, math, sys

after, torque, length = map(float, sys.argv[1:])
if torque > 2.0 and length > 0.8:
    sys.exit("the motor is too hot")
angle, speed, dt = 0.0, 0.0, 0.01
for step in range(200):
    pushed = torque if after <= step * dt < after + length else 0.0
    speed += dt * (pushed - math.sin(angle) - 0.1 * speed)
    angle += dt * speed
print(json.dumps({"state": [angle, speed], "energy": speed * speed / 2 - math.cos(angle)}))
"""

motor_space = db.Box([0.0, -3.0, 0.0], [1.0, 3.0, 1.0])  # seconds, newton metres, seconds
sensory_space = db.Box([-3.0, -3.0], [3.0, 3.0])  # radians, radians a second

with tempfile.TemporaryDirectory() as folder, ThreadPoolExecutor(4) as executor:
    path = Path(folder, "pendulum.py")
    path.write_text(SIMULATOR, encoding="utf-8")
    words = [sys.executable, "-S", str(path)]
    pendulum = db.environments.ProcessEnvironment(
        words, motor_space, sensory_space, timeout=60, entry="state"
    )
    strategy = db.Adapt([db.MotorBabbling(), db.GoalBabbling(0.1)], tau=0.2)
    options = {"executor": executor, "in_flight": 4, "on_error": "record"}
    run = db.explore(pendulum, strategy, 200, rng=0, **options)

print(f"{len(run.effects)} effects cover {run.coverage(0.2)[-1]:.2f}")
print(f"{len(run.failures)} failed, the last with {run.failures[-1].reason}")
