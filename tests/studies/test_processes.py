"""Studies over processes: Ctrl-C ends them at once, with the calls under way."""

import os
import random
import signal
import subprocess
import sys
import time
from pathlib import Path

import pytest

if sys.platform == "win32":
    pytest.skip("no SIGINT for another process", allow_module_level=True)

#: Each call notes its process, and takes ten minutes after the first few.
SCRIPT = """
import os, sys, time
from pathlib import Path
from divbandit.studies.processes import over_processes

def call(number):
    Path(sys.argv[1], str(number)).write_text(str(os.getpid()))
    time.sleep(0.1 if number < 4 else 600)

over_processes(call, range(40), jobs=2)
"""


def test_an_interrupt_ends_calls_and_processes(tmp_path):
    script, notes = tmp_path / "script.py", tmp_path / "notes"
    script.write_text(SCRIPT, encoding="utf-8")
    notes.mkdir()
    with subprocess.Popen(  # noqa: S603 - this script
        [sys.executable, str(script), str(notes)], start_new_session=True, stderr=subprocess.PIPE
    ) as running:
        while len(list(notes.iterdir())) < 6:
            assert running.poll() is None
            time.sleep(0.01)
        # As a terminal does, to all processes at once.
        os.killpg(running.pid, signal.SIGINT)
        _, told = running.communicate(timeout=60)
    assert told.rstrip().endswith(b"KeyboardInterrupt")
    assert len(list(notes.iterdir())) == 6
    pids = {int(path.read_text(encoding="utf-8")) for path in notes.iterdir()}
    assert not any(Path(f"/proc/{pid}").exists() for pid in pids)


def test_an_interrupted_study_leaves_nothing_running(tmp_path):
    interrupt(2, tmp_path)


def interrupt(times, folder):
    """Interrupt a study at random moments; return how long each took to end."""
    chance = random.Random(0)  # noqa: S311 - when is no secret
    words = ["study", "strategies", "--repetitions", "20", "--jobs", "2", "--out"]
    took = []
    for _ in range(times):
        with subprocess.Popen(  # noqa: S603 - our own program
            [
                sys.executable,
                "-c",
                "from divbandit.cli import main; raise SystemExit(main())",
                *words,
                str(folder),
            ],
            start_new_session=True,
            stdout=subprocess.DEVNULL,
            stderr=subprocess.PIPE,
        ) as running:
            running.stderr.read(1)  # its bar: it has begun
            time.sleep(chance.random() * 3)
            start = time.monotonic()
            running.send_signal(signal.SIGINT)
            _, told = running.communicate(timeout=60)
            took.append(time.monotonic() - start)
        assert (running.returncode, told.rstrip()[-11:]) == (130, b"interrupted")
        assert not list(folder.iterdir())
        end = time.monotonic() + 10
        while left := descendants(running.pid):
            assert time.monotonic() < end, left
            time.sleep(0.01)
    return took


def descendants(session):
    """Return the processes that a program that led a session has left behind."""
    left = []
    for status in Path("/proc").glob("[0-9]*/stat"):
        try:
            after_name = status.read_text(encoding="utf-8").rpartition(")")[2].split()
        except OSError:  # it has ended
            continue
        if after_name[0] != "Z" and int(after_name[3]) == session:
            left.append(status.with_name("cmdline").read_bytes())
    return left
