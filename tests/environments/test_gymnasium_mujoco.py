"""MuJoCo's Reacher and Pusher, headless: effects, explorations of 300 episodes, reproducible.

Another version of MuJoCo may compute other effects: what is asked of coverages leaves room for it.
Bits are compared within one process or machine alone.
"""

import math
from functools import cache

import gymnasium
import numpy as np
import pytest

import divbandit as db
from divbandit.controllers import ViaPoints
from divbandit.environments.mujoco import (
    PUSHER_DAMPING,
    PUSHER_STEPS,
    PUSHER_STIFFNESS,
    REACHER_STEPS,
    pusher,
    reacher,
)

MAKES = {"reacher": reacher, "pusher": pusher}
IDS = {"reacher": "Reacher-v5", "pusher": "Pusher-v5"}
BODIES = {"reacher": "fingertip", "pusher": "object"}


def primitives(dofs, steps, goals):
    return db.controllers.MovementPrimitives(dofs, basis=4, steps=steps, weights=1.5, goals=goals)


EXPLORED = MAKES | {
    "reacher, movement primitives": lambda: reacher(primitives(2, 50, 2.8)),
    "pusher, movement primitives": lambda: pusher(primitives(7, 100, 1.0)),
}
TAU = 0.01
ADAPT = db.Adapt([db.MotorBabbling(), db.GoalBabbling(0.05)], tau=TAU)


@cache
def three_hundred(name, strategy=ADAPT):
    """Explore for 300 episodes, with environments made for it alone."""
    with EXPLORED[name]() as environment:
        return db.explore(environment, strategy, n=300, rng=0)


@cache
def motor_babbling():
    return three_hundred("pusher", db.MotorBabbling())


def commands_of(environment, n):
    return environment.motor_space.sample_many(n, np.random.default_rng(1))


@pytest.mark.parametrize("name", EXPLORED)
def test_episodes_twice_are_the_same_bits(name):
    first = three_hundred(name)
    with EXPLORED[name]() as environment:
        second = db.explore(environment, ADAPT, n=50, rng=0)
    assert len(first) == 300
    assert first.commands[:50].tobytes() == second.commands.tobytes()
    assert first.effects[:50].tobytes() == second.effects.tobytes()
    assert first.choices[:50].tolist() == second.choices.tolist()
    assert set(first.choices.tolist()) == {0, 1}


@pytest.mark.parametrize(
    ("name", "least"),
    [("reacher, movement primitives", 0.005), ("pusher, movement primitives", 3e-4)],
)
def test_what_movement_primitives_cover(name, least):
    """Half of what this version of MuJoCo gave, or less; no more than 300 discs."""
    assert least < three_hundred(name).coverage(TAU)[-1] < 0.0943


def test_what_the_reacher_covers():
    """Its fingertip reaches 0.21 m; 300 discs of 1 cm apart would cover 0.094 m2."""
    run = three_hundred("reacher")
    assert np.hypot(*run.effects.T).max() < 0.2101 + 0.01
    assert 0.025 < run.coverage(TAU)[-1] < 0.0943


def test_what_the_pusher_covers():
    """Goal babbling learns to push the object, and ADAPT that goal babbling is worth it."""
    area = three_hundred("pusher").coverage(TAU)[-1]
    assert 0.006 < area < 0.06
    assert area > 1.3 * motor_babbling().coverage(TAU)[-1]


def test_most_random_commands_miss_the_object_and_a_fair_share_pushes_it():
    effects = motor_babbling().effects
    with pusher() as environment:
        rest = environment(np.zeros(14))
    way = np.hypot(*(effects - rest).T)
    assert 0.1 < (way > 0.005).mean() < 0.5
    assert (way < 1e-3).mean() > 0.4
    assert way.max() > 0.03


@pytest.mark.parametrize("name", MAKES)
def test_the_effect_is_where_the_simulation_has_the_body(name):
    """The recorded actions are played back in an environment that is made by hand."""
    environment = MAKES[name]()
    env = gymnasium.make(IDS[name])
    for command in commands_of(environment, 3):
        episode = environment.episode(command)
        env.reset(seed=environment.seed)
        for action in episode.actions:
            env.step(action)
        body = env.unwrapped.get_body_com(BODIES[name])[:2]
        np.testing.assert_allclose(environment(command), body, rtol=0, atol=1e-12)
        assert len(episode) == environment.steps
    env.close()
    environment.close()


@pytest.mark.parametrize("name", MAKES)
def test_every_episode_begins_alike(name):
    with MAKES[name]() as environment:
        commands = commands_of(environment, 3)
        starts = [environment.episode(command).observations[0].tobytes() for command in commands]
        assert len(set(starts)) == 1
        again = [environment(command) for command in commands[::-1]][::-1]
        assert environment(commands).tobytes() == np.stack(again).tobytes()


def test_the_pusher_s_joints_follow_as_far_as_springs_and_dampers_do():
    """The first actions, worked out by hand from what was observed."""
    with pusher() as environment:
        (command,) = commands_of(environment, 1)
        episode = environment.episode(command)
        rows = environment.controller.primitives.trajectory(command)
    for step in range(PUSHER_STEPS):
        seen = episode.observations[step]
        for joint in range(7):
            speed = (rows[step + 1, joint] - rows[step, joint]) / 0.05
            pull = PUSHER_STIFFNESS[joint] * (rows[step + 1, joint] - seen[joint])
            pull += PUSHER_DAMPING[joint] * (speed - seen[7 + joint])
            assert episode.actions[step, joint] == pytest.approx(min(max(pull, -2), 2), abs=1e-6)


def test_the_reacher_s_first_joint_can_be_led_round_and_round():
    """What is observed are cosine and sine; beyond pi the joint goes on."""
    far = 3.5 * math.pi
    round_and_round = ViaPoints([-far, -1], [far, 1], steps=REACHER_STEPS)
    with reacher(round_and_round) as environment:
        slow = environment.episode([far, 0.0])
    angles = np.unwrap(np.arctan2(slow.observations[:, 2], slow.observations[:, 0]))
    assert angles[-1] > 2 * math.pi


@pytest.mark.parametrize("make", MAKES.values(), ids=MAKES)
def test_wrong_primitives(make):
    with pytest.raises(TypeError, match="primitives must have motor_space and trajectory"):
        make(3)
    with make(ViaPoints([-1] * 3, [1] * 3, steps=5)) as three_joints, pytest.raises(ValueError):  # noqa: PT011
        three_joints(np.zeros(3))
