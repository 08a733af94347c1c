"""GymnasiumEnvironment: the rules of episodes, and three hundred of MuJoCo's, seeded."""

import pickle
from concurrent.futures import ThreadPoolExecutor

import gymnasium
import numpy as np
import pytest

import divbandit as db
from divbandit.environments.mujoco import pusher, reacher


class Counting(gymnasium.Env):
    """Adds actions up; ends where they reach 3, is truncated never."""

    observation_space = gymnasium.spaces.Box(-100, 100, (1,), np.float64)
    action_space = gymnasium.spaces.Box(-1, 1, (1,), np.float64)

    def reset(self, *, seed=None, options=None):  # noqa: ARG002
        super().reset(seed=seed)
        self.total = self.np_random.random()
        return np.array([self.total]), {}

    def step(self, action):
        self.total += float(action[0])
        return np.array([self.total]), 1.0, self.total >= 3, False, {}


def act(command, step, observation):  # noqa: ARG001 - the same at each step
    return command


def last(episode):
    return episode.observations[-1]


def counting(**options):
    controller = db.FunctionController(act, db.Box([-9], [9]))
    return db.GymnasiumEnvironment(Counting, controller, last, 5, 7, **options)


def test_an_episode_is_reset_with_the_seed_clipped_and_ends():
    environment = counting()
    begin = np.random.default_rng(7).random()
    start = environment.episode([0.0]).observations[0]
    assert start == pytest.approx([begin])
    assert environment([0.5]) == pytest.approx(start + 2.5)
    # An action of 9 is clipped to 1; after the third step the episode ends.
    ended = environment.episode([9.0])
    assert len(ended) == 3
    assert ended.terminated
    assert ended.observations[-1] == pytest.approx(start + 3)
    assert environment([[0.5], [0.5]]).tolist() == [environment([0.5]).tolist()] * 2
    environment.close()


@pytest.mark.parametrize("vector", ["sync", "async"])
def test_side_by_side_is_the_same_bits_as_one_by_one(vector):
    commands = np.linspace(-9, 9, 23)[:, None]
    with counting() as alone, counting(envs=3, vector=vector) as many:
        np.testing.assert_array_equal(many(commands), [alone(command) for command in commands])


def test_threads_have_an_environment_each():
    with counting() as environment, ThreadPoolExecutor(3) as executor:
        run = db.explore(environment, db.MotorBabbling(), 60, rng=0, executor=executor, in_flight=3)
        assert len(run.failures) == 0
        np.testing.assert_array_equal(environment(run.commands), run.effects)


def test_it_is_pickled_without_its_environments():
    with counting() as environment:
        before = environment([0.25])
        with pickle.loads(pickle.dumps(environment)) as again:  # noqa: S301 - just written
            np.testing.assert_array_equal(again([0.25]), before)


def explored(make, n=300):
    parts = [db.MotorBabbling(), db.GoalBabbling(0.05)]
    with make() as environment:
        return db.explore(environment, db.Adapt(parts, tau=0.01), n, rng=0)


def primitives(dofs, steps, goals):
    return db.MovementPrimitives(dofs, basis=4, steps=steps, weights=1.5, goals=goals)


@pytest.mark.parametrize(
    ("make", "least"),
    [
        (lambda: reacher(primitives(2, 50, 2.8)), 0.005),
        (lambda: pusher(primitives(7, 100, 1.0)), 0.0003),
        (reacher, 0.005),
        (pusher, 0.003),
    ],
    ids=["reacher, movement primitives", "pusher, movement primitives", "reacher", "pusher"],
)
def test_three_hundred_episodes_of_mujoco(make, least):
    first, second = explored(make), explored(make)
    np.testing.assert_array_equal(first.commands, second.commands)
    np.testing.assert_array_equal(first.effects, second.effects)
    # Half of what this version of MuJoCo gave, or less.
    assert first.coverage(0.01)[-1] > least


def no_env():
    return 7


@pytest.mark.parametrize(
    ("change", "error", "says"),
    [
        ({"make": "Nowhere-v0"}, ValueError, "make"),
        ({"make": 7}, TypeError, "make"),
        ({"make": no_env}, TypeError, "make"),
        ({"controller": 7}, TypeError, "controller"),
        ({"effect": 7}, TypeError, "effect"),
        ({"effect": lambda _: [np.nan]}, ValueError, "effect"),
        ({"steps": 0}, ValueError, "steps"),
        ({"seed": -1}, ValueError, "seed"),
        ({"envs": 0}, ValueError, "envs"),
        ({"vector": "many"}, ValueError, "vector"),
        (
            {"controller": db.FunctionController(lambda *_: [1, 2], db.Box([-9], [9]))},
            ValueError,
            "action",
        ),
        (
            {"controller": db.FunctionController(lambda *_: [np.nan], db.Box([-9], [9]))},
            ValueError,
            "action",
        ),
    ],
)
def test_what_is_refused(change, error, says):
    arguments = {
        "make": Counting,
        "controller": db.FunctionController(act, db.Box([-9], [9])),
        "effect": last,
        "steps": 5,
        "seed": 0,
    } | change
    with pytest.raises(error, match=says):
        db.GymnasiumEnvironment(**arguments)([0.0])
