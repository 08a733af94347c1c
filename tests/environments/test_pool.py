"""Pool: what is lent is used by one, kept for the next, and closed when something went wrong."""

import threading
import time

import pytest

from divbandit.environments._pool import Pool


class Thing:
    made = 0

    def __init__(self):
        type(self).made += 1
        self.closed = 0

    def close(self):
        self.closed += 1


def test_as_many_as_are_lent_at_once():
    pool = Pool(Thing)
    with pool.borrow() as first:
        with pool.borrow() as second:
            assert second is not first
        with pool.borrow() as third:
            assert third is second
    with pool.borrow() as fourth:
        assert fourth in (first, second)


def test_closed_when_given_back():
    pool = Pool(Thing)
    with pool.borrow() as idle:
        pass
    with pool.borrow(), pool.borrow() as lent:
        pool.close()
        assert lent.closed == 0
    assert (idle.closed, lent.closed) == (1, 1)
    with pool.borrow() as new:
        assert new not in (idle, lent)


@pytest.mark.parametrize("error", [ValueError, KeyboardInterrupt])
def test_what_went_wrong_is_not_lent_again(error):
    pool = Pool(Thing)
    with pytest.raises(error), pool.borrow() as broken:
        raise error
    assert broken.closed == 1
    with pool.borrow() as new:
        assert new is not broken


def test_an_error_of_closing_does_not_hide_what_went_wrong():
    class Stuck(Thing):
        def close(self):
            raise OSError

    with pytest.raises(ZeroDivisionError), Pool(Stuck).borrow():
        raise ZeroDivisionError


def test_never_two_at_once():
    pool, at_work, clashes = Pool(Thing), set(), []

    def work():
        for _ in range(300):
            with pool.borrow() as thing:
                if thing in at_work:
                    clashes.append(thing)
                at_work.add(thing)
                time.sleep(0)  # let others run
                at_work.discard(thing)

    threads = [threading.Thread(target=work) for _ in range(4)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    assert clashes == []
