"""Black boxes that misbehave: what they do where they do, and what is to be said of it."""

import os
import re
import subprocess
import sys
import threading
import time
from contextlib import suppress
from pathlib import Path

import divbandit as db

#: Where boxes misbehave: commands whose first number is larger.
EDGE = 0.6


class UnshowableError(Exception):
    def __str__(self):
        raise ZeroDivisionError


class UnpicklableError(Exception):
    def __init__(self, text, needed):
        super().__init__(text)
        self.lock, self.needed = threading.Lock(), needed


class UnreadableError(Exception):
    """It can be pickled, but not read again."""

    def __init__(self, text, needed):
        super().__init__(text)
        self.needed = needed


class Unpicklable:
    def __init__(self):
        self.lock = threading.Lock()


def raises(command, _):
    raise ValueError("no", float(command[0]))


def unshowable(*_):
    raise UnshowableError


def unpicklable(*_):
    raise UnpicklableError("locked", needed=1)


def unreadable(*_):
    raise UnreadableError("torn", needed=1)


def hangs(*_):
    time.sleep(60)


def hangs_on(*_):
    """Hang, whatever is raised meanwhile."""
    while True:
        with suppress(BaseException):
            time.sleep(60)


def prints_without_end(*_):
    while True:
        sys.stderr.write("this and that\n")


def prints(command, _):
    for line in range(1000):
        sys.stdout.write(f"this and that {line}\n")
    return command


def forks(command, folder):
    """Leave a copy of this process behind."""
    child = os.fork()
    if child == 0:
        time.sleep(60)
        os._exit(0)
    return left(child, command, folder)


def starts_program(command, folder):
    program = [sys.executable, "-c", "import time; time.sleep(60)"]
    child = subprocess.Popen(program)  # noqa: S603
    child.returncode = 0  # Python is not to warn of it
    return left(child.pid, command, folder)


def starts_program_and_dies(command, folder):
    starts_program(command, folder)
    os._exit(3)


def left(child, command, folder):
    (Path(folder) / str(child)).touch()
    return command


def starts_thread(command, _):
    threading.Thread(target=time.sleep, args=(0.05,), daemon=True).start()
    return command


#: What a box does, and the reason of the failure; None if that is none.
KINDS = {
    "fine": (lambda command, _: command, None),
    "prints": (prints, None),
    "starts a thread": (starts_thread, None),
    "raises": (raises, r"ValueError: \('no', 0\.\d+\)"),
    "unshowable": (unshowable, "UnshowableError, whose message cannot be shown"),
    "unpicklable exception": (unpicklable, "UnpicklableError: locked"),
    "unreadable exception": (unreadable, "UnreadableError: torn"),
    "exits": (lambda *_: sys.exit(0), "SystemExit: 0"),
    "NaN": (lambda *_: [float("nan"), 0.0], r"ValueError: effect\[0\] must be finite, got NaN"),
    "wrong length": (lambda *_: [1.0], r"ValueError: effect must .*"),
    "wrong shape": (lambda command, _: [command], r"ValueError: effect must .*"),
    "nothing": (lambda *_: None, r"TypeError: effect must .*"),
    "unpicklable effect": (lambda *_: Unpicklable(), r"TypeError: effect must .*"),
    "a generator": (lambda command, _: (x for x in command), r"TypeError: effect must .*"),
    # Only worker processes survive the following.
    "forks": (forks, None),
    "starts a program": (starts_program, None),
    "hangs": (hangs, r"TimeoutError: no effect within timeout = 0\.5 s"),
    "hangs on": (hangs_on, r"TimeoutError: no effect within timeout = 0\.5 s"),
    "prints without end": (prints_without_end, r"TimeoutError: .*"),
    "dies": (lambda *_: os._exit(3), r"RuntimeError: the worker process ended \(exit code 3\)"),
    "starts a program and dies": (starts_program_and_dies, r"RuntimeError: the worker process .*"),
}


class Box:
    """A black box whose effect is the command, or which misbehaves."""

    motor_space = sensory_space = db.Box([0, 0], [1, 1])

    def __init__(self, kind, folder):
        self.kind, self.folder = kind, str(folder)

    def __call__(self, command):
        if command[0] <= EDGE:
            return command
        return KINDS[self.kind][0](command, self.folder)

    @property
    def reason(self):
        return KINDS[self.kind][1]

    def check(self, history):
        """Check that nothing else is in a history than what it does."""
        assert history.commands.tobytes() == history.effects.tobytes()
        if self.reason is not None:
            assert (history.commands[:, 0] <= EDGE).all()
        for failure in history.failures:
            assert failure.command[0] > EDGE
            assert re.fullmatch(self.reason, failure.reason), failure.reason


def still_running(folder):
    """Return the processes that boxes have left behind."""
    return [file.name for file in Path(folder).iterdir() if is_running(int(file.name))]


def is_running(number):
    """Whether a process is there, and no zombie."""
    try:
        os.kill(number, 0)
        status = Path(f"/proc/{number}/stat").read_text()
    except ProcessLookupError:
        return False
    except FileNotFoundError:  # not Linux
        return True
    return status.rpartition(")")[2].split()[0] != "Z"
