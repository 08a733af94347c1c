"""Strategies of every kind and compositions of them, by what they are called in a test."""

from functools import partial

import optuna
from mabwiser.mab import LearningPolicy

import divbandit as db
from divbandit import bandits as b
from divbandit import goals as g
from divbandit import inverse as i
from divbandit.adapters import MabwiserPolicy, OptunaSampler, QuasiRandomBabbling, RibsEmitter
from divbandit.measures import Entropy, GridCoverage, Sparseness

#: Who draws goals, and who turns them into commands.
GOALS = {
    "uniform goals": g.UniformGoals(),
    "goals on a grid": g.GridGoals([4, 5]),
    "uncovered goals": g.UncoveredGoals(0.1),
    "frontier goals": g.FrontierGoals(0.1),
    "novel goals": g.NovelGoals(3),
    "untried goals": g.UntriedGoals(0.1),
}
INVERSES = {
    "nearest": i.Nearest(0.05),
    "k nearest": i.KNearest(3, 0.05),
    "local regression": i.LocalRegression(8, 0.05),
    "line variation": i.LineVariation(0.05),
    "crossover": i.Crossover(8, 0.05),
    "local Jacobian": i.LocalJacobian(),
}

#: Pairs that differ: each sampler and each model once, and what is far from the nearest effects
#: with what extrapolates.
PAIRS = [
    *((goals, "nearest") for goals in GOALS),
    *(("uniform goals", inverse) for inverse in INVERSES),
    ("novel goals", "local Jacobian"),
    ("uncovered goals", "local regression"),
]

WIDE = db.Box([-2, -3], [2, 3])
RMB, RGB = db.MotorBabbling(), db.GoalBabbling(0.05)


def babblings():
    """Return goal babbling by each goal sampler, with each inverse model, and with boxes."""
    own = {
        "goal babbling": RGB,
        "goal babbling, d = 0": db.GoalBabbling(0.0),
        "goal babbling, d = 1": db.GoalBabbling(1),
        "goal babbling, own goals": db.GoalBabbling(0.2, goals=WIDE),
        "goal babbling, own goals, by a sampler": db.GoalBabbling(goals=g.NovelGoals(2, box=WIDE)),
    }
    pairs = {
        f"{goals}, by {inverse}": db.GoalBabbling(goals=GOALS[goals], inverse=INVERSES[inverse])
        for goals, inverse in PAIRS
    }
    return own | pairs


def composed():
    """Return mixtures, schedules, and ADAPT over them."""
    return {
        "mixture": db.Mixture([RMB, RGB], weights=[0.3, 0.7]),
        "mixture of one": db.Mixture([RGB]),
        "mixture of mixtures": db.Mixture(
            [
                db.Mixture([RMB, db.GoalBabbling(0.5)]),
                db.Mixture([db.GoalBabbling(0.001), RMB], weights=[1, 0]),
            ]
        ),
        "schedule": db.Schedule([(10, RMB), (None, RGB)]),
        "schedule of schedules": db.Schedule(
            [
                (7, db.Schedule([(3, RMB), (2, db.GoalBabbling(0.1))])),
                (5, db.GoalBabbling(0.5)),
                (1, RMB),
            ]
        ),
        "adapt": db.Adapt([RMB, RGB]),
        "adapt, no head start": db.Adapt([RMB, RGB], head_start=0, window=5, alpha=0),
        "adapt of one": db.Adapt([RMB], tau=0.1, window=1, alpha=1),
        "adapt of a schedule": db.Adapt(
            [db.Schedule([(4, RMB), (None, RGB)]), db.GoalBabbling(0.5)]
        ),
        "adapt of adapts": db.Adapt(
            [
                db.Adapt([RMB, db.GoalBabbling(0.5)], tau=0.1, window=7),
                db.Adapt([RGB, db.GoalBabbling(0.001)]),
            ],
            tau=0.05,
            window=11,
        ),
        "adapt, by the grid": db.Adapt([RMB, RGB], reward=b.Gain(GridCoverage(0.05))),
        "adapt, by sparseness": db.Adapt([RMB, RGB], reward=b.Gain(Sparseness()), alpha=0.3),
        "adapt, by entropy": db.Adapt([RMB, RGB], window=7, reward=b.Gain(Entropy([0.1, 0.2]))),
        "adapt by the grid, of an adapt": db.Adapt(
            [db.Adapt([RMB, db.GoalBabbling(0.5)], tau=0.1), RGB], reward=b.Gain(GridCoverage(0.1))
        ),
        "adapt, to a power": db.Adapt([RMB, RGB], tau=0.1, window=7, power=1.5),
        "mixture of adapts": db.Mixture([db.Adapt([RMB, RGB]), RMB]),
        "schedule, then adapt": db.Schedule([(10, RMB), (None, db.Adapt([RMB, RGB]))]),
    }


def bandits():
    """Return bandits of other parts than Adapt's."""
    parts = [RMB, RGB]
    return {
        "bandit, ucb1": b.ucb1(parts, tau=0.02),
        "bandit, ucb1 by sparseness": b.ucb1(parts, reward=b.Gain(Sparseness(3))),
        "bandit, sliding-window ucb": b.sliding_window_ucb(parts, window=20, tau=0.02),
        "bandit, discounted ucb by the grid": b.discounted_ucb(
            parts, gamma=0.9, reward=b.Gain(GridCoverage(0.1))
        ),
        "bandit, thompson by progress": db.Bandit(
            parts, reward=b.CompetenceProgress(), estimator=b.WholePast(), policy=b.Thompson()
        ),
        "bandit, exp3": db.Bandit(parts, tau=0.02, estimator=b.Window(9), policy=b.Exp3(0.2)),
        "bandit, softmax over an exp3s": db.Bandit(
            [
                db.Bandit(
                    [db.GoalBabbling(0.5), RMB],
                    tau=0.1,
                    estimator=b.Discounted(0.95),
                    policy=b.Exp3S(0.3, 0.01),
                ),
                db.GoalBabbling(0.001),
            ],
            tau=0.05,
            estimator=b.RecentWindow(30),
            policy=b.Softmax(0.2),
        ),
        "bandit, greedy": b.discounted_greedy(parts, gamma=0.9, epsilon=0.2, tau=0.02),
        "bandit, the paper's three parts": db.Bandit(
            parts, tau=0.1, estimator=b.Window(7), policy=b.Proportional(power=2)
        ),
    }


def defaults():
    """Return the library's own composition, alone and within others."""
    return {
        "the default": db.default_strategy(0.1),
        "the default, own goals, in a mixture": db.Mixture(
            [db.default_strategy(0.05, goals=WIDE), RMB]
        ),
        "the default's strategies twice": db.Adapt(
            [*b.default_strategies(0.1), *b.default_strategies(0.02)], tau=0.1
        ),
    }


def adapted():
    """Return strategies of other libraries; few of each, as they are slow."""
    return {
        "quasi-random babbling, by Sobol": QuasiRandomBabbling(),
        "adapt, by quasi-random babbling and others": db.Adapt(
            [
                db.Schedule([(9, QuasiRandomBabbling()), (None, QuasiRandomBabbling())]),
                db.GoalBabbling(goals=g.GridGoals(3), inverse=i.LocalRegression(5, 0.05)),
                db.GoalBabbling(inverse=i.KNearest(2, 0.1)),
            ]
        ),
        "steps along lines, of pyribs": RibsEmitter("line", box=WIDE),
        "evolution, of pyribs": RibsEmitter("evolution", box=WIDE, cells=50),
        "tree of Parzen estimators, of Optuna": OptunaSampler(
            partial(optuna.samplers.TPESampler, n_startup_trials=5)
        ),
        "evolution, of Optuna": OptunaSampler(optuna.samplers.CmaEsSampler),
        "bandit by a policy of MABWiser": db.Bandit(
            [RMB, db.GoalBabbling(goals=WIDE)],
            tau=0.05,
            estimator=b.WholePast(),
            policy=MabwiserPolicy(LearningPolicy.UCB1()),
        ),
        "adapt of other libraries": db.Adapt(
            [OptunaSampler(optuna.samplers.RandomSampler), RibsEmitter(box=WIDE)], tau=0.05
        ),
    }


def built_in():
    """Return strategies of the library's own parts, for an environment with a plane of effects."""
    return {"motor babbling": RMB, **babblings(), **composed(), **bandits(), **defaults()}


def compositions():
    """Return all of them."""
    return built_in() | adapted()


NAMES = tuple(compositions())
