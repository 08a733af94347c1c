"""The explorations whose traces are kept, by name."""

from __future__ import annotations

from dataclasses import dataclass

from numpy.random import MT19937, PCG64, PCG64DXSM, SFC64, BitGenerator, Generator, Philox

import divbandit as db

RMB, RGB = db.MotorBabbling, db.GoalBabbling
ARM = db.PlanarArm(20)


@dataclass(frozen=True)
class Configuration:
    """An arm, a strategy, how many steps, and the bit generator, of seed 0."""

    strategy: db.Strategy
    arm: db.Environment = ARM
    n: int = 1000
    bit_generator: type[BitGenerator] = PCG64

    def explore(self, engine):
        """Return the run, and the draw that follows."""
        rng = Generator(self.bit_generator(0))
        run = db.explore(self.arm, self.strategy, self.n, rng=rng, engine=engine)
        return run, rng.random()


def paper_adapt(d):
    return db.Adapt([RMB(), RGB(d)], tau=0.02, window=50, alpha=0.1, head_start=1)


def figures():
    """Yield explorations as in the paper's figures, each with its name."""
    yield "figure 1", Configuration(RMB(), n=2000)
    for d in (0.001, 0.05, 0.5):
        schedule = db.Schedule([(10, RMB()), (None, RGB(d))])
        yield f"figure 2, d = {d}", Configuration(schedule, n=2000)
    for d in (0.001, 0.05, 0.5):
        yield f"figure 3, d = {d}", Configuration(paper_adapt(d), n=2000)
    mixture = db.Mixture([RMB(), RGB(0.05)], weights=[0.35, 0.65])
    yield "figure 4, a mixture", Configuration(mixture, n=2000)


def nested():
    """Yield compositions of several levels, each with its name."""
    deep = db.Adapt([RMB(), RGB(0.5)], tau=0.05, window=3, head_start=2)
    adapts = db.Adapt(
        [
            db.Adapt([RMB(), RGB(0.05)], tau=0.1, window=7, alpha=0.2, head_start=0),
            db.Adapt([RGB(0.001), deep], tau=0.02, window=1),
            RMB(),
        ],
        tau=0.03,
        window=20,
    )
    yield "adapts in an adapt", Configuration(adapts, n=2000)
    first = db.Schedule([(7, RMB()), (5, RGB(0.1)), (3, RMB())])
    schedules = db.Schedule([(20, first), (50, RGB(1)), (None, paper_adapt(0.01))])
    yield "schedules", Configuration(schedules)
    shared = db.Schedule([(20, RMB()), (None, paper_adapt(0.05))])
    mixture = db.Mixture([shared, db.Mixture([shared, RGB(0)]), RMB()], weights=[0.5, 1, 0.25])
    yield "a schedule in two places", Configuration(mixture)


def settings():
    """Yield bandits of other settings than the paper's, each with its name."""
    parts = [RMB(), RGB(0.05), RGB(0.5)]
    yield "alpha 1", Configuration(db.Adapt(parts, alpha=1))
    yield "window 1, alpha 0", Configuration(db.Adapt(parts, window=1, alpha=0))
    yield "no head start", Configuration(db.Adapt(parts, tau=0.2, head_start=0))
    measured = db.Adapt(parts, tau=0.1, window=20, head_start=20)
    yield "a measure given", Configuration(measured)


def arms():
    """Yield explorations of other arms than the paper's, each with its name."""
    adapt = paper_adapt(0.05)
    yield "1 joint", Configuration(adapt, arm=db.PlanarArm(1))
    yield "40 joints", Configuration(adapt, arm=db.PlanarArm(40), n=500)
    yield "a tight limit", Configuration(adapt, arm=db.PlanarArm(20, limit=0.01))
    yield "many turns", Configuration(adapt, arm=db.PlanarArm(7, limit=40.0), n=500)
    spaces = db.Box([-1.0, 0.25, -2.0], [0.5, 0.25, 2.5]), db.Box([0.0, -1e9], [1.0, 1e9])
    narrow = db.FunctionEnvironment(db.PlanarArm(3), *spaces)
    yield "spaces of one's own", Configuration(adapt, arm=narrow)


def streams():
    """Yield explorations from other streams of randomness, each with its name."""
    for kind in (PCG64DXSM, MT19937, Philox, SFC64):
        yield kind.__name__, Configuration(paper_adapt(0.05), n=500, bit_generator=kind)


CONFIGURATIONS = dict([*figures(), *nested(), *settings(), *arms(), *streams()])
