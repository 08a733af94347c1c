"""over_processes: Ctrl-C ends it after the calls under way, and leaves no process."""

import os
import signal
import subprocess
import sys
import time
from pathlib import Path

#: Each call notes its process, and sleeps for a while.
SCRIPT = """
import os, sys, time
from pathlib import Path
from divbandit.studies.processes import over_processes

def call(number):
    Path(sys.argv[1], str(number)).write_text(str(os.getpid()))
    time.sleep(0.5)

if __name__ == "__main__":
    over_processes(call, range(40), jobs=2)
"""


def test_an_interrupt_lets_no_call_begin_and_leaves_no_process(tmp_path):
    script, notes = tmp_path / "script.py", tmp_path / "notes"
    script.write_text(SCRIPT, encoding="utf-8")
    notes.mkdir()
    with subprocess.Popen(  # noqa: S603 - this script
        [sys.executable, str(script), str(notes)], start_new_session=True, stderr=subprocess.PIPE
    ) as running:
        while len(begun := list(notes.iterdir())) < 6:
            assert running.poll() is None
            time.sleep(0.01)
        # As a terminal does, to all processes at once.
        os.killpg(running.pid, signal.SIGINT)
        _, told = running.communicate(timeout=60)
    assert told.rstrip().endswith(b"KeyboardInterrupt")
    # Between the look and the signal each of the two may have begun another call.
    assert len(list(notes.iterdir())) <= len(begun) + 2
    pids = {int(path.read_text(encoding="utf-8")) for path in notes.iterdir()}
    assert not any(Path(f"/proc/{pid}").exists() for pid in pids)
