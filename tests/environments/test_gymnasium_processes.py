"""Episodes side by side in processes: they are kept, closed, and may die."""

import functools
import multiprocessing
import os

import numpy as np
import pytest

import divbandit as db
from tests.environments.small_envs import Cart, cart, last

MIDDLE, RIGHT = [0.0, 0.0], [1.0, 0.0]


class OddError(Exception):
    """An error that pickle cannot make again."""

    def __init__(self, one, two):
        super().__init__(f"{one} and {two}")


def deadly(episode):
    if episode.actions[0, 0] > 0.2:
        os._exit(1)
    return last(episode)


def odd(episode):
    if episode.actions[0, 0] > 0.2:
        raise OddError(1, 2)
    return last(episode)


def children():
    return {child.pid for child in multiprocessing.active_children()}


def test_processes_are_kept_for_the_next_batch_and_closed_in_the_end():
    before = children()
    commands = np.random.default_rng(0).uniform(-1, 1, (9, 2))
    alone = cart()(commands)
    with cart(envs=2, vector="async") as environment:
        assert environment(commands).tobytes() == alone.tobytes()
        begun = children() - before
        assert len(begun) == 2
        assert environment(commands[::-1]).tobytes() == alone[::-1].tobytes()
        assert children() - before == begun
    assert not children() & begun


def test_no_process_for_one_command_or_none():
    before = children()
    with cart(envs=2, vector="async", sensory_space=db.Box([-9] * 2, [9] * 2)) as environment:
        assert environment([MIDDLE]).tolist() == [environment(MIDDLE).tolist()]
        assert environment(np.empty((0, 2))).shape == (0, 2)
        assert children() == before


def test_lambdas_are_sent_as_well():
    scale = 2.0
    with cart(effect=lambda episode: scale * last(episode), envs=2, vector="async") as environment:
        assert environment([MIDDLE, RIGHT]).tolist() == (2 * cart()([MIDDLE, RIGHT])).tolist()


def test_one_that_dies_is_told_of_and_the_next_batch_goes_well():
    with cart(effect=deadly, envs=2, vector="async") as environment:
        with pytest.raises(RuntimeError, match="a process of the vector environment died"):
            environment([MIDDLE, RIGHT])
        assert environment([MIDDLE, MIDDLE]).tolist() == [cart()(MIDDLE).tolist()] * 2


@pytest.mark.parametrize(("vector", "name"), [("sync", "OddError"), ("async", "RuntimeError")])
def test_of_an_error_that_cannot_be_sent_remains_what_it_said(vector, name):
    with cart(effect=odd, envs=2, vector=vector) as environment:
        with pytest.raises(Exception, match="1 and 2") as caught:
            environment([MIDDLE, MIDDLE, RIGHT])
        assert type(caught.value).__name__ == name
        assert environment([MIDDLE, MIDDLE]).shape == (2, 2)


def test_what_make_raises_comes_through():
    environment = cart(make=functools.partial(int, "seven"), envs=2)
    with pytest.raises(ValueError, match="seven"):
        environment([MIDDLE, MIDDLE])


def test_one_that_is_in_an_episode_is_closed_at_its_end():
    bodies = []

    class Closing(Cart):
        is_open = True

        def reset(self, **options):
            bodies.append(self)
            environment.close()
            assert self.is_open
            return super().reset(**options)

        def close(self):
            self.is_open = False

    environment = cart(make=Closing)
    environment(MIDDLE)
    environment(MIDDLE)
    assert [body.is_open for body in bodies] == [False, False]
    assert bodies[0] is not bodies[1]
