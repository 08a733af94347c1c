"""A black box whose effects are written down, and a measure by which each gains its value."""

import numpy as np

import divbandit as db

UNIT = db.Box([0], [1])


class Total:
    """The sum of effects that are numbers; it counts how often each is added."""

    dim, largest_gain = 1, 1.0

    def start(self, dim):
        if dim != 1:
            raise ValueError(f"effects must be numbers, got points of R^{dim}")
        self.seen = []
        return self

    def __len__(self):
        return len(self.seen)

    @property
    def measure(self):
        return float(sum(self.seen))

    def add(self, effect):
        return float(self.extend([effect])[0])

    def extend(self, effects):
        self.seen += [float(effect[0]) for effect in effects]
        return np.array([float(effect[0]) for effect in effects])

    def gain(self, effect):
        return float(effect[0])


def scripted(effects):
    """Return a black box with these effects, one after the other; None is a failure."""
    remaining = iter(effects)

    def next_effect(command):
        del command
        effect = next(remaining)
        if effect is None:
            raise ValueError("it fell")
        return [effect]

    return db.FunctionEnvironment(next_effect, UNIT)


def explorer(strategy=None):
    """Return an explorer of such a black box."""
    return db.Explorer(strategy or db.MotorBabbling(), UNIT, rng=0)
