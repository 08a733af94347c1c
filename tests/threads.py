"""Calls made by many threads at once."""

import sys
import threading
from contextlib import contextmanager

#: Whether only one thread at a time runs Python: not so on a free-threaded one.
HAS_GIL = getattr(sys, "_is_gil_enabled", lambda: True)()

#: A deadlock, not a slow machine: seconds after which a thread is given up.
HANGS = 120


def at_once(calls):
    """Make each call in a thread of its own, all let go together; return what each returned.

    What a call raises is raised here.
    """
    calls = list(calls)
    results, errors = [None] * len(calls), []
    ready = threading.Barrier(len(calls))

    def run(index, call):
        try:
            ready.wait()
            results[index] = call()
        except BaseException as error:  # noqa: BLE001 - raised where it is seen
            errors.append(error)

    threads = [
        threading.Thread(target=run, args=(index, call), daemon=True)
        for index, call in enumerate(calls)
    ]
    with _switching_often():
        for thread in threads:
            thread.start()
        for thread in threads:
            thread.join(HANGS)
    assert not any(thread.is_alive() for thread in threads), "a thread hangs"
    if errors:
        raise errors[0]
    return results


@contextmanager
def _switching_often():
    """Let the interpreter go from thread to thread as often as it can."""
    before = sys.getswitchinterval()
    sys.setswitchinterval(1e-6)
    try:
        yield
    finally:
        sys.setswitchinterval(before)
