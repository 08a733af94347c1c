"""Runs that are killed at random moments, also while a checkpoint is written, and gone on with."""

import random
import signal
import subprocess
import sys
import time
from pathlib import Path

import pytest

import divbandit as db
from tests.exploration.robot import strategy
from tests.real_life.boxes import is_running

N = 120

if not hasattr(signal, "SIGKILL"):
    pytest.skip("kill -9 is POSIX's", allow_module_level=True)


def start(path, jobs):
    words = [sys.executable, "-m", "tests.real_life.killed", str(path), str(N), str(jobs)]
    return subprocess.Popen(words, stdout=subprocess.PIPE, text=True)  # noqa: S603


@pytest.mark.parametrize("jobs", [0, 2])
def test_nothing_told_before_the_last_checkpoint_is_lost(jobs, tmp_path):
    kill(jobs, 6, tmp_path)


def kill(jobs, times, folder):
    """Kill a run some times, each a little later, and check what its file holds."""
    chance, path = random.Random(0), folder / "run"  # noqa: S311 - when is no secret
    told = []
    for index in range(times):
        begun = len(told)
        with start(path, jobs) as process:
            children = set()
            for line in process.stdout:
                told.append(line.strip())
                children |= children_of(process.pid)
                if len(told) >= min(begun + 1, N - 20) + index % 3:
                    break
            time.sleep(chance.random() * 0.008)
            process.send_signal(signal.SIGKILL)
            told += [line.strip() for line in process.stdout]
            process.wait()
        assert process.returncode == -signal.SIGKILL
        wait_for_the_end_of(children)
        known = known_in(path)
        # A line is written before the block: the last one may be missing.
        assert set(told[:-1]) <= set(known)
        told = known
    rest = start(path, jobs).communicate(timeout=120)[0].splitlines()
    assert len(known_in(path)) == N
    if jobs == 0:
        assert rest[-1] == start(folder / "whole", 0).communicate(timeout=120)[0].splitlines()[-1]


def known_in(path):
    history = db.Explorer.load(path, strategy()).history
    failed = [failure.command[0].hex() for failure in history.failures]
    return [x.hex() for x in history.commands[:, 0].tolist()] + failed


def children_of(number):
    try:
        return set(Path(f"/proc/{number}/task/{number}/children").read_text().split())
    except OSError:  # not Linux
        return set()


def wait_for_the_end_of(numbers):
    """Check that processes end, though their parent was killed."""
    end = time.monotonic() + 10
    while left := [number for number in numbers if is_running(int(number))]:
        assert time.monotonic() < end, left
        time.sleep(0.05)
