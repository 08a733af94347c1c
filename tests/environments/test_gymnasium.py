"""An episode as a black box: the contract, on environments small enough to look through."""

import os
import pickle
import threading
from concurrent.futures import ProcessPoolExecutor, ThreadPoolExecutor
from dataclasses import FrozenInstanceError, replace
from functools import partial
from multiprocessing import get_context
from types import SimpleNamespace

import gymnasium
import numpy as np
import pytest

import divbandit as db
from divbandit.controllers import FunctionController
from divbandit.environments import GymnasiumEnvironment
from tests.environments.small_envs import HOLD, Cart, cart, last

COMMANDS = np.random.default_rng(5).uniform(-1, 1, (23, 2))


def by_hand(command, *, seed=3, steps=8, time=99):
    """Return all that happens, with nothing but Gymnasium and a loop."""
    env = Cart(time=time)
    seen = [env.reset(seed=seed)[0].copy()]
    actions, over = [], False
    while len(actions) < steps and not over:
        actions.append(np.clip(command, -0.25, 0.25))
        observation, _, terminated, truncated, _ = env.step(actions[-1])
        seen.append(observation.copy())
        over = terminated or truncated
    return np.array(seen), np.array(actions)


def test_it_is_an_environment_with_the_controller_s_motor_space():
    environment = cart(sensory_space=db.Box([-1, -1], [1, 1]))
    assert isinstance(environment, db.Environment)
    assert environment.motor_space == HOLD.motor_space
    assert environment.sensory_space == db.Box([-1, -1], [1, 1])
    assert cart().sensory_space is None


@pytest.mark.parametrize("command", [*COMMANDS[:6].tolist(), [1.0, 0.1]])
def test_an_episode_is_what_a_loop_by_hand_does(command):
    seen, actions = by_hand(command)
    episode = cart().episode(command)
    np.testing.assert_array_equal(episode.observations, seen)
    np.testing.assert_array_equal(episode.actions, actions)
    assert episode.rewards.tolist() == list(range(1, len(actions) + 1))
    assert len(episode) == len(actions)
    np.testing.assert_array_equal(cart()(command), seen[-1])


def test_how_an_episode_ends():
    short = cart(make=partial(Cart, time=3))
    fell, late, left = cart().episode([1, 0]), short.episode([0, 0]), cart().episode([0, 0])
    assert (len(fell), fell.terminated, fell.truncated, fell.info) == (4, True, False, {"age": 4})
    assert (len(late), late.terminated, late.truncated, late.info) == (3, False, True, {"age": 3})
    assert (len(left), left.terminated, left.truncated, left.info) == (8, False, False, {"age": 8})
    with pytest.raises(FrozenInstanceError):
        left.truncated = True


def test_equal_commands_have_equal_effects_and_the_seed_matters():
    environment = cart()
    once = environment(COMMANDS)
    assert environment(COMMANDS[::-1])[::-1].tobytes() == once.tobytes()
    assert (cart(seed=4)(COMMANDS) != once).all()


def test_one_command_and_many():
    environment = cart()
    effects = environment(COMMANDS)
    assert effects.shape == (23, 2)
    assert effects.dtype == np.float64
    assert np.stack([environment(command) for command in COMMANDS]).tobytes() == effects.tobytes()
    assert environment(COMMANDS[:1]).shape == (1, 2)
    assert environment(COMMANDS[:0]).shape == (0, 0)
    assert cart(sensory_space=db.Box([0, 0], [1, 1]))(COMMANDS[:0]).shape == (0, 2)


def test_the_policy_sees_each_step_and_the_observation_before_it():
    seen = []

    def look(command, step, observation):
        seen.append((step, observation))
        return command

    episode = cart(controller=FunctionController(look, HOLD.motor_space)).episode([0.1, 0.2])
    assert [step for step, _ in seen] == list(range(8))
    # Each was kept: the environment writes over what it returned.
    np.testing.assert_array_equal(
        [observation for _, observation in seen], episode.observations[:8]
    )


def test_other_spaces_than_boxes():
    def turn(command, _, observation):
        return int(command[0] > observation / 9)

    walk = GymnasiumEnvironment(
        "FrozenLake-v1",
        FunctionController(turn, db.Box([0], [1])),
        lambda episode: [episode.observations[-1], len(episode)],
        steps=20,
        seed=0,
    )
    assert walk.episode([0.5]).observations[0] == 0
    effects = walk(np.linspace(0, 1, 9)[:, None])
    assert len({tuple(effect) for effect in effects.tolist()}) > 1
    wild = FunctionController(lambda *_: 9, db.Box([0], [1]))
    with pytest.raises(ValueError, match=r"action must be a member of Discrete\(4\), got 9"):
        GymnasiumEnvironment("FrozenLake-v1", wild, last, 5, 0)([0])


# What is refused.


@pytest.mark.parametrize(
    ("wrong", "error", "says"),
    [
        ({"make": "NoSuchThing-v7"}, ValueError, "make must be the id .* 'NoSuchThing-v7'"),
        ({"make": "no such id"}, ValueError, "make must be the id"),
        ({"make": "CartPole-v77"}, ValueError, "make must be the id"),
        ({"make": "nowhere/Thing-v0"}, ValueError, "make must be the id"),
        ({"make": "no_module_of_this_name:Thing-v0"}, ValueError, "make must be the id"),
        ({"make": dict}, TypeError, r"make must return a gymnasium\.Env, got dict"),
        ({"effect": lambda _: [np.nan, 0]}, ValueError, r"effect\[0\] must be finite"),
        ({"effect": lambda _: None}, TypeError, "effect"),
        ({"effect": lambda _: [[0.0]]}, ValueError, "effect"),
        ({"effect": last, "sensory_space": db.Box([0], [1])}, ValueError, "effect"),
    ],
)
def test_what_turns_out_to_be_wrong(wrong, error, says):
    environment = cart(**wrong)
    for command in ([0, 0], [[0, 0]]):
        with pytest.raises(error, match=says):
            environment(command)


@pytest.mark.parametrize(
    ("action", "error", "says"),
    [
        ([0.0], ValueError, r"action must be of shape \(2,\), got \(1,\)"),
        (0.0, ValueError, r"action must be of shape \(2,\), got \(\)"),
        ([np.nan, 0], ValueError, "action must be finite"),
        ([np.inf, 0], ValueError, "action must be finite"),
        (None, (TypeError, ValueError), "action must be"),
        ("ab", TypeError, "action must be an array of numbers"),
    ],
)
def test_actions_that_are_none(action, error, says):
    environment = cart(controller=FunctionController(lambda *_: action, HOLD.motor_space))
    with pytest.raises(error, match=says):
        environment([0, 0])


def test_a_controller_that_begins_nothing():
    lame = SimpleNamespace(motor_space=HOLD.motor_space, begin=lambda _: 3)
    with pytest.raises(
        TypeError, match=r"controller\.begin must return a callable policy, got int"
    ):
        cart(controller=lame)([0, 0])


def test_effects_of_several_lengths_are_refused():
    uneven = cart(effect=lambda episode: [0.0] * len(episode))
    with pytest.raises(ValueError, match="effect"):
        uneven([[0, 0], [1, 0]])


# Environments are made when they are needed, one for each thread, and closed.


class Counted(Cart):
    made, closed = 0, 0


@pytest.fixture
def counted():
    Counted.made = Counted.closed = 0
    return cart(make=Counted)


def test_made_when_needed_and_used_again(counted):
    assert Counted.made == 0
    counted(COMMANDS)
    counted(COMMANDS[0])
    assert (Counted.made, Counted.closed) == (1, 0)
    counted.close()
    counted.close()
    assert (Counted.made, Counted.closed) == (1, 1)
    with counted as same:
        assert same is counted
        counted(COMMANDS[0])
    assert (Counted.made, Counted.closed) == (2, 2)


def test_threads_in_an_episode_have_an_environment_each(counted):
    both = threading.Barrier(2, timeout=60)

    def meet(command, step, observation):  # noqa: ARG001
        if step == 0:
            both.wait()
        return command

    meeting = replace(counted, controller=FunctionController(meet, HOLD.motor_space))
    with ThreadPoolExecutor(2) as threads:
        effects = list(threads.map(meeting, COMMANDS[:8]))
    assert Counted.made == 2
    np.testing.assert_array_equal(effects, cart()(COMMANDS[:8]))
    meeting.close()
    assert Counted.closed == 2


def test_a_pickle_holds_no_environment(counted):
    counted(COMMANDS)
    copy = pickle.loads(pickle.dumps(counted))  # noqa: S301
    assert Counted.made == 1
    assert copy(COMMANDS).tobytes() == counted(COMMANDS).tobytes()
    assert Counted.made == 2
    assert repr(copy) == repr(counted)
    assert "Counted" in repr(copy)


# Explorations, and executors.

EXPLORE = partial(db.explore, strategy=db.MotorBabbling(), n=40, rng=0)


def count_environments(episode):
    return [Cart.made, os.getpid(), *last(episode)]


def test_each_spawned_process_makes_one_environment_for_all_commands():
    environment = cart(effect=count_environments)
    plain = EXPLORE(environment)
    with ProcessPoolExecutor(2, mp_context=get_context("spawn")) as processes:
        run = EXPLORE(environment, executor=processes, in_flight=2)
    assert run.failures == ()
    assert set(run.effects[:, 0]) == {1.0}
    assert os.getpid() not in run.effects[:, 1]
    found, expected = (
        sorted(np.hstack([each.commands, each.effects[:, 2:]]).tolist()) for each in (run, plain)
    )
    assert found == expected


def test_the_last_few_that_were_unpickled_are_kept():
    pickles = [pickle.dumps(cart(seed=seed)) for seed in range(20)]
    first = [pickle.loads(each) for each in pickles]  # noqa: S301
    again = [pickle.loads(each) for each in pickles[::-1]][::-1]  # noqa: S301
    assert first == again == [cart(seed=seed) for seed in range(20)]
    assert [one is other for one, other in zip(first, again, strict=True)] == [False] * 12 + [
        True
    ] * 8


def test_the_small_environment_is_one_that_gymnasium_knows():
    assert isinstance(Cart(), gymnasium.Env)
