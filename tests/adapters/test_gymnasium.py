"""OneStepEnv: Gymnasium's own checker, and what it must refuse."""

import warnings

import gymnasium
import numpy as np
import pytest
from gymnasium.utils.env_checker import check_env

import divbandit as db
from divbandit.adapters.gymnasium import OneStepEnv

UNBOUNDED = db.FunctionEnvironment(lambda x: [x[0], x[0] * x[1], 1.0], db.Box([-1, 0], [1, 5]))


@pytest.mark.parametrize(
    "make",
    [
        lambda: OneStepEnv(db.PlanarArm(20), normalize=True),
        lambda: OneStepEnv(db.PlanarArm(3, limit=1.0)),
        lambda: OneStepEnv(db.PushArm(5), reward=lambda _, ball: -abs(ball[0]), normalize=True),
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
