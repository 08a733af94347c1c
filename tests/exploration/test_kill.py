"""A loop that is killed at any moment, and goes on from its file, ends as if it never was."""

import os
import random
import signal
import subprocess
import sys
import time

import pytest

STEPS = 300
KILLS = 20


def start(path):
    return subprocess.Popen(  # noqa: S603 - our own program
        [sys.executable, "-m", "tests.exploration.robot", str(path), str(STEPS)],
        stdout=subprocess.PIPE,
        text=True,
    )


@pytest.mark.skipif(not hasattr(signal, "SIGKILL"), reason="kill -9 is POSIX's")
def test_killed_at_twenty_random_moments(tmp_path):
    whole = start(tmp_path / "whole")
    expected = whole.communicate(timeout=120)[0].splitlines()
    assert len(expected) == STEPS + 1

    chance = random.Random(0)  # noqa: S311 - when to kill is no secret
    moments = sorted(chance.sample(range(STEPS - 100), KILLS))
    path = tmp_path / "killed"
    killed = 0
    for moment in moments:
        robot = start(path)
        for line in robot.stdout:
            if int(line) >= moment:
                break
        # Anywhere in the steps that follow, also while the file is being written.
        time.sleep(chance.random() * 0.004)
        os.kill(robot.pid, signal.SIGKILL)
        robot.communicate()
        killed += robot.returncode == -signal.SIGKILL
    assert killed > KILLS / 2  # on a machine that is slow to kill, a robot may be done before
    rest = start(path).communicate(timeout=120)[0].splitlines()
    assert rest[-1] == expected[-1]
