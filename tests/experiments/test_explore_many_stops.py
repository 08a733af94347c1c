"""explore_many: whatever ends it early, all that is under way stops and no thread is left."""

import os
import signal
import subprocess
import sys
import threading
import time

import pytest

import divbandit as db
from divbandit.experiments import Task

BOX = db.Box([0], [1])
ENDLESS = 3_000_000  # steps: half a minute, so that a test fails rather than hangs
BEGUN = """
import threading, divbandit as db
begun, known = threading.Semaphore(0), set()
def f(x):
    if threading.get_ident() not in known:
        known.add(threading.get_ident())
        begun.release()  # once for each thread
    return x
task = db.experiments.Task(db.FunctionEnvironment(f, db.Box([0], [1])), db.MotorBabbling(), 10**9)
quick = db.experiments.Task(db.PlanarArm(2), db.MotorBabbling(), 3)
"""


class Begun:
    """An environment that says when it was called, and counts."""

    motor_space = sensory_space = BOX

    def __init__(self):
        self.event, self.calls = threading.Event(), 0

    def __call__(self, command):
        self.event.set()
        self.calls += 1
        return command


def failing(after, error):
    """Return a task whose environment raises `error` when an endless one has begun."""

    def f(_):
        assert after.event.wait(60)
        raise error

    return Task(db.FunctionEnvironment(f, BOX), db.MotorBabbling(), n=3)


@pytest.fixture
def begun():
    environment = Begun()
    yield environment
    assert environment.calls < ENDLESS


@pytest.fixture
def endless(begun):
    return Task(begun, db.MotorBabbling(), ENDLESS)


@pytest.fixture
def quick(begun):
    """Return a task that ends when the endless one has begun."""

    def f(x):
        assert begun.event.wait(60)
        return x

    return Task(db.FunctionEnvironment(f, BOX), db.MotorBabbling(), n=3)


@pytest.fixture(autouse=True)
def _no_thread_is_left():
    before = set(threading.enumerate())
    yield
    assert set(threading.enumerate()) == before


def test_closing(endless, quick):
    many = db.explore_many([endless, quick, endless, endless], jobs=2)
    assert next(many)[0] == 1
    many.close()
    assert list(many) == []


def test_dropping(endless, quick):
    many = db.explore_many([endless, quick], jobs=2)
    next(many)
    before = threading.active_count()
    del many
    assert threading.active_count() == before - 2


def test_leaving_the_loop(endless, quick):
    for place, _ in db.explore_many([quick, endless], jobs=2):
        assert place == 0
        break


def test_dropping_in_a_thread_that_explores(endless, quick):
    """The last reference may be lost anywhere: also in a thread that cannot wait for itself."""
    before = set(threading.enumerate())
    turn, handed_over, holder = threading.Lock(), threading.Event(), []

    def keep(_):
        if not turn.acquire(blocking=False):  # the second
            assert handed_over.wait(60)
            holder.clear()

    many = db.explore_many([quick, quick, endless], keep=keep, jobs=3)
    next(many)
    holder.append(many)
    del many
    handed_over.set()
    # A free-threaded Python drops what another thread let go of here, when it next comes round.
    end = time.monotonic() + 60
    while set(threading.enumerate()) != before and time.monotonic() < end:
        time.sleep(0.01)
    assert holder == []


def test_an_error_in_a_task_stops_the_others(begun, endless):
    error = ZeroDivisionError("no good")
    with pytest.raises(ZeroDivisionError, match="no good") as caught:
        list(db.explore_many([endless, failing(begun, error), endless], jobs=2))
    assert caught.value is error
    if sys.version_info >= (3, 11):
        assert error.__notes__[-1] == "raised by the task at place 1 of explore_many"


@pytest.mark.parametrize("where", ["keep", "progress"])
def test_an_error_in_a_callback_stops_the_others(endless, quick, where):
    def call(*given):
        raise LookupError(f"of {len(given)}")

    with pytest.raises(LookupError, match="of 1" if where == "keep" else "of 0"):
        list(db.explore_many([endless, quick], jobs=2, **{where: call}))


@pytest.mark.parametrize(
    ("last", "error", "message"),
    [
        (None, LookupError, "no more"),
        ((), TypeError, "tasks must be Tasks, got tuple at place 1"),
    ],
    ids=["an error", "no task"],
)
def test_what_the_iterable_gives_or_raises_stops_the_others(begun, endless, last, error, message):
    def tasks():
        yield endless
        assert begun.event.wait(60)
        if last is None:
            raise LookupError("no more")
        yield last

    with pytest.raises(error, match=message):
        list(db.explore_many(tasks(), jobs=2))


def test_an_error_in_an_argument_of_a_task_names_it(endless):
    wrong = Task(endless.environment, endless.strategy, n=0)
    with pytest.raises(ValueError, match="n must be at least 1, got 0"):
        list(db.explore_many([endless, wrong], jobs=2))


def test_a_task_cannot_end_the_iteration_in_silence(begun, endless):
    with pytest.raises(RuntimeError, match="StopIteration"):
        list(db.explore_many([endless, failing(begun, StopIteration())], jobs=2))


def test_a_black_box_that_exits_is_an_error(begun, endless):
    with pytest.raises(RuntimeError, match="must return an effect, got SystemExit"):
        list(db.explore_many([endless, failing(begun, SystemExit())], jobs=2))


def test_after_an_error_nothing_more_comes(begun, quick):
    begun.event.set()
    many = db.explore_many([failing(begun, LookupError()), quick, quick], jobs=1)
    with pytest.raises(LookupError):
        next(many)
    assert list(many) == []


def ended(script, *, interrupt=False):
    """Run a script in a process of its own, perhaps press Ctrl-C, and return what it printed."""
    command = [sys.executable, "-W", "error", "-c", BEGUN + script]
    with subprocess.Popen(  # noqa: S603
        command, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True
    ) as process:
        try:
            if interrupt:
                assert process.stdout.readline() == "begun\n"
                process.send_signal(signal.SIGINT)
            out, errors = process.communicate(timeout=30)
        except BaseException:
            process.kill()
            raise
    return process.returncode, out.split("\n")[:-1], errors


@pytest.mark.skipif(sys.platform == "win32", reason="no SIGINT for another process")
@pytest.mark.parametrize("jobs", [1, 2, 5])
def test_ctrl_c_while_waiting(jobs):
    script = f"""
def tell():
    for _ in range({jobs}):
        begun.acquire()
    print("begun", flush=True)
teller = threading.Thread(target=tell)
teller.start()
try:
    dict(db.explore_many([task] * 9, jobs={jobs}))
except KeyboardInterrupt:
    teller.join()
    print(threading.active_count(), flush=True)
"""
    assert ended(script, interrupt=True) == (0, ["1"], "")


@pytest.mark.skipif(sys.platform == "win32", reason="no SIGINT for another process")
def test_ctrl_c_elsewhere_while_the_iterator_has_a_name():
    script = """
import time
many = db.explore_many([quick, task, task], jobs=2)
next(many)
print("begun", flush=True)
while True:  # a signal that comes before a sleep is heard after it
    time.sleep(0.05)
"""
    code, _, errors = ended(script, interrupt=True)
    assert code != 0
    assert errors.rstrip().endswith("KeyboardInterrupt")


@pytest.mark.parametrize("tasks", ["[quick, quick]", "[quick, task, task, task]"])
def test_a_program_ends_with_an_iterator_left_behind(tasks):
    script = f"""
many = db.explore_many({tasks}, jobs=2)
print(len(next(many)[1]))
"""
    assert ended(script) == (0, ["3"], "")


def test_a_thread_that_outlives_the_script_is_refused():
    script = """
def work():
    threading.main_thread().join()
    try:
        list(db.explore_many([quick] * 6, jobs=2))
    except RuntimeError as error:
        print("refused")
threading.Thread(target=work).start()
"""
    assert ended(script) == (0, ["refused"], "")


def test_a_thread_that_waits_when_the_script_ends_is_stopped():
    script = """
def work():
    try:
        list(db.explore_many([task] * 6, jobs=2))
    except RuntimeError as error:
        print("stopped")
threading.Thread(target=work).start()
begun.acquire()
"""
    assert ended(script) == (0, ["stopped"], "")


def test_a_daemon_that_explores_does_not_delay_the_exit():
    script = """
threading.Thread(target=lambda: list(db.explore_many([task] * 3, jobs=2)), daemon=True).start()
begun.acquire()
"""
    assert ended(script)[:2] == (0, [])


@pytest.mark.skipif(not hasattr(os, "fork"), reason="no fork")
def test_a_fork_has_none_of_the_threads():
    """There it raises rather than waits for ever, and the process that was forked goes on."""
    script = """
import os, signal, warnings
warnings.simplefilter("ignore")  # to fork with threads is what this is about
many = db.explore_many([quick, task, task], jobs=2)
next(many)
begun.acquire()
child = os.fork()
if child == 0:
    signal.alarm(20)
    try:
        list(many)
    except RuntimeError as error:
        print(error, flush=True)
    fresh = db.explore_many([quick] * 3, jobs=2)
    print(len(list(fresh)), flush=True)
    os._exit(0)
print(os.waitpid(child, 0)[1])
"""
    code, out, errors = ended(script)
    assert (code, out[1:], errors) == (0, ["3", "0"], "")
    assert "forked" in out[0]


def test_it_does_not_begin_when_python_is_being_torn_down():
    script = """
class Late:
    def __del__(self, quick=quick, explore_many=db.explore_many):
        try:
            list(explore_many([quick], jobs=1))
        except RuntimeError as error:
            print("refused")
late = Late()
"""
    assert ended(script)[:2] == (0, ["refused"])
