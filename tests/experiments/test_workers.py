"""Workers: what is left to do when nobody is there any more to do it with."""

import threading

from divbandit.experiments import workers


def test_leaving_at_exit_when_the_threads_have_ended_and_modules_are_empty(monkeypatch):
    """A free-threaded Python may close an iterator that was left behind as late as that."""
    before, stop = set(threading.enumerate()), threading.Event()
    with workers.Workers(abs, 2, stop) as busy:
        busy.put(-3)
        assert busy.get() == 3
        stop.set()
        for thread in set(threading.enumerate()) - before:
            thread.join(60)
        monkeypatch.setattr(workers, "threading", None)
    assert set(threading.enumerate()) == before


def test_leaving_waits_for_the_threads():
    before, stop = set(threading.enumerate()), threading.Event()

    def until_stopped(_):
        assert stop.wait(60)

    with workers.Workers(until_stopped, 2, stop) as busy:
        busy.put(None)
        busy.put(None)
        assert len(set(threading.enumerate()) - before) == 3  # one of them watches
    assert set(threading.enumerate()) == before
