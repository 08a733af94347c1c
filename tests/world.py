"""One of everything that can be called, and all that a failed call must leave as it was."""

import numpy as np

import divbandit as db
from divbandit.experiments import Task
from divbandit.measures import Entropy, GridCoverage, Sparseness
from tests.generators import state

RMB = db.MotorBabbling()


class InTurn(db.Composite):
    def choose(self, history, rng):
        del rng
        return len(history) % len(self.strategies)


class World:
    """One of everything, with something in it."""

    def __init__(self):
        self.arm = db.PlanarArm(2, limit=1.0)
        self.box = db.Box([-1, -1], [1, 1])
        self.environment = db.FunctionEnvironment(lambda x: x, self.box, self.box)
        self.rng = np.random.default_rng(0)
        self.run = db.explore(self.arm, RMB, n=3, rng=self.rng)
        self.history = db.History(self.box, self.box)
        self.coverage, self.tree = db.Coverage(0.5), db.NearestNeighbors(2)
        self.grid, self.sparseness = (GridCoverage(0.3).start(2), Sparseness(2).start(2))
        self.entropy = Entropy(0.3).start(2)
        self.explorer = db.Explorer(RMB, self.box, self.box, rng=self.rng)
        for effect in ([0.0, 0.0], [0.5, 0.25], [1.0, 0.0]):
            self.history.append(effect, effect)
            for measure in self.measures():
                measure.add(effect)
            self.tree.add(effect)
            self.explorer.tell(self.explorer.ask(), effect)
        self.task = Task(self.arm, RMB, 3)
        self.trial = self.explorer.ask()
        self.by_hand = db.Trial([0.0, 0.0])

    def past(self):
        return self.history, self.rng

    def measures(self):
        return self.coverage, self.grid, self.sparseness, self.entropy

    def state(self):
        logs = (self.explorer.history, self.history)
        return (
            [(log.commands.tolist(), log.effects.tolist(), log.paths) for log in logs],
            self.history.nearest([0.4, 0.3], k=3)[1].tolist(),
            [(len(each), each.measure, each.gain([0.7, 0.7])) for each in self.measures()],
            (len(self.tree), self.tree.nearest([0.4, 0.3], k=3)[1].tolist()),
            state(self.rng),
        )
