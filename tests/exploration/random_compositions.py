"""Compositions drawn at random of all the library's own parts, nested, with shared parts."""

import numpy as np
from hypothesis import strategies as st

import divbandit as db
from divbandit import bandits, goals, inverse, measures

#: How deep composites nest; a single strategy is 0 deep.
DEEPEST = 3

SHARES = st.one_of(st.sampled_from([0, 1e-3, 0.05, 0.5, 1]), st.floats(0, 1))
STRICT_SHARES = st.sampled_from([1e-3, 0.1, 0.5, 0.99])
WEIGHTS = st.one_of(st.sampled_from([0.0, 1e-300, 0.3, 1.0, 1e300]), st.floats(0, 10))
TAUS = st.one_of(st.sampled_from([1e-3, 0.02, 0.1, 10.0]), st.floats(-3, 1).map(lambda x: 10.0**x))
POWERS = st.sampled_from([0.0, 0.5, 1.0, 1.0, 1.0, 3.0, 8.0])
COUNTS = st.integers(1, 12)
CORNERS = st.one_of(st.sampled_from([0.0, -0.0, 1.0, 1e6, -1e9, 1e200]), st.floats(-2, 2))
WIDTHS = st.one_of(st.sampled_from([0.0, 1e-9, 1e6]), st.floats(0, 3))


@st.composite
def boxes(draw, dim=2):
    """Draw a box of effects: around those that there are, far away, or flat."""
    if draw(st.booleans()):
        return db.Box([-1.0] * dim, [1.0] * dim)
    low = [draw(CORNERS) for _ in range(dim)]
    return db.Box(low, [corner + draw(WIDTHS) for corner in low])


@st.composite
def compositions(draw, *, dim=2, needs_goals=False):
    """Draw a strategy for effects of `dim` dimensions.

    With `needs_goals` all goal babbling in it has goals of its own. A part may be the very same
    object as another one, whose state it then shares.
    """
    return _Drawing(draw, dim, needs_goals=needs_goals).part(DEEPEST)


def depth_of(strategy):
    """Return how deep composites nest in it; 0 if it is none."""
    return 1 + max(map(depth_of, strategy.strategies)) if hasattr(strategy, "strategies") else 0


class _Drawing:
    """The draw of one composition: what is known of it so far."""

    def __init__(self, draw, dim, *, needs_goals):
        self.draw, self.dim, self.needs_goals = draw, dim, needs_goals
        self.made = []  # strategies, with their depths
        self.shared = {}  # rewards, samplers and others by kind

    def one_of(self, *values):
        return self.draw(st.sampled_from(values))

    def once_in(self, n):
        """Draw whether to do what is done once in `n` times."""
        return self.draw(st.integers(1, n)) == n

    def maybe_shared(self, kind, make):
        """Draw a part, perhaps one that stands elsewhere already."""
        known = self.shared.setdefault(kind, [])
        if known and self.once_in(3):
            return self.one_of(*known)
        known.append(make())
        return known[-1]

    def part(self, deepest):
        """Draw a strategy at most `deepest` deep."""
        known = [part for part, depth in self.made if depth <= deepest]
        if known and self.once_in(5):
            return self.one_of(*known)
        makers = [self.motor_babbling, self.goal_babbling, self.goal_babbling]
        if deepest > 0:
            composed = [self.adapt, self.bandit, self.bandit, self.named]
            makers = [*composed, self.mixture, self.schedule, *makers]
        part = self.one_of(*makers)(deepest)
        self.made.append((part, depth_of(part)))
        return part

    def parts(self, deepest):
        return [self.part(deepest - 1) for _ in range(self.one_of(1, 2, 2, 3))]

    def motor_babbling(self, _):
        return db.MotorBabbling()

    def goal_babbling(self, _):
        if self.once_in(3):
            box = self.draw(boxes(self.dim)) if self.needs_goals else None
            return db.GoalBabbling(self.draw(SHARES), goals=box)
        sampler = self.maybe_shared("goals", self.sampler)
        return db.GoalBabbling(goals=sampler, inverse=self.maybe_shared("inverse", self.model))

    def sampler(self):
        own = self.needs_goals or self.once_in(2)
        box = self.draw(boxes(self.dim)) if own else None
        kind = self.one_of(*goals.__all__)
        tau = self.draw(TAUS)
        if kind == "UncoveredGoals":
            return goals.UncoveredGoals(tau, tries=self.draw(COUNTS), box=box)
        if kind == "FrontierGoals":
            return goals.FrontierGoals(tau, box=box)
        if kind == "NovelGoals":
            return goals.NovelGoals(self.draw(COUNTS), box=box)
        if kind == "UntriedGoals":
            numbers = {"candidates": self.draw(COUNTS), "tries": self.draw(COUNTS)}
            return goals.UntriedGoals(tau, reach=self.one_of(1, 4, 1e6), box=box, **numbers)
        if kind == "GridGoals":
            cells = [self.one_of(1, 2, 5) for _ in range(self.dim)]
            return goals.GridGoals(self.one_of(3, tuple(cells)), box=box)
        return goals.UniformGoals(box)

    def model(self):
        k, d, ridge = self.draw(COUNTS), self.draw(SHARES), self.one_of(1e-9, 1e-3, 1.0)
        kind = self.one_of(*(name for name in inverse.__all__ if name != "InverseModel"))
        if kind == "Nearest":
            return inverse.Nearest(d)
        if kind == "KNearest":
            return inverse.KNearest(k, d)
        if kind == "LineVariation":
            return inverse.LineVariation(d, along=self.one_of(0.0, 0.2, 10.0))
        if kind == "Crossover":
            return inverse.Crossover(self.one_of(k, 100), d)
        if kind == "LocalRegression":
            return inverse.LocalRegression(k, d, ridge=ridge, reach=self.one_of(0.1, 1.0, 50.0))
        options = {"ridge": ridge, "reach": d, "noise": self.draw(SHARES)}
        return inverse.LocalJacobian(self.one_of(k, 50), self.draw(COUNTS), **options)

    def mixture(self, deepest):
        parts = self.parts(deepest)
        if self.once_in(2):
            return db.Mixture(parts)
        weights = [self.draw(WEIGHTS) for _ in parts]
        if not any(weights):
            weights[self.draw(st.integers(0, len(parts) - 1))] = 1.0
        return db.Mixture(parts, weights=weights)

    def schedule(self, deepest):
        parts = self.parts(deepest)
        steps = [self.draw(st.integers(1, 20)) for _ in parts]
        if self.once_in(2):
            steps[-1] = None
        return db.Schedule(zip(steps, parts, strict=True))

    def adapt(self, deepest):
        window = self.draw(st.integers(1, 60))
        return db.Adapt(
            self.parts(deepest),
            window=window,
            alpha=self.draw(SHARES),
            head_start=self.draw(st.sampled_from([0, 1, window])),
            power=self.draw(POWERS),
            **self.rewarded(),
        )

    def bandit(self, deepest):
        estimator = self.maybe_shared("estimator", self.estimator)
        policy = self.maybe_shared("policy", self.policy)
        parts = self.parts(deepest)
        return db.Bandit(parts, estimator=estimator, policy=policy, **self.rewarded())

    def named(self, deepest):
        parts, by = self.parts(deepest), self.rewarded()
        gamma = self.draw(STRICT_SHARES)
        makers = (
            lambda: bandits.ucb1(parts, **by),
            lambda: bandits.sliding_window_ucb(parts, window=self.draw(COUNTS), **by),
            lambda: bandits.discounted_ucb(parts, gamma=gamma, **by),
            lambda: bandits.discounted_adapt(parts, gamma=gamma, **by),
            lambda: bandits.discounted_greedy(parts, gamma=gamma, **by),
            self.default,
        )
        return self.one_of(*makers)()

    def default(self):
        box = self.draw(boxes(self.dim)) if self.needs_goals else None
        return db.default_strategy(self.draw(TAUS), goals=box)

    def rewarded(self):
        """Draw what strategies are rewarded for."""
        if self.once_in(3):
            return {"tau": self.draw(TAUS)}
        return {"reward": self.maybe_shared("reward", self.reward)}

    def reward(self):
        if self.once_in(3):
            return bandits.CompetenceProgress()
        return bandits.Gain(self.maybe_shared("measure", self.measure))

    def measure(self):
        kind = self.one_of("BallCoverage", "CellCoverage", "GridCoverage", "Sparseness", "Entropy")
        if kind == "BallCoverage":  # coarse where it has to be estimated
            return measures.BallCoverage(self.draw(TAUS), accuracy=self.one_of(0.05, 0.2))
        if kind == "CellCoverage":
            return measures.CellCoverage(self.one_of(1, 7), self.draw(boxes(self.dim)))
        if kind == "Sparseness":
            return measures.Sparseness(self.draw(COUNTS))
        cell = self.one_of(0.1, [self.one_of(0.05, 0.3, 2.0) for _ in range(self.dim)])
        origin = self.one_of(0.0, 0.07, np.linspace(-1, 1, self.dim))
        cells = measures.GridCoverage if kind == "GridCoverage" else measures.Entropy
        return cells(cell, origin=origin)

    def estimator(self):
        size, gamma = self.draw(st.integers(1, 60)), self.draw(STRICT_SHARES)
        return self.one_of(
            bandits.Window(size, head_start=self.one_of(0, 1, size)),
            bandits.RecentWindow(size),
            bandits.Discounted(gamma, head_start=self.one_of(0, 1, 3)),
            bandits.WholePast(),
        )

    def policy(self):
        share, strict = self.draw(SHARES), self.draw(STRICT_SHARES)
        return self.one_of(
            bandits.Proportional(share, power=self.draw(POWERS)),
            bandits.EpsilonGreedy(share),
            bandits.Softmax(self.draw(TAUS), scaled=self.once_in(2)),
            bandits.UCB(self.one_of(0.0, 0.6, 2.0)),
            bandits.Thompson(),
            bandits.Exp3(strict),
            bandits.Exp3S(strict, self.one_of(1e-3, 0.1)),
            bandits.RoundRobin(),
            bandits.Uniform(),
        )
