"""Every public entry point, its arguments, and what is passed for each by mistake."""

import math
from types import SimpleNamespace

import numpy as np

import divbandit as db
from divbandit import bandits as b
from divbandit import controllers as c
from divbandit import environments as e
from divbandit import experiments
from divbandit import goals as g
from divbandit import inverse as i
from divbandit import measures as m
from divbandit.experiments import Task
from tests.bad_values import (
    COUNTS,
    FLAGS,
    NOT_GENERATORS,
    NOT_MEASURES,
    NOT_PHASES,
    NOT_SEEDS,
    NOT_STRATEGIES,
    NOT_WEIGHTS,
    NUMBERS,
    WRONG_SPACES,
    points,
    rows,
    some,
)
from tests.world import InTurn

RMB, Function, Tree = db.MotorBabbling(), db.FunctionEnvironment, db.NearestNeighbors
FREE = c.MovementPrimitives(2)


def many(tasks):
    """Explore them all: what is wrong with one is said when its turn comes."""
    return list(db.explore_many(tasks, jobs=1))


def without(values, *names):
    return {name: value for name, value in values.items() if name not in names}


NONE, HUGE = {"None": None}, {"huge": 2**63}
# Arguments of one kind share a validator, which is held to all of the kind where it is first used;
# others are given two of it, to see that they ask, and what is their own.
POINTS, ROWS = points(2), rows(2)
POINT = some(POINTS, "text", "nan", "too long")
ROW = some(ROWS, "text", "a bad second row", "too long")
NUMBER, COUNT = some(NUMBERS, "text", "nan"), some(COUNTS, "a float", "negative")
FLAG = some(FLAGS, "1", "text")
SPACE = some(WRONG_SPACES, "a number", "low above high")
SEED, GENERATOR = some(NOT_SEEDS, "text", "negative"), some(NOT_GENERATORS, "text", "a seed")
STRATEGIES = some(NOT_STRATEGIES, "nothing", "one is None")
ALL_FROM_1 = COUNTS | {"zero": 0} | HUGE | NONE

NOT_SPACES = SPACE | NONE
BATCH = POINT | {"a bad row": [[0, 0], [math.nan, 0]], "a row beyond": [[0, 0], [2, 0]]}
CORNERS = without(points(1), "empty", "too short", "too long")
POSITIVE = NUMBER | {"zero": 0.0, "below zero": -0.1}
FROM_ONE = NUMBER | {"below one": 0.99}
NOT_BELOW = NUMBER | {"below zero": -0.1}
SHARE = NUMBER | {"below zero": -1e-9, "above one": 1 + 1e-9}
UPTO_1 = SHARE | {"zero": 0.0}
STRICT_SHARE = UPTO_1 | {"one": 1.0}
FROM_1 = COUNT | {"zero": 0}
SIZE = FROM_1 | HUGE | NONE
NOT_PARTS = {"a number": 5, "a class": i.KNearest, "another": g.UniformGoals}
# A number, or one for each of two coordinates.
PLACES = without(NUMBERS, "an array", "a list", "an array of one") | {"rows": [[1.0, 1.0]]}
EDGES = {"text": "0.5", "zero": 0.0, "below zero": -0.1, "one is zero": [1.0, 0.0]}
NOT_CALLBACKS = NONE | {"a class": db.callbacks.Progress, "a number": 5, "text": "2h"}
NOT_OBSTACLES = {"a number": 5, "None": None, "a disc alone": e.Disc([0, 1], 0.1), "texts": ["a"]}
CELLS = without(COUNTS, "a list", "an array", "an array of one") | {
    "zero": 0,
    "None": None,
    "none": [],
    "one is zero": [2, 0],
    "one is a float": [2, 1.0],
    "rows": np.array([[2, 2]]),
    "huge": 10**8,
}
POINT_OR_ROWS = POINT | some(ROWS, "a bad second row")
FREELY = some(points(12), "nan", "too long") | {"beyond": [1.5] * 12}
BEYOND = {"beyond": [0.0, 1.5]}
FAR = {"far": [0.0, 1e301]}
FAR_ROWS = {"a far second row": [[0.0, 0.0], [-1e301, 0.0]]}
PATHS = {"text": "ab", "a number": 1, "None": None, "a list": [1], "floats": (0.5,)}
PATHS |= {"negative": (0, -1), "too large": (2**32,)}
NOT_TRIALS = {"None": None, "a command": [0.0, 0.0], "text": "ab"}
NOT_WORLDS = {"None": None, "a function": abs, "a box": db.Box([0], [1]), "an object": object()}
NOT_A_WORLD = {"a function": abs}
NOT_CALLABLE = {"a number": 0.02, "a list": [abs], "a measure": m.GridCoverage(1.0)}
NO_FUNCTION = {"None": None, "7": 7}
NOT_TASKS = {"None": None, "a number": 5, "a single one": Task(db.PlanarArm(2), RMB, 3)}
NOT_A_TASK = {"None": None, "a tuple": (db.PlanarArm(2), RMB, 3), "a strategy": RMB}
NOT_COUNTS = {f"one is {name}": [1, value] for name, value in FROM_1.items()}
NOT_ONE = {"None": None, "a class": db.MotorBabbling, "text": "ab", "a list": [RMB]}
NOT_BANDIT_PARTS = {"None": None, "7": 7, "a class": b.Window, "a strategy": 0.5}
NOT_BODIES = {"None": None, "a box": db.Box([0], [1]), "a class": dict, "a function": abs}
NOT_WORDS = {
    "None": None,
    "a number": 5,
    "text": "sleep 1",
    "bytes": b"sleep",
    "nothing": [],
    "a number among them": ["sleep", 1],
    "bytes among them": [b"sleep"],
    "a zero byte": ["a\0b"],
}
NOT_TEXTS = {"a number": 5, "bytes": b"y", "a list": ["y"], "object": object()}
NOT_REWARDS = {"7": 7, "a class": b.Gain, "text": "ab", "under way": db.Coverage(1.0)}
NOT_EXPLORATIONS = {"7": 7, "effects": [[0, 0]], "a history": db.History(db.Box([0], [1]))}


def primitives(**options):
    return c.MovementPrimitives(2, **options)


def program(**options):
    return e.ProcessEnvironment(["a"], db.Box([0], [1]), **options)


def bandit(**part):
    """Return a bandit, one part of which is another."""
    whole = {"tau": 1.0, "estimator": b.Window(), "policy": b.UCB()} | part
    return db.Bandit(whole.pop("strategies", [RMB]), **whole)


def episodes(**argument):
    """Return a black box of episodes, one argument of which is another."""
    space = db.Box([-1.0, -1.0], [1.0, 1.0])
    controller = c.FunctionController(lambda *_: [0.0], space)
    whole = {"make": "Pendulum-v1", "controller": controller, "effect": abs, "steps": 2, "seed": 0}
    return e.GymnasiumEnvironment(**whole | argument)


def tracking(**argument):
    """Return a controller that tracks, one argument of which is another."""
    whole = {"primitives": VIA, "positions": abs, "velocities": abs}
    options = {"dt": 0.1, "stiffness": 1.0, "damping": 1.0}
    return c.Tracking(**whole | options | argument)


VIA = c.ViaPoints([-1.0, -1.0], [1.0, 1.0], steps=4)
NOT_CONTROLLERS = {
    "None": None,
    "a function": abs,
    "a class": c.Tracking,
    "no policy": SimpleNamespace(motor_space=VIA.motor_space),
    "no motor space": SimpleNamespace(begin=abs),
    "a number as motor space": SimpleNamespace(begin=abs, motor_space=5),
}
NOT_PRIMITIVES = {"None": None, "a function": abs, "a box": db.Box([0], [1]), "text": "ab"}
NO_STRENGTHS = some(POINTS, "text", "nan") | {"below zero": -0.1, "one is below": [1, -1]}

# (what is called, the argument, what is passed, how)
#: What is no measure by its looks; others are found out when they are started.
UNSTARTED = ("text", "a class", "a function", "one under way")

TABLE = [
    ("PlanarArm", "joints", ALL_FROM_1, lambda _, x: db.PlanarArm(x)),
    ("PlanarArm", "joints", {"many": 10**12}, lambda _, x: db.PlanarArm(x, limit=1e-9)),
    ("PlanarArm", "thickness", POSITIVE | NUMBERS, lambda _, x: db.PlanarArm(2, thickness=x)),
    ("PlanarArm", "obstacles", NOT_OBSTACLES, lambda _, x: db.PlanarArm(2, obstacles=x)),
    ("PlanarArm", "self_contact", FLAG, lambda _, x: db.PlanarArm(2, self_contact=x)),
    ("PlanarArm.progress", "command", POINT, lambda _, x: db.PlanarArm(2).progress(x)),
    ("PlanarArm.follow", "trajectory", POINT, lambda _, x: db.PlanarArm(2).follow(x)),
    ("PushArm", "ball", POINT, lambda _, x: e.PushArm(2, ball=x)),
    ("PushArm", "ball_radius", POSITIVE, lambda _, x: e.PushArm(2, ball_radius=x)),
    ("Disc", "center", POINT, lambda _, x: e.Disc(x, 0.1)),
    ("Disc", "radius", POSITIVE, lambda _, x: e.Disc([0, 0], x)),
    ("Rectangle", "low", POINT, lambda _, x: e.Rectangle(x, [1, 1])),
    ("Rectangle", "high", POINT, lambda _, x: e.Rectangle([-1, -1], x)),
    ("Polygon", "points", ROW, lambda _, x: e.Polygon(x)),
    ("Wall", "start", POINT, lambda _, x: e.Wall(x, [1, 1])),
    ("Wall", "end", POINT, lambda _, x: e.Wall([1, 1], x)),
    ("Wall", "thickness", NOT_BELOW, lambda _, x: e.Wall([0, 0], [1, 1], thickness=x)),
    (
        "PlanarArm",
        "limit",
        POSITIVE | NUMBERS | {"1e7": 1e7},
        lambda _, x: db.PlanarArm(2, limit=x),
    ),
    ("arm()", "command", BATCH | BEYOND, lambda w, x: w.arm(x)),
    ("arm.posture", "command", POINT | BEYOND, lambda w, x: w.arm.posture(x)),
    ("Function", "f", {"None": None, "7": 7}, lambda w, x: Function(x, w.box)),
    ("Function", "motor_space", NOT_SPACES, lambda _, x: Function(abs, x)),
    ("Function", "sensory_space", SPACE, lambda w, x: Function(abs, w.box, x)),
    ("Function", "scalars", FLAG, lambda w, x: Function(abs, w.box, scalars=x)),
    ("Process", "command_line", NOT_WORDS, lambda w, x: e.ProcessEnvironment(x, w.box)),
    ("Process", "motor_space", NOT_SPACES, lambda _, x: e.ProcessEnvironment(["a"], x)),
    ("Process", "sensory_space", SPACE, lambda _, x: program(sensory_space=x)),
    ("Process", "timeout", POSITIVE | {"too long": 1e7}, lambda _, x: program(timeout=x)),
    ("Process", "entry", NOT_TEXTS, lambda _, x: program(entry=x)),
    ("Process()", "command", some(points(1), "text", "too long"), lambda _, x: program()(x)),
    ("Primitives", "dofs", SIZE, lambda _, x: c.MovementPrimitives(x)),
    ("Primitives", "basis", SIZE | {"one": 1}, lambda _, x: primitives(basis=x)),
    ("Primitives", "steps", SIZE, lambda _, x: primitives(steps=x)),
    ("Primitives", "weights", POSITIVE, lambda _, x: primitives(weights=x)),
    ("Primitives", "goals", POSITIVE, lambda _, x: primitives(goals=x)),
    ("Primitives", "start", POINT, lambda _, x: primitives(start=x)),
    ("Primitives", "limit", POSITIVE, lambda _, x: primitives(limit=x)),
    ("Primitives", "start", {"beyond": [2.0, 0.0]}, lambda _, x: primitives(start=x, limit=1)),
    ("trajectory", "command", FREELY, lambda _, x: FREE.trajectory(x)),
    ("Controlled", "body", NOT_BODIES, lambda _, x: e.Controlled(x, FREE)),
    ("Controlled", "controller", NOT_BODIES, lambda w, x: e.Controlled(w.arm, x)),
    ("Controlled()", "command", FREELY, lambda _, x: e.Controlled(db.PlanarArm(2), FREE)(x)),
    ("environment()", "command", BATCH | BEYOND, lambda w, x: w.environment(x)),
    ("Gymnasium", "make", {"None": None, "7": 7}, lambda _, x: episodes(make=x)),
    ("Gymnasium", "make", {"no id": "Nowhere-v0"}, lambda _, x: episodes(make=x)([0.0, 0.0])),
    ("Gymnasium", "make", {"no maker": list}, lambda _, x: episodes(make=x)([0.0, 0.0])),
    ("Gymnasium", "controller", NOT_CONTROLLERS, lambda _, x: episodes(controller=x)),
    ("Gymnasium", "effect", {"None": None, "7": 7}, lambda _, x: episodes(effect=x)),
    ("Gymnasium", "steps", FROM_1 | NONE, lambda _, x: episodes(steps=x)),
    ("Gymnasium", "seed", COUNT | NONE, lambda _, x: episodes(seed=x)),
    ("Gymnasium", "sensory_space", SPACE, lambda _, x: episodes(sensory_space=x)),
    ("Gymnasium()", "command", BATCH | BEYOND, lambda _, x: episodes()(x)),
    ("Gymnasium.episode", "command", POINT | BEYOND, lambda _, x: episodes().episode(x)),
    ("Tracking", "primitives", NOT_PRIMITIVES, lambda _, x: tracking(primitives=x)),
    ("Tracking", "positions", {"None": None, "7": 7}, lambda _, x: tracking(positions=x)),
    ("Tracking", "velocities", {"None": None, "7": 7}, lambda _, x: tracking(velocities=x)),
    ("Tracking", "dt", POSITIVE, lambda _, x: tracking(dt=x)),
    ("Tracking", "stiffness", NO_STRENGTHS, lambda _, x: tracking(stiffness=x)),
    ("Tracking", "damping", NO_STRENGTHS, lambda _, x: tracking(damping=x)),
    ("Tracking", "limit", NO_STRENGTHS, lambda _, x: tracking(limit=x)),
    ("Tracking", "turns", FLAG, lambda _, x: tracking(turns=x)),
    ("OpenLoop", "primitives", NOT_PRIMITIVES, lambda _, x: c.OpenLoop(x)),
    ("FunctionController", "f", {"None": None}, lambda w, x: c.FunctionController(x, w.box)),
    ("FunctionController", "motor_space", NOT_SPACES, lambda _, x: c.FunctionController(abs, x)),
    ("ViaPoints.trajectory", "command", BATCH | BEYOND, lambda _, x: VIA.trajectory(x)),
    ("Box", "low", CORNERS | {"above high": [1.5]}, lambda _, x: db.Box(x, [1.0])),
    ("Box", "low", {"empty": []}, lambda _, x: db.Box(x, x)),
    ("Box", "high", POINT, lambda _, x: db.Box([-1.0, -1.0], x)),
    ("Box.of", "box", WRONG_SPACES | NONE, lambda _, x: db.Box.of(x)),
    ("Box.of", "goals", NOT_SPACES, lambda _, x: db.Box.of(x, name="goals")),
    ("Box.sample", "rng", NOT_GENERATORS, lambda w, x: w.box.sample(x)),
    ("Box.contains", "point", POINTS, lambda w, x: w.box.contains(x)),
    ("GoalBabbling", "d", SHARE | without(NUMBERS, "None"), lambda _, x: db.GoalBabbling(x)),
    ("GoalBabbling", "goals", SPACE | NOT_PARTS, lambda _, x: db.GoalBabbling(goals=x)),
    ("GoalBabbling", "inverse", NOT_PARTS, lambda _, x: db.GoalBabbling(inverse=x)),
    (
        "with a model",
        "d",
        SHARE | {"another": 0.1},
        lambda _, x: db.GoalBabbling(x, inverse=i.KNearest()),
    ),
    ("UniformGoals", "box", SPACE, lambda _, x: g.UniformGoals(x)),
    ("GridGoals", "cells", CELLS, lambda _, x: g.GridGoals(x)),
    ("GridGoals", "box", SPACE, lambda _, x: g.GridGoals(3, box=x)),
    ("GridGoals", "cells", {"of 3": [2, 2, 2]}, lambda w, x: g.GridGoals(x, box=w.box)),
    ("UncoveredGoals", "tau", POSITIVE, lambda _, x: g.UncoveredGoals(x)),
    ("UncoveredGoals", "tries", SIZE, lambda _, x: g.UncoveredGoals(1.0, tries=x)),
    ("UncoveredGoals", "box", SPACE, lambda _, x: g.UncoveredGoals(1.0, box=x)),
    ("FrontierGoals", "tau", POSITIVE, lambda _, x: g.FrontierGoals(x)),
    ("FrontierGoals", "reach", FROM_ONE, lambda _, x: g.FrontierGoals(1.0, reach=x)),
    ("FrontierGoals", "tries", SIZE, lambda _, x: g.FrontierGoals(1.0, tries=x)),
    ("FrontierGoals", "box", SPACE, lambda _, x: g.FrontierGoals(1.0, box=x)),
    ("NovelGoals", "candidates", SIZE, lambda _, x: g.NovelGoals(x)),
    ("NovelGoals", "box", SPACE, lambda _, x: g.NovelGoals(box=x)),
    ("sampler.sample", "rng", GENERATOR, lambda w, x: g.NovelGoals().sample(w.history, x)),
    ("NearestNeighbor", "d", SHARE, lambda _, x: i.Nearest(x)),
    ("NearestNeighbor", "goal", POINT, lambda w, x: i.Nearest().command(x, *w.past())),
    ("KNearest", "k", SIZE, lambda _, x: i.KNearest(x)),
    ("KNearest", "d", SHARE, lambda _, x: i.KNearest(1, x)),
    ("KNearest", "goal", POINT, lambda w, x: i.KNearest().command(x, *w.past())),
    ("KNearest", "rng", GENERATOR, lambda w, x: i.KNearest().command([0, 0], w.history, x)),
    ("UntriedGoals", "tau", POSITIVE, lambda _, x: g.UntriedGoals(x)),
    ("UntriedGoals", "candidates", FROM_1 | HUGE, lambda _, x: g.UntriedGoals(1.0, candidates=x)),
    ("UntriedGoals", "tries", SIZE, lambda _, x: g.UntriedGoals(1.0, tries=x)),
    ("UntriedGoals", "reach", FROM_ONE, lambda _, x: g.UntriedGoals(1.0, reach=x)),
    ("UntriedGoals", "box", SPACE, lambda _, x: g.UntriedGoals(1.0, box=x)),
    ("LocalJacobian", "k", SIZE, lambda _, x: i.LocalJacobian(x)),
    ("LocalJacobian", "used", SIZE, lambda _, x: i.LocalJacobian(9, x)),
    ("LocalJacobian", "ridge", POSITIVE, lambda _, x: i.LocalJacobian(ridge=x)),
    ("LocalJacobian", "reach", SHARE, lambda _, x: i.LocalJacobian(reach=x)),
    ("LocalJacobian", "noise", SHARE, lambda _, x: i.LocalJacobian(noise=x)),
    ("LocalJacobian", "goal", POINT, lambda w, x: i.LocalJacobian().command(x, *w.past())),
    ("default_strategy", "tau", POSITIVE, lambda _, x: db.default_strategy(x)),
    ("default_strategy", "box", SPACE, lambda _, x: db.default_strategy(1.0, goals=x)),
    ("default_strategies", "tau", POSITIVE, lambda _, x: b.default_strategies(x)),
    ("LineVariation", "d", SHARE, lambda _, x: i.LineVariation(x)),
    ("LineVariation", "along", NOT_BELOW, lambda _, x: i.LineVariation(along=x)),
    ("Crossover", "k", SIZE, lambda _, x: i.Crossover(x)),
    ("Crossover", "d", SHARE, lambda _, x: i.Crossover(1, x)),
    ("LocalRegression", "k", SIZE, lambda _, x: i.LocalRegression(x)),
    ("LocalRegression", "d", SHARE, lambda _, x: i.LocalRegression(1, x)),
    ("LocalRegression", "ridge", POSITIVE, lambda _, x: i.LocalRegression(ridge=x)),
    ("LocalRegression", "reach", POSITIVE, lambda _, x: i.LocalRegression(reach=x)),
    ("LocalRegression", "goal", POINT, lambda w, x: i.LocalRegression().command(x, *w.past())),
    ("Box.sample_many", "n", COUNT | HUGE | NONE, lambda w, x: w.box.sample_many(x, w.rng)),
    ("Box.sample_many", "rng", GENERATOR, lambda w, x: w.box.sample_many(3, x)),
    ("Mixture", "strategies", NOT_STRATEGIES, lambda _, x: db.Mixture(x)),
    ("Mixture", "weights", NOT_WEIGHTS, lambda _, x: db.Mixture([RMB, RMB], weights=x)),
    ("Schedule", "phases", NOT_PHASES, lambda _, x: db.Schedule(x)),
    ("Adapt", "strategies", STRATEGIES, lambda _, x: db.Adapt(x)),
    ("Adapt", "tau", POSITIVE, lambda _, x: db.Adapt([RMB], tau=x)),
    ("Adapt", "window", ALL_FROM_1, lambda _, x: db.Adapt([RMB], window=x)),
    ("Adapt", "alpha", SHARE, lambda _, x: db.Adapt([RMB], alpha=x)),
    ("Adapt", "head_start", COUNT | {"51": 51}, lambda _, x: db.Adapt([RMB], head_start=x)),
    ("Adapt", "reward", NOT_REWARDS, lambda _, x: db.Adapt([RMB], reward=x)),
    ("Adapt", "tau", {"both": 0.1}, lambda _, x: db.Adapt([RMB], tau=x, reward=abs)),
    ("Adapt", "power", NOT_BELOW, lambda _, x: db.Adapt([RMB], power=x)),
    ("Bandit", "strategies", STRATEGIES, lambda _, x: bandit(strategies=x)),
    ("Bandit", "tau", {"none": None}, lambda _, x: bandit(tau=x)),
    ("Bandit", "tau", {"both": 0.1}, lambda _, x: bandit(tau=x, reward=abs)),
    ("Bandit", "reward", NOT_REWARDS, lambda _, x: bandit(tau=None, reward=x)),
    ("Bandit", "estimator", NOT_BANDIT_PARTS, lambda _, x: bandit(estimator=x)),
    ("Bandit", "policy", NOT_BANDIT_PARTS, lambda _, x: bandit(policy=x)),
    ("BallCoverage", "tau", POSITIVE, lambda _, x: m.BallCoverage(x)),
    ("BallCoverage", "accuracy", UPTO_1, lambda _, x: m.BallCoverage(1, accuracy=x)),
    ("BallCoverage", "dim", FROM_1, lambda _, x: m.BallCoverage(1.0).start(x)),
    ("Gain", "measure", some(NOT_MEASURES, *UNSTARTED), lambda _, x: b.Gain(x)),
    ("FunctionReward", "function", NOT_CALLABLE, lambda _, x: b.FunctionReward(x)),
    ("FunctionReward", "bound", NOT_BELOW, lambda _, x: b.FunctionReward(abs, bound=x)),
    ("Window", "size", SIZE, lambda _, x: b.Window(x)),
    ("Window", "head_start", COUNT | {"51": 51}, lambda _, x: b.Window(head_start=x)),
    ("RecentWindow", "size", SIZE, lambda _, x: b.RecentWindow(x)),
    ("Discounted", "gamma", UPTO_1, lambda _, x: b.Discounted(x)),
    ("Discounted", "head_start", COUNT | HUGE, lambda _, x: b.Discounted(0.5, head_start=x)),
    ("Proportional", "alpha", SHARE, lambda _, x: b.Proportional(x)),
    ("Proportional", "power", NOT_BELOW, lambda _, x: b.Proportional(power=x)),
    ("EpsilonGreedy", "epsilon", SHARE, lambda _, x: b.EpsilonGreedy(x)),
    ("Softmax", "temperature", POSITIVE, lambda _, x: b.Softmax(x)),
    ("Softmax", "scaled", FLAGS, lambda _, x: b.Softmax(scaled=x)),
    ("UCB", "xi", NOT_BELOW, lambda _, x: b.UCB(x)),
    ("Exp3", "gamma", UPTO_1, lambda _, x: b.Exp3(x)),
    ("Exp3S", "gamma", UPTO_1, lambda _, x: b.Exp3S(x)),
    ("Exp3S", "alpha", UPTO_1, lambda _, x: b.Exp3S(alpha=x)),
    ("ucb1", "reward", NOT_REWARDS, lambda _, x: b.ucb1([RMB], reward=x)),
    ("sw-ucb", "size", FROM_1, lambda _, x: b.sliding_window_ucb([RMB], window=x, tau=1)),
    ("d-ucb", "gamma", UPTO_1, lambda _, x: b.discounted_ucb([RMB], gamma=x, tau=1)),
    ("d-ucb", "xi", NOT_BELOW, lambda _, x: b.discounted_ucb([RMB], gamma=1, xi=x, tau=1)),
    ("Composite", "strategies", STRATEGIES, lambda _, x: InTurn(x)),
    ("explore", "environment", NOT_WORLDS, lambda w, x: db.explore(x, RMB, n=1, rng=w.rng)),
    ("explore", "strategy", NOT_ONE, lambda w, x: db.explore(w.arm, x, n=1, rng=w.rng)),
    ("explore", "n", FROM_1 | NONE, lambda w, x: db.explore(w.arm, RMB, n=x, rng=w.rng)),
    ("explore", "rng", NOT_SEEDS, lambda w, x: db.explore(w.arm, RMB, n=1, rng=x)),
    ("explore_many", "tasks", NOT_TASKS, lambda _, x: db.explore_many(x)),
    ("explore_many", "tasks", NOT_A_TASK, lambda w, x: many([w.task, x])),
    ("explore_many", "keep", NOT_CALLABLE, lambda w, x: db.explore_many([w.task], keep=x)),
    ("explore_many", "rng", SEED, lambda w, x: db.explore_many([w.task], rng=x)),
    ("explore_many", "jobs", FROM_1, lambda w, x: db.explore_many([w.task], jobs=x, rng=w.rng)),
    ("explore_many", "progress", NOT_CALLABLE, lambda w, x: db.explore_many([w.task], progress=x)),
    ("Task", "environment", NOT_A_WORLD, lambda w, x: many([Task(x, RMB, 1, w.rng)])),
    ("Task", "strategy", NOT_ONE, lambda w, x: many([Task(w.arm, x, 1, w.rng)])),
    ("Task", "n", FROM_1 | NONE, lambda w, x: many([Task(w.arm, RMB, x, w.rng)])),
    ("Task", "rng", SEED, lambda w, x: many([Task(w.arm, RMB, 1, x)])),
    ("Task.over", "seeds", {"None": None, "a number": 25}, lambda w, x: w.task.over(x)),
    ("Task.over", "rng", SEED, lambda w, x: many(w.task.over([x]))),
    ("Every", "k", without(ALL_FROM_1, "huge"), lambda _, x: db.callbacks.Every(x, print)),
    ("summarize", "tau", POSITIVE, lambda _, x: experiments.summarize(x)),
    (
        "summarize",
        "at",
        NOT_COUNTS | {"a number": 3},
        lambda _, x: experiments.summarize(0.1, at=x),
    ),
    ("summarize()", "at", {"beyond": [1, 4]}, lambda w, x: experiments.summarize(0.1, at=x)(w.run)),
    (
        "summarize()",
        "run",
        {"None": None, "effects": [[0, 0]]},
        lambda _, x: experiments.summarize(0.1)(x),
    ),
    ("Explorer", "strategy", NOT_ONE, lambda w, x: db.Explorer(x, w.box)),
    ("Explorer", "motor_space", NOT_SPACES, lambda _, x: db.Explorer(RMB, x)),
    ("Explorer", "sensory_space", SPACE, lambda w, x: db.Explorer(RMB, w.box, x)),
    ("Explorer", "rng", SEED, lambda w, x: db.Explorer(RMB, w.box, rng=x)),
    ("Explorer", "past", NOT_EXPLORATIONS, lambda w, x: db.Explorer(RMB, w.box, past=x)),
    (
        "add_past",
        "commands",
        ROW | {"beyond": [[2, 0]]},
        lambda w, x: w.explorer.add_past(x, [[0, 0]]),
    ),
    ("add_past", "effects", ROW, lambda w, x: w.explorer.add_past([[0, 0]], x)),
    ("Explorer.ask", "n", FROM_1, lambda w, x: w.explorer.ask(x)),
    ("Explorer.fail", "trial", NOT_TRIALS, lambda w, x: w.explorer.fail(x, "it fell over")),
    ("Explorer.fail", "reason", NONE, lambda w, x: w.explorer.fail(w.trial, x)),
    ("Explorer.tell", "trial", NOT_TRIALS, lambda w, x: w.explorer.tell(x, [0.0, 0.0])),
    ("tell", "trial", {"by hand": 0}, lambda w, _: w.explorer.tell(w.by_hand, [0, 0])),
    ("Explorer.tell", "effect", POINT, lambda w, x: w.explorer.tell(w.trial, x)),
    ("History", "motor_space", NOT_SPACES, lambda _, x: db.History(x)),
    ("History", "sensory_space", SPACE, lambda w, x: db.History(w.box, x)),
    ("History.append", "command", POINT | BEYOND, lambda w, x: w.history.append(x, [0.0, 0.0])),
    ("History.append", "effect", POINTS, lambda w, x: w.history.append([0.0, 0.0], x)),
    (
        "append",
        "effect",
        some(POINTS, "text", "nan", "a scalar"),
        lambda w, x: db.History(w.box).append([0.0, 0.0], x),
    ),
    ("History.append", "path", PATHS, lambda w, x: w.history.append([0, 0], [0, 0], path=x)),
    ("History.nearest", "goal", POINT, lambda w, x: w.history.nearest(x)),
    ("History.nearest", "k", FROM_1 | HUGE | {"4": 4}, lambda w, x: w.history.nearest([0, 0], k=x)),
    ("Coverage", "tau", POSITIVE | NUMBERS, lambda _, x: db.Coverage(x)),
    ("Coverage", "dim", ALL_FROM_1 | {"33": 33}, lambda _, x: db.Coverage(1.0, dim=x)),
    ("Coverage", "accuracy", STRICT_SHARE, lambda _, x: db.Coverage(1.0, accuracy=x)),
    ("Coverage of 5", "accuracy", STRICT_SHARE, lambda _, x: db.Coverage(1.0, dim=5, accuracy=x)),
    ("Coverage", "rng", SEED, lambda _, x: db.Coverage(1.0, rng=x)),
    ("Coverage of 5", "rng", SEED, lambda _, x: db.Coverage(1.0, dim=5, rng=x)),
    ("Coverage.add", "effect", BATCH, lambda w, x: w.coverage.add(x)),
    ("Coverage.gain", "effect", POINT_OR_ROWS, lambda w, x: w.coverage.gain(x)),
    ("Coverage.gain", "with_error", FLAGS, lambda w, x: w.coverage.gain([0, 0], with_error=x)),
    (
        "contribution",
        "index",
        some(COUNTS, "a float", "text") | NONE,
        lambda w, x: w.coverage.contribution(x),
    ),
    ("contribution", "with_error", FLAG, lambda w, x: w.coverage.contribution(0, with_error=x)),
    ("Coverage.contains", "points", POINT_OR_ROWS, lambda w, x: w.coverage.contains(x)),
    ("Coverage.extend", "effects", ROWS, lambda w, x: w.coverage.extend(x)),
    ("GridCoverage", "cell", PLACES | EDGES, lambda _, x: m.GridCoverage(x)),
    ("GridCoverage", "dim", SIZE, lambda _, x: m.GridCoverage(1.0).start(x)),
    ("GridCoverage", "origin", PLACES, lambda _, x: m.GridCoverage(1.0, origin=x)),
    ("GridCoverage.add", "effect", POINT, lambda w, x: w.grid.add(x)),
    ("GridCoverage.gain", "effect", POINT, lambda w, x: w.grid.gain(x)),
    ("GridCoverage.extend", "effects", ROW, lambda w, x: w.grid.extend(x)),
    ("GridCoverage.add", "effect", FAR, lambda _, x: m.GridCoverage(1e-10).start(2).add(x)),
    ("Sparseness", "k", FROM_1 | NONE, lambda _, x: m.Sparseness(x)),
    ("Sparseness", "dim", SIZE, lambda _, x: m.Sparseness().start(x)),
    ("Sparseness.add", "effect", POINT | FAR, lambda w, x: w.sparseness.add(x)),
    ("Sparseness.gain", "effect", POINT | FAR, lambda w, x: w.sparseness.gain(x)),
    ("Sparseness.extend", "effects", ROW | FAR_ROWS, lambda w, x: w.sparseness.extend(x)),
    ("Entropy", "cell", EDGES, lambda _, x: m.Entropy(x)),
    ("Entropy", "dim", SIZE, lambda _, x: m.Entropy(1.0).start(x)),
    (
        "Entropy",
        "origin",
        some(PLACES, "text", "nan", "rows"),
        lambda _, x: m.Entropy(1.0, origin=x),
    ),
    ("Entropy.add", "effect", POINT, lambda w, x: w.entropy.add(x)),
    ("Entropy.gain", "effect", POINT, lambda w, x: w.entropy.gain(x)),
    ("Entropy.extend", "effects", ROW, lambda w, x: w.entropy.extend(x)),
    ("coverage", "effects", without(ROW, "too long"), lambda _, x: db.coverage(x, 1.0)),
    ("coverage", "accuracy", STRICT_SHARE, lambda _, x: db.coverage([[0] * 5], 1.0, accuracy=x)),
    ("coverage", "rng", SEED, lambda _, x: db.coverage([[0.0, 0.0]], 1.0, rng=x)),
    ("coverage", "tau", POSITIVE, lambda _, x: db.coverage([[0.0, 0.0]], x)),
    ("Tree", "dim", FROM_1 | NONE | {"huge": 2**64}, lambda _, x: Tree(x)),
    ("Tree.add", "point", POINT, lambda w, x: w.tree.add(x)),
    ("Tree.extend", "points", ROWS, lambda w, x: w.tree.extend(x)),
    ("Tree.nearest", "query", POINT, lambda w, x: w.tree.nearest(x)),
    ("Tree.nearest", "k", FROM_1 | HUGE | {"4": 4}, lambda w, x: w.tree.nearest([0, 0], k=x)),
    ("Exploration.coverage", "tau", POSITIVE, lambda w, x: w.run.coverage(x)),
    ("Exploration.diversity", "measure", NOT_MEASURES | NONE, lambda w, x: w.run.diversity(x)),
    ("Exploration.load", "PathLike", {"None": None, "7": 7}, lambda _, x: db.Exploration.load(x)),
]
