"""OneStepEnv: Gymnasium's own checker, and what it must refuse."""

import warnings
from types import SimpleNamespace

import gymnasium
import numpy as np
import pytest
from gymnasium.utils.env_checker import check_env

import divbandit as db
from divbandit.adapters.gymnasium import OneStepEnv
from divbandit.environments.mujoco import reacher
from tests.scripts import printed

UNBOUNDED = db.FunctionEnvironment(lambda x: [x[0], x[0] * x[1], 1.0], db.Box([-1, 0], [1, 5]))


@pytest.mark.parametrize(
    "make",
    [
        lambda: OneStepEnv(db.PlanarArm(20), normalize=True),
        lambda: OneStepEnv(db.PlanarArm(3, limit=1.0)),
        lambda: OneStepEnv(
            db.environments.PushArm(5), reward=lambda _, ball: -abs(ball[0]), normalize=True
        ),
        lambda: OneStepEnv(UNBOUNDED, observation_space=db.Box([-9] * 3, [9] * 3), normalize=True),
        lambda: (
            gymnasium.make(
                "divbandit/OneStep-v0", environment=db.PlanarArm(2), normalize=True
            ).unwrapped
        ),
    ],
    ids=["arm", "no need to normalize", "ball", "function", "by its id"],
)
def test_gymnasiums_checker_has_nothing_to_say(make):
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        check_env(make(), skip_render_check=True)


def test_a_step_is_the_black_box():
    arm = db.PlanarArm(4)
    env = OneStepEnv(arm, reward=lambda command, tip: command[0] + tip[1], normalize=True)
    for action in np.random.default_rng(0).uniform(-1, 1, (50, 4)):
        first, _ = env.reset()
        assert first.tolist() == [0.0, 0.0]
        effect, reward, terminated, truncated, info = env.step(action)
        command = action * arm.limit
        np.testing.assert_allclose(effect, arm(command), atol=1e-13)
        assert reward == pytest.approx(command[0] + effect[1], abs=1e-13)
        assert (terminated, truncated, info) == (True, False, {})
    np.testing.assert_array_equal(OneStepEnv(arm).action_space.high, arm.motor_space.high)


def test_what_is_refused():
    env = OneStepEnv(db.PlanarArm(2), normalize=True)
    with pytest.raises(gymnasium.error.ResetNeeded):
        env.step([0.0, 0.0])
    env.reset()
    for action in ([2.0, 0.0], [np.nan, 0.0], [0.0]):
        with pytest.raises(ValueError, match="action"):
            env.step(action)
    env.step([0.0, 0.0])  # what was refused was no step
    with pytest.raises(gymnasium.error.ResetNeeded):
        env.step([0.0, 0.0])
    with pytest.raises(ValueError, match="observation_space must be given"):
        OneStepEnv(UNBOUNDED)
    narrow = OneStepEnv(UNBOUNDED, observation_space=db.Box([0] * 3, [1e-3] * 3))
    narrow.reset()
    with pytest.raises(ValueError, match="observation_space must hold every effect"):
        narrow.step([1.0, 1.0])
    with pytest.raises(TypeError, match="environment must be callable"):
        OneStepEnv(7)
    with pytest.raises(TypeError, match="reward must be callable"):
        OneStepEnv(db.PlanarArm(2), reward=1.0)


def test_the_checker_is_content_with_what_gymnasium_makes_by_the_id():
    """With renderings and closing, which need an id, checked as well."""
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        env = gymnasium.make(
            "divbandit.adapters.gymnasium:divbandit/OneStep-v0",
            environment=db.PlanarArm(3),
            normalize=True,
        )
        check_env(env.unwrapped)
    env.close()


def test_an_arm_of_mujoco_goes_there_and_back():
    """Gymnasium's Reacher as a black box as an environment of Gymnasium."""
    with reacher() as arm, warnings.catch_warnings():
        warnings.simplefilter("error")
        env = OneStepEnv(arm, normalize=True, observation_space=db.Box([-1, -1], [1, 1]))
        check_env(env, skip_render_check=True)
        env.reset()
        effect = env.step(np.ones(10))[0]
        np.testing.assert_array_equal(effect, arm(arm.motor_space.high))


def test_corners_are_corners():
    low, high = [-0.1, 3.0, 7.0], [0.3, 3.3, 7.0]
    box = db.Box(low, high)
    env = OneStepEnv(db.FunctionEnvironment(lambda x: x, box, box), normalize=True)
    for action, corner in (([-1, -1, -1], low), ([1, 1, 1], high)):
        env.reset()
        assert env.step(action)[0].tolist() == corner
    env.reset()
    np.testing.assert_allclose(env.step([0.5, 0, 0])[0], [0.2, 3.15, 7.0], rtol=1e-15)


def test_the_first_observation_is_in_the_middle_or_as_near_to_0_as_may_be():
    space = gymnasium.spaces.Box(
        np.array([-np.inf, 2.0, -np.inf, 4.0]), np.array([np.inf, np.inf, -3.0, 5.0]), dtype=float
    )
    four = db.FunctionEnvironment(lambda x: [x[0], 2.5, -4.0, 4.5], db.Box([-1], [1]))
    env = OneStepEnv(four, observation_space=space)
    assert env.reset()[0].tolist() == [0.0, 2.0, -3.0, 4.5]
    assert env.step([0.25])[0].tolist() == [0.25, 2.5, -4.0, 4.5]


def test_what_was_observed_does_not_change_with_the_array_of_the_black_box():
    kept = np.zeros(1)

    class Keeps:
        motor_space = sensory_space = db.Box([-1], [1])

        def __call__(self, command):
            kept[:] = command
            return kept

    env = OneStepEnv(Keeps())
    env.reset()
    first = env.step([0.5])[0]
    env.reset()
    env.step([0.75])
    assert first.tolist() == [0.5]


def test_after_an_error_of_the_black_box_the_step_may_be_tried_again():
    tries = []

    def shaky(x):
        tries.append(1)
        if len(tries) == 1:
            raise OSError("no connection")
        return x

    box = db.Box([-1], [1])
    env = OneStepEnv(db.FunctionEnvironment(shaky, box, box))
    env.reset()
    with pytest.raises(OSError, match="no connection"):
        env.step([0.5])
    assert env.step([0.5])[0].tolist() == [0.5]


@pytest.mark.parametrize(
    ("options", "error", "says"),
    [
        ({"normalize": 1}, TypeError, "normalize must be True or False"),
        ({"observation_space": 3}, TypeError, "observation_space must have .low and .high"),
        (
            {"observation_space": SimpleNamespace(low=[1, 1], high=[0, 2])},
            ValueError,
            "observation_space must have low <= high",
        ),
        (
            {"observation_space": SimpleNamespace(low=[0, np.nan], high=[1, 1])},
            ValueError,
            "observation_space must have low <= high",
        ),
        (
            {"observation_space": SimpleNamespace(low="ab", high=[1])},
            TypeError,
            "observation_space must have corners of numbers, got 'ab'",
        ),
        ({"reward": lambda *_: np.nan}, ValueError, "reward must be a finite number"),
        ({"reward": lambda *_: None}, TypeError, "reward must be a number"),
        ({"observation_space": db.Box([0], [1])}, ValueError, "effect"),
    ],
)
def test_other_wrong_arguments(options, error, says):
    def run():
        env = OneStepEnv(db.PlanarArm(2), **options)
        env.reset()
        env.step([0.0, 0.0])

    with pytest.raises(error, match=says):
        run()


def test_nothing_is_registered_before_it_is_asked_for():
    script = (
        "import gymnasium, divbandit.adapters\n"
        "print('divbandit/OneStep-v0' in gymnasium.registry)\n"
        "divbandit.adapters.OneStepEnv\n"
        "print('divbandit/OneStep-v0' in gymnasium.registry)"
    )
    assert printed(script) == "False\nTrue\n"
