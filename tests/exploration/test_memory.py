"""What an exploration in Rust needs in memory beyond its log: a bounded number of bytes a step."""

import subprocess
import sys

import pytest

pytestmark = pytest.mark.skipif(sys.platform != "linux", reason="reads /proc, as on Linux")

N = 300_000
JOINTS = 20

# Of the log, each number takes 8 bytes: the coordinates of a command and of an effect, a choice at
# each level of a path, and an estimate of each strategy of the bandit.
NUMBER = 8
COMMAND, EFFECT, LEVEL, ESTIMATES = JOINTS * NUMBER, 2 * NUMBER, NUMBER, 2 * NUMBER

ADAPT = "db.Adapt([db.MotorBabbling(), db.GoalBabbling(0.05)], tau={tau!r})"
BABBLING = "db.MotorBabbling()"

# A short exploration comes first and loads what any needs. VmHWM is the most that the process has
# held; it is set back to what it holds, as imports have held a megabyte more for a while, in which
# an exploration's first bytes would not show. getrusage's ru_maxrss would begin at what its parent
# held.
SCRIPT = """
import re
from pathlib import Path
import divbandit as db

def peak():
    return 1024 * int(re.search(r"VmHWM:\\s*(\\d+) kB", Path("/proc/self/status").read_text())[1])

arm = db.PlanarArm({joints})
strategy = {strategy}
db.explore(arm, strategy, 10, rng=0, engine="rust", keep_commands={keep})
Path("/proc/self/clear_refs").write_text("5")
before = peak()
run = db.explore(arm, strategy, {n}, rng=1, engine="rust", keep_commands={keep})
print((peak() - before) / len(run))
"""


def bytes_a_step(strategy, *, keep):
    """Return what an exploration adds to the peak of a process of its own, in bytes a step."""
    script = SCRIPT.format(joints=JOINTS, strategy=strategy, n=N, keep=keep)
    command = [sys.executable, "-c", script]
    done = subprocess.run(command, check=True, capture_output=True, text=True)  # noqa: S603
    return float(done.stdout)


# The effects of the paper's tau overlap many times; discs of 5e-5 hardly do, and most have a cell
# of the plane's grid each.
@pytest.mark.parametrize("tau", [0.02, 5e-5])
def test_at_most_200_bytes_a_step_beyond_the_log(tau):
    log = COMMAND + EFFECT + LEVEL + ESTIMATES
    needed = bytes_a_step(ADAPT.format(tau=tau), keep=True)
    assert log <= needed <= log + 200


def test_at_most_60_bytes_a_step_in_all_without_commands():
    """Motor babbling asks for no nearest effect and no gain, and its path has no level."""
    assert EFFECT <= bytes_a_step(BABBLING, keep=False) <= 60
