"""ProcessEnvironment: real programs, good and bad ones."""

import contextlib
import os
import signal
import subprocess
import sys
import threading
import time
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

import numpy as np
import pytest

import divbandit as db
from divbandit.environments import ProcessEnvironment

SPACE = db.Box([-1, -1], [1, 1])


def program(code, *words, **options):
    command_line = [sys.executable, "-S", "-c", f"import json, os, sys, time; {code}", *words]
    return ProcessEnvironment(command_line, SPACE, **{"timeout": 60.0} | options)


ECHO = "print([float(x) for x in sys.argv[1:]])"


def test_numbers_come_back_to_the_bit():
    echo = program(ECHO)
    commands = np.array([[0.1, -1 / 3], [1e-300, -5e-324], [1.0, -1.0]])
    np.testing.assert_array_equal(echo(commands), commands)
    np.testing.assert_array_equal(echo(commands[0]), commands[0])
    assert echo(commands[:0]).shape == (0, 0)


def test_a_number_and_an_entry_are_effects():
    assert program("print(float(sys.argv[1]) * 2)")([0.25, 0]).tolist() == [0.5]
    assert program('print(json.dumps({"y": 3, "z": 4}))', entry="z")([0, 0]).tolist() == [4.0]


def test_words_are_no_shell():
    assert program("print(len(sys.argv))", "$HOME; a  b", "*")([0, 0]).tolist() == [5.0]


@pytest.mark.parametrize(
    ("code", "error", "says"),
    [
        ("print('no json')", RuntimeError, "must write JSON to its standard output, got 'no"),
        ("pass", RuntimeError, "must write JSON to its standard output, got ''"),
        ("sys.exit('it is on fire')", RuntimeError, "status 1: it is on fire"),
        ("os.abort()", RuntimeError, "status -6"),
        ("print('[1, NaN]')", ValueError, r"effect\[1\] must be finite"),
        ("print([])", ValueError, "effect must not be empty"),
        ("print('[true]')", TypeError, "effect must be an array of real numbers"),
        ("print('true')", TypeError, "effect must be an array of real numbers"),
        ("print('{}')", TypeError, "effect must be an array of real numbers"),
        ("print([[1, 2]])", ValueError, "effect must have shape"),
        ("print('[' * 100000)", RuntimeError, r"must write JSON to its standard output, got '\[\["),
        ("print([1]); print([2])", RuntimeError, "must write JSON"),
        ("print('[1e400]')", ValueError, r"effect\[0\] must be finite"),
        ("os.write(1, bytes([255]))", RuntimeError, "must write JSON"),
        ("sys.stderr.write('x' * 10**6 + ' the end'); sys.exit(2)", RuntimeError, "x the end$"),
    ],
)
def test_bad_programs(code, error, says):
    with pytest.raises(error, match=says):
        program(code)([0, 0])


def test_a_missing_entry_is_named():
    with pytest.raises(RuntimeError, match="JSON object with 'y', got '3"):
        program("print(3)", entry="y")([0, 0])


def test_a_missing_program_is_said():
    with pytest.raises(FileNotFoundError):
        ProcessEnvironment(["/nowhere/at/all"], SPACE)([0, 0])


def test_an_effect_of_another_dimension_is_refused():
    echo = program(ECHO, sensory_space=db.Box([0], [1]))
    with pytest.raises(ValueError, match=r"effect must have shape \(1,\)"):
        echo([0, 0])


def alive(pid):
    """Whether a process is there and has not ended."""
    try:
        with open(f"/proc/{pid}/stat", encoding="utf-8") as file:  # noqa: PTH123
            return file.read().rsplit(")", 1)[1].split()[0] != "Z"
    except FileNotFoundError:
        return False


def gone(pid, seconds=30):
    """Wait until a process has ended."""
    deadline = time.monotonic() + seconds
    while alive(pid) and time.monotonic() < deadline:
        time.sleep(0.01)
    return not alive(pid)


def end(pid):
    """Kill a process if it is still there."""
    with contextlib.suppress(ProcessLookupError):
        os.kill(pid, signal.SIGKILL)


def test_what_takes_too_long_is_killed_with_all_it_has_started(tmp_path):
    code = (
        "import subprocess; child = subprocess.Popen(['sleep', '600']); "
        "open(sys.argv[1], 'w').write(f'{os.getpid()} {child.pid}'); time.sleep(600)"
    )
    slow = program(code, str(tmp_path / "pids"), timeout=3.0)
    with pytest.raises(TimeoutError, match=r"within timeout = 3.0 s"):
        slow([0, 0])
    pids = [int(pid) for pid in (tmp_path / "pids").read_text(encoding="utf-8").split()]
    assert len(pids) == 2
    assert all(gone(pid) for pid in pids)


def test_an_interrupted_evaluation_leaves_nothing(tmp_path):
    code = "open(sys.argv[1], 'w').write(str(os.getpid())); time.sleep(600)"
    slow = program(code, str(tmp_path / "pid"))

    def interrupt():
        while not (tmp_path / "pid").is_file() or not (tmp_path / "pid").read_text():
            time.sleep(0.01)
        # One that comes just before the wait is heard after it: then another is needed.
        while not interrupted.is_set():
            os.kill(os.getpid(), signal.SIGINT)
            interrupted.wait(5)

    interrupted, thread = threading.Event(), threading.Thread(target=interrupt)
    before = signal.signal(signal.SIGINT, signal.default_int_handler)
    try:
        thread.start()
        with pytest.raises(KeyboardInterrupt):
            slow([0, 0])
    finally:
        interrupted.set()
        thread.join()
        signal.signal(signal.SIGINT, before)
    assert gone(int((tmp_path / "pid").read_text(encoding="utf-8")))


def test_an_interrupt_while_the_program_is_started_leaves_nothing(monkeypatch):
    pids = []
    execute = subprocess.Popen._execute_child  # noqa: SLF001 - between this and the end of Popen

    def interrupted(self, *arguments):
        execute(self, *arguments)
        pids.append(self.pid)
        os.kill(os.getpid(), signal.SIGINT)

    monkeypatch.setattr(subprocess.Popen, "_execute_child", interrupted)
    before = signal.signal(signal.SIGINT, signal.default_int_handler)
    try:
        with pytest.raises(KeyboardInterrupt):
            program("time.sleep(600)", timeout=None)([0, 0])
    finally:
        signal.signal(signal.SIGINT, before)
    (pid,) = pids
    try:
        assert gone(pid, seconds=5)
    finally:
        end(pid)


@pytest.mark.skipif(sys.platform != "linux", reason="only Linux lists all processes as files")
def test_what_has_left_the_session_is_killed_as_well(tmp_path):
    note = tmp_path / "pid"
    innermost = f"import os; open({str(note)!r}, 'w').write(str(os.getpid()))"
    for _ in range(2):  # a child of a child, each in a session of its own
        words = [sys.executable, "-S", "-c", f"{innermost}; import time; time.sleep(600)"]
        innermost = f"import subprocess; subprocess.Popen({words!r}, start_new_session=True)"
    code = f"{innermost}; time.sleep(600)"
    with pytest.raises(TimeoutError):
        program(code, timeout=3.0)([0, 0])
    pid = int(note.read_text(encoding="utf-8"))
    try:
        assert gone(pid, seconds=5)
    finally:
        end(pid)


def test_what_it_leaves_in_the_background_is_not_waited_for():
    code = (
        "import subprocess; child = subprocess.Popen(['sleep', '600']); "
        "print([child.pid, 0.5], flush=True)"
    )
    pid, half = program(code, timeout=20.0)([0, 0]).tolist()
    assert half == 0.5
    assert alive(int(pid))  # it may be meant to go on
    end(int(pid))


def test_several_at_once_and_failures_survived():
    code = "x = float(sys.argv[1]); print([x, x * x]) if x > -0.5 else sys.exit(3)"
    risky = program(code, sensory_space=db.Box([-1, 0], [1, 1]))
    with ThreadPoolExecutor(4) as executor:
        run = db.explore(risky, db.MotorBabbling(), 24, rng=0, executor=executor, in_flight=4)
    assert len(run.effects) + len(run.failures) == 24
    assert 0 < len(run.failures) < 24
    np.testing.assert_array_equal(run.effects[:, 0], run.commands[:, 0])


def test_the_output_may_be_long():
    long = program("print(json.dumps([0.5] * 200000))")
    assert long([0, 0]).shape == (200000,)


def test_output_without_end_is_refused():
    endless = program("[os.write(1, b'[1, ' * 2**14) for _ in iter(int, 1)]", timeout=600.0)
    with pytest.raises(RuntimeError, match=r"at most 67108864 bytes .*, beginning with '\[1, \[1"):
        endless([0, 0])


def test_what_closes_its_output_still_has_to_end(tmp_path):
    code = "open(sys.argv[1], 'w').write(str(os.getpid())); os.close(1); os.close(2); "
    quiet = program(code + "time.sleep(600)", str(tmp_path / "pid"), timeout=2.0)
    with pytest.raises(TimeoutError, match=r"within timeout = 2.0 s"):
        quiet([0, 0])
    assert gone(int((tmp_path / "pid").read_text(encoding="utf-8")))


def test_nothing_stays_open(tmp_path):
    def ends(name, code, **options):
        note = f"open({str(tmp_path / name)!r}, 'w').write(str(os.getpid()))"
        return program(f"{note}; {code}", **options)

    good, bad = ends("good", ECHO), ends("bad", "sys.exit(1)")
    slow = ends("slow", "time.sleep(600)", timeout=2.0)
    before = {path.name for path in Path("/proc/self/fd").iterdir()}
    good([0, 0])
    for environment, error in ((bad, RuntimeError), (slow, TimeoutError)):
        with pytest.raises(error):
            environment([0, 0])
    assert {path.name for path in Path("/proc/self/fd").iterdir()} == before
    pids = [(tmp_path / name).read_text(encoding="utf-8") for name in ("good", "bad", "slow")]
    # One that has ended but was not waited for would still be listed.
    assert not any(Path("/proc", pid).exists() for pid in pids)


def test_small_numbers_below_zero_are_no_options():
    code = (
        "import argparse; words = argparse.ArgumentParser(); "
        "words.add_argument('x', type=float, nargs=2); print(words.parse_args().x)"
    )
    assert program(code, "--")([-1e-5, -0.5]).tolist() == [-1e-5, -0.5]
