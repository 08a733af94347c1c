"""Black boxes that misbehave, wherever they are: all that was observed is there, and it goes on."""

import re
import sys
import threading
import time
from concurrent.futures import BrokenExecutor
from contextlib import ExitStack, contextmanager
from multiprocessing import active_children

import pytest

import divbandit as db
from tests.real_life.boxes import EDGE, KINDS, Box, still_running
from tests.real_life.places import PLACES

N = 12
#: What is tried in batches, too: each start of workers takes a second.
BATCHED = ("fine", "raises", "exits", "NaN", "unpicklable effect", "hangs on", "dies")
#: Only worker processes survive these.
FATAL = list(KINDS)[list(KINDS).index("forks") :]
CASES = [
    (kind, place)
    for kind in KINDS
    for place in PLACES
    if kind not in FATAL or place.startswith("jobs") or (kind == "dies" and place == "processes")
    if place != "jobs, in batches" or kind in BATCHED
]

if sys.platform == "win32":
    pytest.skip("processes are POSIX's", allow_module_level=True)


@pytest.fixture(scope="module")
def places():
    """Return what opens a place, with its options for a box; a cluster is opened once."""
    with ExitStack() as stack:
        cluster = []

        @contextmanager
        def opened(place, kind):
            if place == "dask":
                cluster.append(cluster[0] if cluster else stack.enter_context(PLACES[place]()))
                yield cluster[0]
                return
            with PLACES[place]() as options:
                timed = place.startswith("jobs") and re.search("hangs|without end", kind)
                yield options | ({"timeout": 0.5} if timed else {})

        yield opened


def explorer(rng=0):
    strategy = db.Mixture([db.MotorBabbling(), db.GoalBabbling(0.3)])
    return db.Explorer(strategy, Box.motor_space, Box.sensory_space, rng=rng)


@pytest.fixture
def folder(tmp_path, places, request):
    """A folder for boxes to write to; nothing may run on afterwards."""
    with places(request.node.callspec.params["place"], ""):  # what a cluster runs is its own
        before = running(tmp_path)
    yield tmp_path
    end = time.monotonic() + 5
    while running(tmp_path) - before and time.monotonic() < end:
        time.sleep(0.01)
    assert running(tmp_path) - before == set()


def running(folder):
    """Return all threads, children, and what boxes have left behind."""
    return set(threading.enumerate()) | set(active_children()) | set(still_running(folder))


def goes_on(exploring, box):
    """Check that what is left under way is evaluated first, and that all is still in order."""
    left, told = exploring.open_trials, len(exploring.history)
    fine = Box("fine", box.folder)
    exploring.run(fine, N)
    assert exploring.open_trials == ()
    commands = exploring.history.commands.tolist()
    for place, trial in enumerate(left, start=told):
        assert commands[place] == trial.command.tolist()
    exploring.run(box if box.kind not in FATAL else fine, N, batch=2, on_error="record")


@pytest.mark.parametrize(("kind", "place"), CASES)
def test_recorded(kind, place, places, folder):
    box, exploring = Box(kind, folder), explorer()
    with places(place, kind) as options:
        try:
            exploring.run(box, N, on_error="record", **options)
        except BrokenExecutor:
            assert (kind, place) == ("dies", "processes")
        else:
            assert exploring.evaluations == N
            assert len(exploring.history.failures) > 0 or box.reason is None
    box.check(exploring.history)
    goes_on(exploring, box)


@pytest.mark.parametrize(("kind", "place"), CASES)
def test_raised(kind, place, places, folder):
    box, exploring = Box(kind, folder), explorer()
    with places(place, kind) as options:
        if box.reason is None:
            exploring.run(box, N, **options)
        else:
            with pytest.raises(Exception) as caught:  # noqa: PT011 - looked at below
                exploring.run(box, 50, **options)
    box.check(exploring.history)
    if box.reason is not None:
        error = caught.value
        assert error.explorer is exploring
        assert len(exploring.history.failures) == 0
        assert any(trial.command[0] > EDGE for trial in exploring.open_trials)
        if sys.version_info >= (3, 11) and not isinstance(error, BrokenExecutor):
            command = next(
                trial.command.tolist()
                for trial in exploring.open_trials
                if str(trial.command.tolist()) in error.__notes__[0]
            )
            assert command[0] > EDGE
            assert "error.explorer.run" in error.__notes__[1]
    goes_on(exploring, box)
