"""Every built-in strategy and many compositions of them, by what they are called in a test."""

from functools import partial

import optuna
from mabwiser.mab import LearningPolicy

import divbandit as db
from divbandit.adapters import MabwiserPolicy, OptunaSampler, QuasiRandomBabbling, RibsEmitter
from divbandit.bandits import Gain, WholePast

#: Who draws goals, and who turns them into commands.
GOALS = {
    "uniform goals": db.goals.UniformGoals,
    "goals on a grid": lambda: db.goals.GridGoals([4, 5]),
    "uncovered goals": lambda: db.goals.UncoveredGoals(0.1),
    "frontier goals": lambda: db.goals.FrontierGoals(0.1),
    "novel goals": lambda: db.goals.NovelGoals(3),
    "untried goals": lambda: db.goals.UntriedGoals(0.1),
}
INVERSES = {
    "nearest neighbour": lambda: db.inverse.Nearest(0.05),
    "k nearest": lambda: db.inverse.KNearest(3, 0.05),
    "local regression": lambda: db.inverse.LocalRegression(8, 0.05),
    "local Jacobian": db.inverse.LocalJacobian,
}


def pairs():
    """Return goal babbling by each goal sampler with each inverse model."""
    return {
        f"{goals}, by {inverse}": db.GoalBabbling(goals=GOALS[goals](), inverse=INVERSES[inverse]())
        for goals in GOALS
        for inverse in INVERSES
    }


def plain():
    """Return fresh strategies, and the bandit Adapt over them."""
    rmb, rgb = db.MotorBabbling, db.GoalBabbling
    wide = db.Box([-2, -3], [2, 3])
    return {
        "motor babbling": rmb(),
        "goal babbling": rgb(0.05),
        "goal babbling, d = 0": rgb(0.0),
        "goal babbling, d = 1": rgb(1),
        "goal babbling, own goals": rgb(0.2, goals=wide),
        "mixture": db.Mixture([rmb(), rgb(0.05)], weights=[0.3, 0.7]),
        "mixture of one": db.Mixture([rgb(0.05)]),
        "mixture of mixtures": db.Mixture(
            [db.Mixture([rmb(), rgb(0.5)]), db.Mixture([rgb(0.001), rmb()], weights=[1, 0])]
        ),
        "schedule": db.Schedule([(10, rmb()), (None, rgb(0.05))]),
        "schedule of schedules": db.Schedule(
            [(7, db.Schedule([(3, rmb()), (2, rgb(0.1))])), (5, rgb(0.5)), (1, rmb())]
        ),
        "adapt": db.Adapt([rmb(), rgb(0.05)]),
        "adapt, no head start": db.Adapt([rmb(), rgb(0.05)], head_start=0, window=5, alpha=0),
        "adapt of one": db.Adapt([rmb()], tau=0.1, window=1, alpha=1),
        "adapt of a schedule": db.Adapt([db.Schedule([(4, rmb()), (None, rgb(0.05))]), rgb(0.5)]),
        "adapt of adapts": db.Adapt(
            [db.Adapt([rmb(), rgb(0.5)], tau=0.1, window=7), db.Adapt([rgb(0.05), rgb(0.001)])],
            tau=0.05,
            window=11,
        ),
        "adapt, by the grid": db.Adapt(
            [rmb(), rgb(0.05)], reward=Gain(db.measures.GridCoverage(0.05))
        ),
        "adapt, by sparseness": db.Adapt(
            [rmb(), rgb(0.05)], reward=Gain(db.measures.Sparseness()), alpha=0.3
        ),
        "adapt, by entropy": db.Adapt(
            [rmb(), rgb(0.05)], window=7, reward=Gain(db.measures.Entropy([0.1, 0.2]))
        ),
        "adapt by the grid, of an adapt": db.Adapt(
            [db.Adapt([rmb(), rgb(0.5)], tau=0.1), rgb(0.05)],
            reward=Gain(db.measures.GridCoverage(0.1)),
        ),
        **pairs(),
        "goal babbling, own goals, by a sampler": rgb(goals=db.goals.NovelGoals(2, box=wide)),
        "quasi-random babbling, by Sobol": QuasiRandomBabbling(),
        "adapt, by quasi-random babbling and others": db.Adapt(
            [
                db.Schedule([(9, QuasiRandomBabbling()), (None, QuasiRandomBabbling())]),
                rgb(goals=db.goals.GridGoals(3), inverse=db.inverse.LocalRegression(5, 0.05)),
                rgb(inverse=db.inverse.KNearest(2, 0.1)),
            ]
        ),
        "mixture of adapts": db.Mixture([db.Adapt([rmb(), rgb(0.05)]), rmb()]),
        "schedule, then adapt": db.Schedule([(10, rmb()), (None, db.Adapt([rmb(), rgb(0.05)]))]),
        **adapted(),
    }


def adapted():
    """Return strategies of other libraries; few of each, as they are slow."""
    wide = db.Box([-2, -3], [2, 3])
    return {
        "steps along lines, of pyribs": RibsEmitter("line", box=wide),
        "evolution, of pyribs": RibsEmitter("evolution", box=wide, cells=50),
        "tree of Parzen estimators, of Optuna": OptunaSampler(
            partial(optuna.samplers.TPESampler, n_startup_trials=5)
        ),
        "evolution, of Optuna": OptunaSampler(optuna.samplers.CmaEsSampler),
        "bandit by a policy of MABWiser": db.Bandit(
            [db.MotorBabbling(), db.GoalBabbling(goals=wide)],
            tau=0.05,
            estimator=WholePast(),
            policy=MabwiserPolicy(LearningPolicy.UCB1()),
        ),
        "adapt of other libraries": db.Adapt(
            [OptunaSampler(optuna.samplers.RandomSampler), RibsEmitter(box=wide)], tau=0.05
        ),
    }


def compositions():
    """Return fresh strategies for an environment with a plane of effects."""
    return plain() | bandits() | defaults()


def bandits():
    """Return fresh bandits of other parts than Adapt's."""
    parts, b = [db.MotorBabbling(), db.GoalBabbling(0.05)], db.bandits
    return {
        "bandit, ucb1": b.ucb1(parts, tau=0.02),
        "bandit, ucb1 by sparseness": b.ucb1(parts, reward=b.Gain(db.measures.Sparseness(3))),
        "bandit, sliding-window ucb": b.sliding_window_ucb(parts, window=20, tau=0.02),
        "bandit, discounted ucb by the grid": b.discounted_ucb(
            parts, gamma=0.9, reward=b.Gain(db.measures.GridCoverage(0.1))
        ),
        "bandit, thompson by progress": db.Bandit(
            parts, reward=b.CompetenceProgress(), estimator=b.WholePast(), policy=b.Thompson()
        ),
        "bandit, exp3": db.Bandit(parts, tau=0.02, estimator=b.Window(9), policy=b.Exp3(0.2)),
        "bandit, softmax over an exp3s": db.Bandit(
            [
                db.Bandit(
                    [db.GoalBabbling(0.5), db.MotorBabbling()],
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
        "bandit, greedy": db.Bandit(
            parts, tau=0.02, estimator=b.Discounted(0.9), policy=b.EpsilonGreedy(0.2)
        ),
        "the paper's three parts": db.Bandit(
            parts, tau=0.1, estimator=b.Window(7), policy=b.Proportional(power=2)
        ),
        "adapt, to a power": db.Adapt(parts, tau=0.1, window=7, power=1.5),
    }


def defaults():
    """Return the library's own composition, alone and within others."""
    wide = db.Box([-2, -3], [2, 3])
    return {
        "the default": db.default_strategy(0.1),
        "the default, own goals, in a mixture": db.Mixture(
            [db.default_strategy(0.05, goals=wide), db.MotorBabbling()]
        ),
        "the default's strategies twice": db.Adapt(
            [*db.bandits.default_strategies(0.1), *db.bandits.default_strategies(0.02)], tau=0.1
        ),
    }


NAMES = tuple(compositions())
