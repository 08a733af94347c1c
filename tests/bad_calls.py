"""Every public entry point, its arguments, and what is passed for each by mistake."""

import math

import numpy as np

import divbandit as db
from tests.bad_values import (
    COUNTS,
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
)
from tests.world import InTurn

RMB, Function, Tree = db.MotorBabbling(), db.FunctionEnvironment, db.NearestNeighbors
Grid, FREE = db.GridCoverage, db.MovementPrimitives(2)


def many(tasks):
    """Explore them all: what is wrong with one is said when its turn comes."""
    return list(db.explore_many(tasks, jobs=1))


def without(values, *names):
    return {name: value for name, value in values.items() if name not in names}


POINTS, ROWS = points(2), rows(2)
RAGGED_ROWS = without(ROWS, "too short", "too long")  # those are of another dimension
NONE = {"None": None}
NOT_SPACES = WRONG_SPACES | NONE
BATCH = POINTS | {"a bad row": [[0, 0], [math.nan, 0]], "a row beyond": [[0, 0], [2, 0]]}
BAD_ROWS = {
    name: rows(2)[name] for name in ("too short", "too long", "inf", "texts", "a bad second row")
}
SIZED = without(POINTS, "too short", "too long")
CORNERS = without(points(1), "empty", "too short", "too long")
POSITIVE = NUMBERS | {"zero": 0.0, "below zero": -0.1}
FROM_ONE = NUMBERS | {"below one": 0.99}
NOT_PARTS = {"a number": 5, "text": "ab", "a class": db.KNearest, "another": db.UniformGoals}
# A number, or one for each of two coordinates.
PLACES = without(NUMBERS, "an array") | {"three": [1.0, 1.0, 1.0], "rows": [[1.0, 1.0]]}
EDGES = PLACES | {"zero": 0.0, "below zero": -0.1, "one is zero": [1.0, 0.0]}
SHARE = NUMBERS | {"below zero": -1e-9, "above one": 1 + 1e-9}
STRICT_SHARE = NUMBERS | {"zero": 0.0, "below zero": -0.1, "one": 1.0, "above one": 1.5}
WAYS = without(POINTS, "too deep")
NOT_THICK = NUMBERS | {"below zero": -0.1}
NOT_OBSTACLES = {"a number": 5, "None": None, "a disc alone": db.Disc([0, 1], 0.1), "texts": ["a"]}
NOT_FLAGS = {"a number": 1, "None": None, "text": "yes"}
FROM_1 = COUNTS | {"zero": 0}
CELLS = without(FROM_1, "a list", "an array", "an array of one") | {
    "None": None,
    "none": [],
    "one is zero": [2, 0],
    "one is a float": [2, 1.0],
    "rows": np.array([[2, 2]]),
    "huge": 10**8,
}
# As an index -1 is the last; what is out of range is an IndexError, tested elsewhere.
NOT_INDICES = without(COUNTS, "negative", "very negative") | {"None": None}
NOT_FLAGS = {"1": 1, "0.0": 0.0, "None": None, "text": "yes", "a list": [True], "object": object()}
HUGE = {"huge": 2**63, "very huge": 10**30}
BEYOND = {"beyond": [0.0, 1.5]}
FAR = {"far": [0.0, 1e301]}
FAR_ROWS = {"a far second row": [[0.0, 0.0], [-1e301, 0.0]]}
PATHS = {"text": "ab", "a number": 1, "None": None, "floats": (0.5,), "negative": (-1,)}
NOT_TRIALS = {"None": None, "a command": [0.0, 0.0], "text": "ab"}
NOT_WORLDS = {"None": None, "a function": abs, "a box": db.Box([0], [1]), "an object": object()}
NOT_CALLABLE = {"a number": 0.02, "text": "ab", "a list": [abs], "a measure": db.GridCoverage(1.0)}
NOT_TASKS = {"None": None, "a number": 5, "a single one": db.Task(db.PlanarArm(2), RMB, 3)}
NOT_A_TASK = {"None": None, "a tuple": (db.PlanarArm(2), RMB, 3), "a strategy": RMB}
NOT_COUNTS = {f"one is {name}": [1, value] for name, value in FROM_1.items()}
NOT_ONE = {"None": None, "a class": db.MotorBabbling, "text": "ab", "a list": [RMB]}
NOT_BELOW = NUMBERS | {"below zero": -0.1}
UPTO_1 = SHARE | {"zero": 0.0}
NOT_BANDIT_PARTS = {
    "None": None,
    "7": 7,
    "a class": db.bandits.Window,
    "text": "ab",
    "a strategy": RMB,
}
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
ABOVE_0 = without(POSITIVE, "None")
NOT_CREDITS = {"7": 7, "a class": db.bandits.Gain, "text": "ab", "a measure": Grid(1.0)}


def primitives(**options):
    return db.MovementPrimitives(2, **options)


def program(**options):
    return db.ProcessEnvironment(["a"], db.Box([0], [1]), **options)


def bandit(**part):
    """Return a bandit, one part of which is another."""
    b = db.bandits
    whole = {"credit": b.CoverageGain(), "memory": b.Window(), "rule": b.UCB()} | part
    return db.Bandit(whole.pop("strategies", [RMB]), **whole)


def episodes(**argument):
    """Return a black box of episodes, one argument of which is another."""
    space = db.Box([-1.0, -1.0], [1.0, 1.0])
    controller = db.FunctionController(lambda *_: [0.0], space)
    whole = {"make": "Pendulum-v1", "controller": controller, "effect": abs, "steps": 2, "seed": 0}
    return db.GymnasiumEnvironment(**whole | argument)


def tracking(**argument):
    """Return a controller that tracks, one argument of which is another."""
    whole = {"primitives": VIA, "positions": abs, "velocities": abs}
    options = {"dt": 0.1, "stiffness": 1.0, "damping": 1.0}
    return db.Tracking(**whole | options | argument)


VIA = db.controllers.ViaPoints([-1.0, -1.0], [1.0, 1.0], steps=4)
NOT_CONTROLLERS = {"None": None, "a function": abs, "primitives": VIA, "a class": db.Tracking}
NOT_PRIMITIVES = {"None": None, "a function": abs, "a box": db.Box([0], [1]), "text": "ab"}
NO_STRENGTHS = without(POINTS, "a scalar", "too short", "too long") | {"below zero": -0.1}

# (what is called, the argument, what is passed, how)
TABLE = [
    ("PlanarArm", "joints", FROM_1 | HUGE | NONE, lambda _, x: db.PlanarArm(x)),
    ("PlanarArm", "joints", {"many": 10**12}, lambda _, x: db.PlanarArm(x, limit=1e-9)),
    ("PlanarArm", "thickness", POSITIVE, lambda _, x: db.PlanarArm(2, thickness=x)),
    ("PlanarArm", "obstacles", NOT_OBSTACLES, lambda _, x: db.PlanarArm(2, obstacles=x)),
    ("PlanarArm", "self_contact", NOT_FLAGS, lambda _, x: db.PlanarArm(2, self_contact=x)),
    ("PlanarArm.progress", "command", POINTS, lambda _, x: db.PlanarArm(2).progress(x)),
    ("PlanarArm.follow", "trajectory", WAYS, lambda _, x: db.PlanarArm(2).follow(x)),
    ("PushArm", "ball", POINTS, lambda _, x: db.PushArm(2, ball=x)),
    ("PushArm", "ball_radius", POSITIVE, lambda _, x: db.PushArm(2, ball_radius=x)),
    ("Disc", "center", POINTS, lambda _, x: db.Disc(x, 0.1)),
    ("Disc", "radius", POSITIVE, lambda _, x: db.Disc([0, 0], x)),
    ("Rectangle", "low", POINTS, lambda _, x: db.Rectangle(x, [1, 1])),
    ("Rectangle", "high", POINTS, lambda _, x: db.Rectangle([-1, -1], x)),
    ("Polygon", "points", ROWS, lambda _, x: db.Polygon(x)),
    ("Wall", "start", POINTS, lambda _, x: db.Wall(x, [1, 1])),
    ("Wall", "end", POINTS, lambda _, x: db.Wall([1, 1], x)),
    ("Wall", "thickness", NOT_THICK, lambda _, x: db.Wall([0, 0], [1, 1], thickness=x)),
    ("PlanarArm", "limit", POSITIVE | {"1e7": 1e7}, lambda _, x: db.PlanarArm(2, limit=x)),
    ("arm()", "command", BATCH | BEYOND, lambda w, x: w.arm(x)),
    ("arm.posture", "command", POINTS | BEYOND, lambda w, x: w.arm.posture(x)),
    ("Function", "f", {"None": None, "7": 7}, lambda w, x: Function(x, w.box)),
    ("Function", "motor_space", NOT_SPACES, lambda _, x: Function(abs, x)),
    ("Function", "sensory_space", WRONG_SPACES, lambda w, x: Function(abs, w.box, x)),
    ("Function", "scalars", NOT_FLAGS, lambda w, x: Function(abs, w.box, scalars=x)),
    ("Process", "command_line", NOT_WORDS, lambda w, x: db.ProcessEnvironment(x, w.box)),
    ("Process", "motor_space", NOT_SPACES, lambda _, x: db.ProcessEnvironment(["a"], x)),
    ("Process", "sensory_space", WRONG_SPACES, lambda _, x: program(sensory_space=x)),
    ("Process", "timeout", ABOVE_0 | {"too long": 1e7}, lambda _, x: program(timeout=x)),
    ("Process", "entry", NOT_TEXTS, lambda _, x: program(entry=x)),
    ("Process()", "command", without(points(1), "empty"), lambda _, x: program()(x)),
    ("Primitives", "dofs", FROM_1 | HUGE | NONE, lambda _, x: db.MovementPrimitives(x)),
    ("Primitives", "basis", FROM_1 | HUGE | NONE | {"one": 1}, lambda _, x: primitives(basis=x)),
    ("Primitives", "steps", FROM_1 | HUGE | NONE, lambda _, x: primitives(steps=x)),
    ("Primitives", "weights", POSITIVE, lambda _, x: primitives(weights=x)),
    ("Primitives", "goals", ABOVE_0, lambda _, x: primitives(goals=x)),
    ("Primitives", "start", without(POINTS, "None"), lambda _, x: primitives(start=x)),
    ("Primitives", "limit", ABOVE_0, lambda _, x: primitives(limit=x)),
    ("trajectory", "command", points(12) | {"beyond": [1.5] * 12}, lambda _, x: FREE.trajectory(x)),
    ("Controlled", "body", NOT_BODIES, lambda _, x: db.Controlled(x, FREE)),
    ("Controlled", "controller", NOT_BODIES, lambda w, x: db.Controlled(w.arm, x)),
    (
        "Controlled()",
        "command",
        points(12) | {"beyond": [1.5] * 12},
        lambda _, x: db.Controlled(db.PlanarArm(2), FREE)(x),
    ),
    ("environment()", "command", BATCH | BEYOND, lambda w, x: w.environment(x)),
    ("Gymnasium", "make", {"None": None, "7": 7}, lambda _, x: episodes(make=x)),
    ("Gymnasium", "make", {"no id": "Nowhere-v0"}, lambda _, x: episodes(make=x)([0.0, 0.0])),
    ("Gymnasium", "make", {"no maker": list}, lambda _, x: episodes(make=x)([0.0, 0.0])),
    ("Gymnasium", "controller", NOT_CONTROLLERS, lambda _, x: episodes(controller=x)),
    ("Gymnasium", "effect", {"None": None, "7": 7}, lambda _, x: episodes(effect=x)),
    ("Gymnasium", "steps", FROM_1 | NONE, lambda _, x: episodes(steps=x)),
    ("Gymnasium", "seed", COUNTS | NONE, lambda _, x: episodes(seed=x)),
    ("Gymnasium", "sensory_space", WRONG_SPACES, lambda _, x: episodes(sensory_space=x)),
    ("Gymnasium()", "command", BATCH | BEYOND, lambda _, x: episodes()(x)),
    ("Gymnasium.episode", "command", POINTS | BEYOND, lambda _, x: episodes().episode(x)),
    ("Tracking", "primitives", NOT_PRIMITIVES, lambda _, x: tracking(primitives=x)),
    ("Tracking", "positions", {"None": None, "7": 7}, lambda _, x: tracking(positions=x)),
    ("Tracking", "velocities", {"None": None, "7": 7}, lambda _, x: tracking(velocities=x)),
    ("Tracking", "dt", POSITIVE, lambda _, x: tracking(dt=x)),
    ("Tracking", "stiffness", NO_STRENGTHS, lambda _, x: tracking(stiffness=x)),
    ("Tracking", "damping", NO_STRENGTHS, lambda _, x: tracking(damping=x)),
    ("Tracking", "limit", without(NO_STRENGTHS, "None"), lambda _, x: tracking(limit=x)),
    ("Tracking", "turns", NOT_FLAGS, lambda _, x: tracking(turns=x)),
    ("OpenLoop", "primitives", NOT_PRIMITIVES, lambda _, x: db.OpenLoop(x)),
    ("FunctionController", "f", {"None": None}, lambda w, x: db.FunctionController(x, w.box)),
    ("FunctionController", "motor_space", NOT_SPACES, lambda _, x: db.FunctionController(abs, x)),
    ("ViaPoints.trajectory", "command", BATCH | BEYOND, lambda _, x: VIA.trajectory(x)),
    ("Box", "low", CORNERS | {"above high": [1.5]}, lambda _, x: db.Box(x, [1.0])),
    ("Box", "low", {"empty": []}, lambda _, x: db.Box(x, x)),
    ("Box", "high", POINTS, lambda _, x: db.Box([-1.0, -1.0], x)),
    ("Box.of", "box", NOT_SPACES, lambda _, x: db.Box.of(x)),
    ("Box.of", "goals", NOT_SPACES, lambda _, x: db.Box.of(x, name="goals")),
    ("Box.sample", "rng", NOT_GENERATORS, lambda w, x: w.box.sample(x)),
    ("Box.contains", "point", POINTS, lambda w, x: w.box.contains(x)),
    ("GoalBabbling", "d", SHARE, lambda _, x: db.GoalBabbling(x)),
    ("GoalBabbling", "goals", WRONG_SPACES | NOT_PARTS, lambda _, x: db.GoalBabbling(goals=x)),
    ("GoalBabbling", "inverse", NOT_PARTS, lambda _, x: db.GoalBabbling(inverse=x)),
    (
        "GoalBabbling with an inverse model",
        "d",
        SHARE | {"another": 0.1},
        lambda _, x: db.GoalBabbling(x, inverse=db.KNearest()),
    ),
    ("UniformGoals", "box", WRONG_SPACES, lambda _, x: db.UniformGoals(x)),
    ("GridGoals", "cells", CELLS, lambda _, x: db.GridGoals(x)),
    ("GridGoals", "box", WRONG_SPACES, lambda _, x: db.GridGoals(3, box=x)),
    ("GridGoals", "cells", {"of 3": [2, 2, 2]}, lambda w, x: db.GridGoals(x, box=w.box)),
    ("UncoveredGoals", "tau", POSITIVE, lambda _, x: db.UncoveredGoals(x)),
    ("UncoveredGoals", "tries", FROM_1 | HUGE | NONE, lambda _, x: db.UncoveredGoals(1.0, tries=x)),
    ("UncoveredGoals", "box", WRONG_SPACES, lambda _, x: db.UncoveredGoals(1.0, box=x)),
    ("FrontierGoals", "tau", POSITIVE, lambda _, x: db.FrontierGoals(x)),
    ("FrontierGoals", "reach", FROM_ONE, lambda _, x: db.FrontierGoals(1.0, reach=x)),
    ("FrontierGoals", "tries", FROM_1 | HUGE | NONE, lambda _, x: db.FrontierGoals(1.0, tries=x)),
    ("FrontierGoals", "box", WRONG_SPACES, lambda _, x: db.FrontierGoals(1.0, box=x)),
    ("NovelGoals", "candidates", FROM_1 | HUGE | NONE, lambda _, x: db.NovelGoals(x)),
    ("NovelGoals", "box", WRONG_SPACES, lambda _, x: db.NovelGoals(box=x)),
    ("sampler.sample", "rng", NOT_GENERATORS, lambda w, x: db.NovelGoals().sample(w.history, x)),
    ("NearestNeighbor", "d", SHARE, lambda _, x: db.NearestNeighbor(x)),
    ("NearestNeighbor", "goal", POINTS, lambda w, x: db.NearestNeighbor().command(x, *w.past())),
    ("KNearest", "k", FROM_1 | HUGE | NONE, lambda _, x: db.KNearest(x)),
    ("KNearest", "d", SHARE, lambda _, x: db.KNearest(1, x)),
    ("KNearest", "goal", POINTS, lambda w, x: db.KNearest().command(x, *w.past())),
    ("KNearest", "rng", NOT_GENERATORS, lambda w, x: db.KNearest().command([0, 0], w.history, x)),
    ("UntriedGoals", "tau", POSITIVE, lambda _, x: db.UntriedGoals(x)),
    ("UntriedGoals", "candidates", FROM_1 | HUGE, lambda _, x: db.UntriedGoals(1.0, candidates=x)),
    ("UntriedGoals", "tries", FROM_1 | HUGE | NONE, lambda _, x: db.UntriedGoals(1.0, tries=x)),
    ("UntriedGoals", "reach", FROM_ONE, lambda _, x: db.UntriedGoals(1.0, reach=x)),
    ("UntriedGoals", "box", WRONG_SPACES, lambda _, x: db.UntriedGoals(1.0, box=x)),
    ("LocalJacobian", "k", FROM_1 | HUGE | NONE, lambda _, x: db.LocalJacobian(x)),
    ("LocalJacobian", "used", FROM_1 | HUGE | NONE, lambda _, x: db.LocalJacobian(9, x)),
    ("LocalJacobian", "ridge", POSITIVE, lambda _, x: db.LocalJacobian(ridge=x)),
    ("LocalJacobian", "reach", SHARE, lambda _, x: db.LocalJacobian(reach=x)),
    ("LocalJacobian", "noise", SHARE, lambda _, x: db.LocalJacobian(noise=x)),
    ("LocalJacobian", "goal", POINTS, lambda w, x: db.LocalJacobian().command(x, *w.past())),
    ("default_strategy", "tau", POSITIVE, lambda _, x: db.default_strategy(x)),
    ("default_strategy", "box", WRONG_SPACES, lambda _, x: db.default_strategy(1.0, goals=x)),
    ("default_strategies", "tau", POSITIVE, lambda _, x: db.default_strategies(x)),
    ("LocalRegression", "k", FROM_1 | HUGE | NONE, lambda _, x: db.LocalRegression(x)),
    ("LocalRegression", "d", SHARE, lambda _, x: db.LocalRegression(1, x)),
    ("LocalRegression", "ridge", POSITIVE, lambda _, x: db.LocalRegression(ridge=x)),
    ("LocalRegression", "reach", POSITIVE, lambda _, x: db.LocalRegression(reach=x)),
    ("LocalRegression", "goal", POINTS, lambda w, x: db.LocalRegression().command(x, *w.past())),
    ("Box.sample_many", "n", COUNTS | HUGE | NONE, lambda w, x: w.box.sample_many(x, w.rng)),
    ("Box.sample_many", "rng", NOT_GENERATORS, lambda w, x: w.box.sample_many(3, x)),
    ("Mixture", "strategies", NOT_STRATEGIES, lambda _, x: db.Mixture(x)),
    ("Mixture", "weights", NOT_WEIGHTS, lambda _, x: db.Mixture([RMB, RMB], weights=x)),
    ("Schedule", "phases", NOT_PHASES, lambda _, x: db.Schedule(x)),
    ("Adapt", "strategies", NOT_STRATEGIES, lambda _, x: db.Adapt(x)),
    ("Adapt", "tau", POSITIVE, lambda _, x: db.Adapt([RMB], tau=x)),
    ("Adapt", "window", FROM_1 | HUGE | NONE, lambda _, x: db.Adapt([RMB], window=x)),
    ("Adapt", "alpha", SHARE, lambda _, x: db.Adapt([RMB], alpha=x)),
    (
        "Adapt",
        "head_start",
        COUNTS | HUGE | NONE | {"51": 51},
        lambda _, x: db.Adapt([RMB], head_start=x),
    ),
    ("Adapt", "measure", NOT_MEASURES, lambda _, x: db.Adapt([RMB], measure=x)),
    (
        "Adapt with a measure",
        "tau",
        NUMBERS | {"another": 0.1},
        lambda _, x: db.Adapt([RMB], tau=x, measure=Grid(1.0)),
    ),
    ("Adapt", "power", NOT_BELOW, lambda _, x: db.Adapt([RMB], power=x)),
    ("Bandit", "strategies", NOT_STRATEGIES, lambda _, x: bandit(strategies=x)),
    ("Bandit", "credit", NOT_CREDITS, lambda _, x: bandit(credit=x)),
    ("Bandit", "memory", NOT_BANDIT_PARTS, lambda _, x: bandit(memory=x)),
    ("Bandit", "rule", NOT_BANDIT_PARTS, lambda _, x: bandit(rule=x)),
    ("CoverageGain", "tau", POSITIVE, lambda _, x: db.bandits.CoverageGain(x)),
    ("Gain", "measure", NOT_MEASURES | NONE, lambda _, x: db.bandits.Gain(x)),
    ("FunctionCredit", "function", NOT_CALLABLE, lambda _, x: db.bandits.FunctionCredit(x)),
    ("FunctionCredit", "bound", NOT_BELOW, lambda _, x: db.bandits.FunctionCredit(abs, bound=x)),
    ("Window", "size", FROM_1 | HUGE | NONE, lambda _, x: db.bandits.Window(x)),
    ("Window", "head_start", COUNTS | {"51": 51}, lambda _, x: db.bandits.Window(head_start=x)),
    ("RecentWindow", "size", FROM_1 | HUGE | NONE, lambda _, x: db.bandits.RecentWindow(x)),
    ("Discounted", "gamma", UPTO_1, lambda _, x: db.bandits.Discounted(x)),
    (
        "Discounted",
        "head_start",
        COUNTS | HUGE,
        lambda _, x: db.bandits.Discounted(0.5, head_start=x),
    ),
    ("Proportional", "alpha", SHARE, lambda _, x: db.bandits.Proportional(x)),
    ("Proportional", "power", NOT_BELOW, lambda _, x: db.bandits.Proportional(power=x)),
    ("EpsilonGreedy", "epsilon", SHARE, lambda _, x: db.bandits.EpsilonGreedy(x)),
    ("Softmax", "temperature", POSITIVE, lambda _, x: db.bandits.Softmax(x)),
    ("Softmax", "scaled", NOT_FLAGS, lambda _, x: db.bandits.Softmax(scaled=x)),
    ("UCB", "xi", NOT_BELOW, lambda _, x: db.bandits.UCB(x)),
    ("Exp3", "gamma", UPTO_1, lambda _, x: db.bandits.Exp3(x)),
    ("Exp3S", "gamma", UPTO_1, lambda _, x: db.bandits.Exp3S(x)),
    ("Exp3S", "alpha", UPTO_1, lambda _, x: db.bandits.Exp3S(alpha=x)),
    ("ucb1", "credit", NOT_CREDITS, lambda _, x: db.bandits.ucb1([RMB], credit=x)),
    ("sw-ucb", "size", FROM_1, lambda _, x: db.bandits.sliding_window_ucb([RMB], window=x)),
    ("d-ucb", "gamma", UPTO_1, lambda _, x: db.bandits.discounted_ucb([RMB], gamma=x)),
    ("d-ucb", "xi", NOT_BELOW, lambda _, x: db.bandits.discounted_ucb([RMB], gamma=1, xi=x)),
    ("Composite", "strategies", NOT_STRATEGIES, lambda _, x: InTurn(x)),
    ("explore", "environment", NOT_WORLDS, lambda w, x: db.explore(x, RMB, n=1, rng=w.rng)),
    ("explore", "strategy", NOT_ONE, lambda w, x: db.explore(w.arm, x, n=1, rng=w.rng)),
    ("explore", "n", FROM_1 | NONE, lambda w, x: db.explore(w.arm, RMB, n=x, rng=w.rng)),
    ("explore", "rng", NOT_SEEDS, lambda w, x: db.explore(w.arm, RMB, n=1, rng=x)),
    ("explore_many", "tasks", NOT_TASKS, lambda _, x: db.explore_many(x)),
    ("explore_many", "tasks", NOT_A_TASK, lambda w, x: many([w.task, x])),
    ("explore_many", "keep", NOT_CALLABLE, lambda w, x: db.explore_many([w.task], keep=x)),
    ("explore_many", "rng", NOT_SEEDS, lambda w, x: db.explore_many([w.task], rng=x)),
    ("explore_many", "jobs", FROM_1, lambda w, x: db.explore_many([w.task], jobs=x, rng=w.rng)),
    ("explore_many", "progress", NOT_CALLABLE, lambda w, x: db.explore_many([w.task], progress=x)),
    ("Task", "environment", NOT_WORLDS, lambda w, x: many([db.Task(x, RMB, 1, w.rng)])),
    ("Task", "strategy", NOT_ONE, lambda w, x: many([db.Task(w.arm, x, 1, w.rng)])),
    ("Task", "n", FROM_1 | NONE, lambda w, x: many([db.Task(w.arm, RMB, x, w.rng)])),
    ("Task", "rng", NOT_SEEDS, lambda w, x: many([db.Task(w.arm, RMB, 1, x)])),
    ("Task.over", "seeds", {"None": None, "a number": 25}, lambda w, x: w.task.over(x)),
    ("Task.over", "rng", NOT_SEEDS, lambda w, x: many(w.task.over([x]))),
    ("summarize", "tau", POSITIVE, lambda _, x: db.summarize(x)),
    ("summarize", "at", NOT_COUNTS | {"a number": 3}, lambda _, x: db.summarize(0.1, at=x)),
    ("summarize()", "at", {"beyond": [1, 4]}, lambda w, x: db.summarize(0.1, at=x)(w.run)),
    ("summarize()", "run", {"None": None, "effects": [[0, 0]]}, lambda _, x: db.summarize(0.1)(x)),
    ("Explorer", "strategy", NOT_ONE, lambda w, x: db.Explorer(x, w.box)),
    ("Explorer", "motor_space", NOT_SPACES, lambda _, x: db.Explorer(RMB, x)),
    ("Explorer", "sensory_space", WRONG_SPACES, lambda w, x: db.Explorer(RMB, w.box, x)),
    ("Explorer", "rng", NOT_SEEDS, lambda w, x: db.Explorer(RMB, w.box, rng=x)),
    ("Explorer.tell", "trial", NOT_TRIALS, lambda w, x: w.explorer.tell(x, [0.0, 0.0])),
    ("tell", "trial", {"by hand": 0}, lambda w, _: w.explorer.tell(w.by_hand, [0, 0])),
    ("Explorer.tell", "effect", POINTS, lambda w, x: w.explorer.tell(w.trial, x)),
    ("History", "motor_space", NOT_SPACES, lambda _, x: db.History(x)),
    ("History", "sensory_space", WRONG_SPACES, lambda w, x: db.History(w.box, x)),
    ("History.append", "command", POINTS | BEYOND, lambda w, x: w.history.append(x, [0.0, 0.0])),
    ("History.append", "effect", POINTS, lambda w, x: w.history.append([0.0, 0.0], x)),
    ("History().append", "effect", SIZED, lambda w, x: db.History(w.box).append([0.0, 0.0], x)),
    ("History.append", "path", PATHS, lambda w, x: w.history.append([0, 0], [0, 0], path=x)),
    ("History.nearest", "goal", POINTS, lambda w, x: w.history.nearest(x)),
    ("History.nearest", "k", FROM_1 | HUGE | {"4": 4}, lambda w, x: w.history.nearest([0, 0], k=x)),
    ("History.inverse", "goal", POINTS, lambda w, x: w.history.inverse(x, w.rng)),
    ("History.inverse", "rng", NOT_GENERATORS, lambda w, x: w.history.inverse([0, 0], x)),
    ("History.inverse", "d", SHARE, lambda w, x: w.history.inverse([0, 0], w.rng, d=x)),
    ("Coverage", "tau", POSITIVE, lambda _, x: db.Coverage(x)),
    ("Coverage", "dim", FROM_1 | HUGE | {"33": 33}, lambda _, x: db.Coverage(1.0, dim=x)),
    ("Coverage", "accuracy", STRICT_SHARE, lambda _, x: db.Coverage(1.0, accuracy=x)),
    ("Coverage of 5", "accuracy", STRICT_SHARE, lambda _, x: db.Coverage(1.0, dim=5, accuracy=x)),
    ("Coverage", "rng", NOT_SEEDS, lambda _, x: db.Coverage(1.0, rng=x)),
    ("Coverage of 5", "rng", NOT_SEEDS, lambda _, x: db.Coverage(1.0, dim=5, rng=x)),
    ("Coverage.add", "effect", BATCH, lambda w, x: w.coverage.add(x)),
    ("Coverage.gain", "effect", POINTS | BAD_ROWS, lambda w, x: w.coverage.gain(x)),
    ("Coverage.gain", "with_error", NOT_FLAGS, lambda w, x: w.coverage.gain([0, 0], with_error=x)),
    ("Coverage.contribution", "index", NOT_INDICES, lambda w, x: w.coverage.contribution(x)),
    (
        "Coverage.contribution",
        "with_error",
        NOT_FLAGS,
        lambda w, x: w.coverage.contribution(0, with_error=x),
    ),
    ("Coverage.contains", "points", POINTS | BAD_ROWS, lambda w, x: w.coverage.contains(x)),
    ("Coverage.extend", "effects", ROWS, lambda w, x: w.coverage.extend(x)),
    ("GridCoverage", "cell", EDGES, lambda _, x: Grid(x)),
    ("GridCoverage", "dim", FROM_1 | HUGE | NONE, lambda _, x: Grid(1.0, dim=x)),
    ("GridCoverage", "origin", PLACES, lambda _, x: Grid(1.0, origin=x)),
    ("GridCoverage.add", "effect", POINTS, lambda w, x: w.grid.add(x)),
    ("GridCoverage.gain", "effect", POINTS, lambda w, x: w.grid.gain(x)),
    ("GridCoverage.extend", "effects", ROWS, lambda w, x: w.grid.extend(x)),
    ("GridCoverage.add", "effect", FAR, lambda _, x: Grid(1e-10).add(x)),
    ("Sparseness", "k", FROM_1 | NONE, lambda _, x: db.Sparseness(x)),
    ("Sparseness", "dim", FROM_1 | HUGE | NONE, lambda _, x: db.Sparseness(dim=x)),
    ("Sparseness.add", "effect", POINTS | FAR, lambda w, x: w.sparseness.add(x)),
    ("Sparseness.gain", "effect", POINTS | FAR, lambda w, x: w.sparseness.gain(x)),
    ("Sparseness.extend", "effects", ROWS | FAR_ROWS, lambda w, x: w.sparseness.extend(x)),
    ("Entropy", "cell", EDGES, lambda _, x: db.Entropy(x)),
    ("Entropy", "dim", FROM_1 | HUGE | NONE, lambda _, x: db.Entropy(1.0, dim=x)),
    ("Entropy", "origin", PLACES, lambda _, x: db.Entropy(1.0, origin=x)),
    ("Entropy.add", "effect", POINTS, lambda w, x: w.entropy.add(x)),
    ("Entropy.gain", "effect", POINTS, lambda w, x: w.entropy.gain(x)),
    ("Entropy.extend", "effects", ROWS, lambda w, x: w.entropy.extend(x)),
    (
        "coverage",
        "effects",
        without(ROWS, "too short", "too long"),
        lambda _, x: db.coverage(x, 1.0),
    ),
    ("coverage", "accuracy", STRICT_SHARE, lambda _, x: db.coverage([[0] * 5], 1.0, accuracy=x)),
    ("coverage", "rng", NOT_SEEDS, lambda _, x: db.coverage([[0.0, 0.0]], 1.0, rng=x)),
    ("coverage", "tau", POSITIVE, lambda _, x: db.coverage([[0.0, 0.0]], x)),
    ("Tree", "dim", FROM_1 | NONE | {"huge": 2**64}, lambda _, x: Tree(x)),
    ("Tree.add", "point", POINTS, lambda w, x: w.tree.add(x)),
    ("Tree.extend", "points", ROWS, lambda w, x: w.tree.extend(x)),
    ("Tree.nearest", "query", POINTS, lambda w, x: w.tree.nearest(x)),
    ("Tree.nearest", "k", FROM_1 | HUGE | {"4": 4}, lambda w, x: w.tree.nearest([0, 0], k=x)),
    ("Exploration.coverage", "tau", POSITIVE, lambda w, x: w.run.coverage(x)),
    ("Exploration.diversity", "measure", NOT_MEASURES | NONE, lambda w, x: w.run.diversity(x)),
    ("diversity", "measure", {"of 3": Grid(1.0, dim=3)}, lambda w, x: w.run.diversity(x)),
    ("Exploration.load", "PathLike", {"None": None, "7": 7}, lambda _, x: db.Exploration.load(x)),
]
