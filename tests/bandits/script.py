"""A bandit driven by a script: what it draws and what comes of its choices are given."""

import numpy as np

import divbandit as db

SPACE = db.Box([0], [1])


class Scripted:
    """Stands in for a generator; its numbers are given beforehand."""

    def __init__(self, *numbers):
        self.numbers = list(numbers)

    def random(self):
        return self.numbers.pop(0)


def towards(index, count):
    """Return numbers that lead an Adapt to choose `index` of `count`.

    The first lies below any positive alpha, so that the second chooses uniformly.
    """
    return Scripted(0.0, (index + 0.5) / count)


class Always(db.Strategy):
    """Proposes the same command each time, and draws nothing."""

    def propose(self, history, rng):
        del history, rng
        return [0.5]


class Drive:
    """An Adapt over `count` strategies and its history, step by step.

    A step chooses strategy `index` by drawing the numbers that lead there, and observes an
    effect that is new (far from all others: its gain is a ball) or old (its gain is 0).
    """

    def __init__(self, count=2, **parameters):
        self.adapt = db.Adapt([Always() for _ in range(count)], **parameters)
        self.history = db.History(SPACE, db.Box([0, 0], [1, 1]))
        self.fresh = 0

    def step(self, index, *, new):
        count = len(self.adapt.strategies)
        trial = self.adapt.propose(self.history, towards(index, count))
        assert trial.path == (index,)
        self.fresh += new
        effect = np.array([10.0 * self.fresh, 0.0])
        self.history.append(trial.command, effect, path=trial.path)
        self.adapt.observe(trial, effect)
        return self.adapt.diversities

    def choice(self, *numbers):
        return self.adapt.choose(self.history, Scripted(*numbers))
