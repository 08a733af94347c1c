"""What running costs beside the black box: processes, progress, checkpoints.

A black box that takes 20 ms, over two processes that run and one after the other; an idle one,
with progress and a checkpoint; a million trials in the engine, with a checkpoint every thousand and
without. What each may cost at most is said at the end.

    python benches/running.py [--quick]
"""

import argparse
import contextlib
import io
import tempfile
import time
from pathlib import Path

import numpy as np

import divbandit as db
from divbandit.paper import setting
from timing import fastest

ARM = setting.arm()
JOBS = 2
#: Trials until all processes have begun.
BEGIN = 20
SLEEP = 0.02


class Waiting:
    """A black box that takes its time, and no processor."""

    motor_space, sensory_space = ARM.motor_space, ARM.sensory_space

    def __call__(self, command):
        time.sleep(SLEEP)
        return ARM(command)


def idle():
    effect = np.zeros(2)
    return db.FunctionEnvironment(lambda _: effect, ARM.motor_space, ARM.sensory_space)


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--quick", action="store_true", help="less of all, for a first look")
    quick = parser.parse_args().quick
    slow, n, long = (50, 5_000, 100_000) if quick else (200, 50_000, 1_000_000)

    alone, beside = (once_begun(slow, jobs=jobs) for jobs in (None, JOBS))
    one, several = (further(lambda n, j=j: many(n // 4, j), slow) for j in (1, JOBS))
    bare = fastest(lambda: seconds(idle(), n), repeat=3)[1]
    watched = min(with_progress(idle(), n) for _ in range(3))
    plain, written = seconds(ARM, long), with_checkpoint(ARM, long)

    print("| work | trials | us a trial |")
    print("|---|---:|---:|")
    for work, trials, took in [
        ("a box of 20 ms, one after the other", slow, alone),
        (f"a box of 20 ms, {JOBS} processes", slow, beside),
        ("explore_many, a box of 20 ms, 1 job", slow, one),
        (f"explore_many, a box of 20 ms, {JOBS} jobs", slow, several),
        ("a function that does nothing", n, bare),
        ("a function that does nothing, progress and a checkpoint", n, watched),
        ("the arm", long, plain),
        ("the arm, a checkpoint every 1000", long, written),
    ]:
        print(f"| {work} | {trials} | {took / trials * 1e6:.2f} |")
    print()
    limits = [
        (f"a box of 20 ms, {JOBS} processes, of one after the other", beside / alone, 1 / 1.8),
        (f"explore_many, {JOBS} jobs, of 1", several / one, 1 / 1.8),
        ("progress and a checkpoint, us", watched / n * 1e6, 10.0),
        ("a checkpoint every 1000, of none", written / plain, 1.3),
    ]
    for work, found, most in limits:
        print(f"{work}: {found:.2f}, at most {most:.2f}" + ("" if found <= most else ": EXCEEDED"))


def further(work, n):
    """Return what n trials more cost, the start of processes not counted."""
    return work(2 * n) - work(n)


def once_begun(n, **options):
    """Return what n trials cost once all processes have begun."""
    told = []
    note = [lambda *_: told.append(time.perf_counter())]
    seconds(Waiting(), BEGIN + n, callbacks=note, **options)
    return told[-1] - told[BEGIN - 1]


def seconds(environment, n, **options):
    start = time.perf_counter()
    db.explore(environment, setting.adapt(0.05), n, rng=0, **options)
    return time.perf_counter() - start


def many(n, jobs):
    """The same with four explorations."""
    tasks = [db.experiments.Task(Waiting(), setting.adapt(0.05), n=n) for _ in range(4)]
    start = time.perf_counter()
    list(db.explore_many(tasks, rng=0, jobs=jobs))
    return time.perf_counter() - start


def with_progress(environment, n):
    with contextlib.redirect_stderr(io.StringIO()):
        return with_checkpoint(environment, n, callbacks=[db.callbacks.Progress()])


def with_checkpoint(environment, n, **options):
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / "run"
        return seconds(environment, n, checkpoint=path, every=1000, **options)


if __name__ == "__main__":
    main()
