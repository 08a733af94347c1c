"""The same tests at more moments, and what they measure: ``python -m tests.real_life.numbers``."""

import sys
import tempfile
import time
from pathlib import Path

from tests.real_life.stopped import PLACES
from tests.real_life.test_interrupts import press, stop
from tests.real_life.test_kills import kill
from tests.studies.test_processes import interrupt


def main():
    for engine in ("rust", "python", "mine"):
        with tempfile.TemporaryDirectory() as folder:
            start = time.monotonic()
            press(engine, 1000, folder)
            report(
                f"{engine}: 1000 times caught and gone on with, {time.monotonic() - start:.0f} s"
            )
    for where in [*PLACES, "many"]:
        with tempfile.TemporaryDirectory() as folder:
            took = stop(where, 50, Path(folder))
        report(f"{where}: 50 runs ended after at most {max(took):.2f} s")
    with tempfile.TemporaryDirectory() as folder:
        took = interrupt(50, Path(folder))
    report(f"a study: 50 ended after at most {max(took):.2f} s")
    for jobs in (0, 2):
        with tempfile.TemporaryDirectory() as folder:
            kill(jobs, 30, Path(folder))
        report(f"jobs = {jobs}: killed 30 times, nothing lost")


def report(line):
    sys.stdout.write(line + "\n")
    sys.stdout.flush()


if __name__ == "__main__":
    main()
