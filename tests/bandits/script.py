"""Bandits driven by a script: what they draw and what comes of their choices are given.

Each runs in Python and in the engine, which must do the same.
"""

import pytest

import divbandit as db
from tests.generators import draw_from, draws_from, scripted

SPACE = db.Box([0], [1])
PLANE = db.Box([0, 0], [1, 1])

both_engines = pytest.mark.parametrize("engine", ["python", "rust"])


class Drive:
    """A bandit under way over `count` strategies, step by step.

    A step chooses strategy `index` by drawing the numbers that lead there, and observes an
    effect that is new (far from all others: its gain is a ball) or old (its gain is 0). The
    strategies propose the only command there is.
    """

    def __init__(self, engine, count=2, **parameters):
        point = db.Box([0.5], [0.5])
        babblings = [db.MotorBabbling() for _ in range(count)]
        self.adapt = db.Adapt(babblings, **parameters)
        self.explorer = db.Explorer(self.adapt, point, PLANE, engine=engine)
        self.fresh = 0

    @property
    def estimates(self):
        return self.explorer.estimates

    def ask(self, *numbers):
        """Return a trial for which these numbers were drawn, and one for the command."""
        draw_from(self.explorer, scripted(*numbers, 0.5))
        trial = self.explorer.ask()
        assert draws_from(self.explorer.rng) == len(numbers) + 1
        return trial

    def step(self, index, *, new):
        """Let a strategy propose, and observe."""
        trial = self.ask(0.0, self._towards(index))
        assert trial.path == (index,)
        self.fresh += new
        self.explorer.tell(trial, [10.0 * self.fresh, 0.0])
        return self.estimates

    def _towards(self, index):
        """Return what leads to a strategy: by chance, or where alpha is 0 in its share."""
        count = len(self.estimates)
        weights = [max(0.0, mean) for mean in self.estimates]
        if self.adapt.alpha > 0 or max(weights) == 0:
            return (index + 0.5) / count
        assert weights[index] > 0
        return (sum(weights[:index]) + 0.5 * weights[index]) / sum(weights)

    def choice(self, *numbers):
        """Return which strategy the numbers lead to; nothing is told."""
        return self.ask(*numbers).path[0]
