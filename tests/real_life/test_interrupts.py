"""Ctrl-C at random moments: nothing that was told is lost, and nothing runs on."""

import random
import select
import signal
import subprocess
import sys
import time

import pytest

from tests.real_life.stopped import PLACES

if sys.platform == "win32":
    pytest.skip("no SIGINT for another process", allow_module_level=True)

#: Seconds from Ctrl-C to the end of a run that does not hang, however busy the machine is.
SOON = 60.0


@pytest.mark.parametrize("engine", ["rust", "python", "mine"])
def test_caught_anywhere_and_gone_on_with(engine, tmp_path):
    press(engine, 150, tmp_path)


def press(engine, moments, folder):
    words = [
        sys.executable,
        "-m",
        "tests.real_life.pressed",
        engine,
        str(moments),
        "0",
        str(folder),
    ]
    done = subprocess.run(words, capture_output=True, text=True, check=False)  # noqa: S603
    assert (done.returncode, done.stderr) == (0, "")
    assert int(done.stdout.split()[0]) >= moments


@pytest.mark.parametrize("where", [*PLACES, "many"])
def test_a_run_ends_soon(where, tmp_path):
    assert max(stop(where, 4, tmp_path)) < SOON


def stop(where, times, folder):
    """Interrupt runs at random moments; return how long each took to end."""
    chance = random.Random(0)  # noqa: S311 - when is no secret
    words = [sys.executable, "-m", "tests.real_life.stopped", where, str(times), str(folder)]
    took = []
    with subprocess.Popen(words, stdout=subprocess.PIPE) as process:  # noqa: S603
        try:
            for _ in range(times):
                assert process.stdout.readline() == b"begun\n"
                time.sleep(chance.random() * 0.3)
                start = time.monotonic()
                process.send_signal(signal.SIGINT)
                # Python does not pass on what is raised while it collects garbage.
                while not select.select([process.stdout], [], [], 2)[0]:
                    process.send_signal(signal.SIGINT)
                    assert time.monotonic() < start + SOON
                assert process.stdout.readline() == b"over\n"
                took.append(time.monotonic() - start)
            assert process.stdout.readline() == b"done\n"
        finally:
            process.kill()
    return took
