"""Small Gymnasium environments that tests can look through, and what drives them."""

import gymnasium
import numpy as np

import divbandit as db


class Cart(gymnasium.Env):
    """A cart that each action moves by so much; it falls off beyond +1, with a reset's jitter.

    What it observes is one array that it writes over, as environments may.
    """

    observation_space = gymnasium.spaces.Box(-9.0, 9.0, (2,), dtype=np.float64)
    action_space = gymnasium.spaces.Box(-0.25, 0.25, (2,), dtype=np.float64)
    made, closed = 0, 0

    def __init__(self, *, time=99):
        type(self).made += 1
        self.seen, self.time, self.age = np.zeros(2), time, 0

    def reset(self, *, seed=None, options=None):
        super().reset(seed=seed, options=options)
        self.seen[:] = 0.01 * self.np_random.random(2)
        self.age = 0
        return self.seen, {"age": 0}

    def step(self, action):
        assert action.shape == (2,)
        assert action.dtype == np.float64
        self.seen += action
        self.age += 1
        return self.seen, self.age, bool(self.seen[0] > 1), self.age == self.time, {"age": self.age}

    def close(self):
        type(self).closed += 1


def hold(command, step, observation):  # noqa: ARG001 - a controller's signature
    """Do the same all the time."""
    return command


def last(episode):
    """Return what was observed at the end."""
    return episode.observations[-1]


HOLD = db.controllers.FunctionController(hold, db.Box([-1, -1], [1, 1]))


def cart(**options):
    """Return the cart as a black box."""
    return db.environments.GymnasiumEnvironment(
        **{"make": Cart, "controller": HOLD, "effect": last, "steps": 8, "seed": 3} | options
    )
