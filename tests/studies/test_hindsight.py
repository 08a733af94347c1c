"""hindsight keeps, of all proposals, the one whose effect gains most."""

import math

import numpy as np
from shapely import Point, Polygon

import divbandit as db
from divbandit.paper import setting
from divbandit.studies.hindsight import hindsight


class Told(db.Strategy):
    """Proposes commands from a list, one after the other."""

    def __init__(self, commands):
        self.commands = list(commands)

    def propose(self, history, rng):
        del rng
        return self.commands[len(history)]


LINE = db.FunctionEnvironment(lambda x: [x[0], 0.0], db.Box([-1], [1]), db.Box([-1, -1], [1, 1]))


def test_the_larger_gain_is_kept_and_the_other_forgotten():
    # Step by step: 0.5 against 0.1, both whole discs, by chance; then one that is new wins over
    # one near 0.0, which was kept, and one that is new over one that is known.
    strategies = [Told([[0.0], [0.005], [0.9]]), Told([[0.0], [0.5], [0.5]])]
    kept = hindsight(LINE, strategies, 3, np.random.SeedSequence(0))
    assert kept[:, 0].tolist() == [0.0, 0.5, 0.9]


def test_what_was_not_kept_counts_as_unknown():
    """The second strategy's 0.9 loses at first, by its overlap, and gains a whole disc later."""
    near = setting.TAU / 2
    strategies = [Told([[0.0], [0.5], [0.5]]), Told([[0.0], [near], [0.9]])]
    kept = hindsight(LINE, strategies, 3, np.random.SeedSequence(0))
    assert kept[:, 0].tolist() == [0.0, 0.5, 0.9]


def test_each_of_several_best_ones_is_as_likely():
    """400 first steps, fair: within 4 standard deviations of a half."""
    strategies = [Told([[-0.5]]), Told([[0.5]])]
    first = [hindsight(LINE, strategies, 1, np.random.SeedSequence(k))[0, 0] for k in range(400)]
    assert abs(sum(x > 0 for x in first) / 400 - 0.5) < 4 * 0.5 / math.sqrt(400)


def plainly(arm, d, n, seed):
    """Do the same by brute force: nearest effects by distances, unions of 256-gons by Shapely."""
    rng = np.random.default_rng(seed)
    space, goals = arm.motor_space, arm.sensory_space
    covered = Polygon()
    commands, effects, close = [], [], []
    for _ in range(n):
        proposed = [space.low + rng.random(space.dim) * (space.high - space.low)]
        low, high = space.low, space.high
        if effects:
            goal = goals.low + rng.random(2) * (goals.high - goals.low)
            nearest = commands[int(np.argmin([np.hypot(*(e - goal)) for e in effects]))]
            width = d * (space.high - space.low)
            low, high = np.maximum(low, nearest - width), np.minimum(high, nearest + width)
        proposed.append(low + rng.random(space.dim) * (high - low))
        found = [arm(command) for command in proposed]
        discs = [Point(*effect).buffer(setting.TAU, quad_segs=64) for effect in found]
        one, other = (disc.difference(covered).area for disc in discs)
        u = rng.random()
        if abs(one - other) < 1e-12:  # both whole discs, or both nothing
            chosen = int(u * 2)
        else:
            chosen = int(other > one)
            close.append(abs(one - other))
        commands.append(proposed[chosen])
        effects.append(found[chosen])
        covered = covered.union(discs[chosen])
    return np.array(effects), min(close)


def test_it_is_what_brute_force_finds():
    arm = db.PlanarArm(3)
    strategies = [db.MotorBabbling(), db.GoalBabbling(0.05)]
    kept = hindsight(arm, strategies, 150, np.random.SeedSequence(3))
    plain, closest = plainly(arm, 0.05, 150, np.random.SeedSequence(3))
    assert closest > 4e-4 * np.pi * setting.TAU**2  # what a polygon may be wrong by
    np.testing.assert_allclose(kept, plain, atol=1e-9)
