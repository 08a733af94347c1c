"""The library's parts are immutable values: what each is follows from its fields.

`PARTS` holds instances of every public class; whatever is asked of values is asked of each.
"""

import copy
import dataclasses
import inspect
import json
import math
import pickle

import numpy as np
import optuna
import pytest
from mabwiser.mab import LearningPolicy as Of

import divbandit as db
from divbandit import bandits as b
from divbandit import controllers as c
from divbandit import environments as e
from divbandit import goals as g
from divbandit import inverse as i
from divbandit import measures as m
from divbandit._recipe import NoRecipeError, made_from, recipe_of
from divbandit._value import Value, field_names
from divbandit.adapters import MabwiserPolicy, OptunaSampler, QuasiRandomBabbling, RibsEmitter
from divbandit.callbacks import Every, Plateau, Progress, TimeBudget
from divbandit.environments import mujoco
from divbandit.environments.obstacles import Obstacle
from divbandit.experiments import Task
from tests.compositions import NAMES as STRATEGIES
from tests.compositions import adapted, compositions

SQUARE, ARM = db.Box([-1, -1], [1, 1]), e.PlanarArm(4)
#: No strategy is made of what is in these packages.
NOT_IN_FILES = ("environments", "benchmarks", "controllers", "experiments", "callbacks")


def swap(x):
    return x[::-1]


def product(x, y):
    return x * y


def hold(command, step, observation):
    del step, observation
    return command


def halves(observation):
    return observation[:1]


def final(episode):
    return episode.observations[-1]


def height(effect, history):
    del history
    return float(effect[1])


def parzen(seed):
    return optuna.samplers.TPESampler(n_startup_trials=5, seed=seed)


RMB, RGB = db.MotorBabbling(), db.GoalBabbling(0.25)
DISC = e.Disc([0, 0.5], 0.1)
HOLD = c.FunctionController(hold, db.Box([-2], [2]))

#: Instances of every class: with defaults alone, and with other arguments.
PARTS = [
    SQUARE,
    # Obstacles.
    DISC,
    e.Rectangle([0.2, 0.1], [0.6, 0.3]),
    e.Polygon([[0.5, 0.5], [0.9, 0.5], [0.6, 0.6]]),
    e.Wall([0, 0.5], [0, 2]),
    e.Wall((0, 0.5), np.array([0, 2]), thickness=0.125),
    # Environments.
    e.PlanarArm(),
    m.CellCoverage(3, SQUARE),
    m.CellCoverage([3, 4], SQUARE),
    db.benchmarks.ArmRepertoire(3),
    db.benchmarks.GrayScott(16, steps=500),
    db.benchmarks.Lenia(16, steps=50),
    db.benchmarks.Maze(),
    db.benchmarks.LinearProjection(4),
    db.benchmarks.LinearProjection(dim=6, objective="sphere"),
    e.PlanarArm(3, limit=1, thickness=0.02, obstacles=[DISC], self_contact=True),
    e.PushArm(),
    e.PushArm(2, limit=2.5, obstacles=(DISC,), ball=np.array([0.4, 0.2]), ball_radius=0.04),
    e.FunctionEnvironment(swap, SQUARE),
    e.FunctionEnvironment(product, SQUARE, db.Box([-1], [1]), scalars=True),
    e.ProcessEnvironment(["echo"], SQUARE),
    e.ProcessEnvironment(["echo", "--"], SQUARE, db.Box([0], [1]), timeout=5, entry="y"),
    e.GymnasiumEnvironment("Pendulum-v1", HOLD, final, 10, 0),
    e.GymnasiumEnvironment("Pendulum-v1", HOLD, final, 10, 0, sensory_space=SQUARE),
    e.Controlled(e.PlanarArm(2), c.ViaPoints([-1, -1], [1, 1], steps=3)),
    # Controllers.
    HOLD,
    c.MovementPrimitives(2),
    c.MovementPrimitives(2, basis=3, steps=7, weights=2, goals=None, start=[0.5, 0], limit=1),
    c.ViaPoints([-1], [1], steps=4),
    c.ViaPoints(np.array([-1.0]), [1], steps=4, points=2, start=[0.5]),
    c.OpenLoop(c.MovementPrimitives(1, basis=2, steps=3)),
    c.Tracking(c.ViaPoints([-1], [1], steps=4), halves, halves, dt=1, stiffness=2, damping=0),
    c.Tracking(
        c.ViaPoints([-1], [1], steps=4),
        positions=halves,
        velocities=halves,
        dt=0.5,
        stiffness=[2],
        damping=np.array([0.5]),
        limit=1,
        turns=True,
    ),
    # Experiments.
    Task(e.PlanarArm(2), db.MotorBabbling(), 10),
    Task(e.PlanarArm(2), RGB, n=10, rng=3, engine="python", keep_commands=False),
    # Callbacks.
    Every(10, product),
    Every("30s", TimeBudget(60)),
    Plateau(500, 0.01),
    Plateau(np.int64(500), share=0, tau=1),
    Plateau(500, 1, measure=m.GridCoverage(0.5)),
    Progress(),
    Progress(tau=1),
    Progress(measure=m.Sparseness(3)),
    TimeBudget("2h"),
    TimeBudget(0.25),
    # Goal samplers.
    g.UniformGoals(),
    g.UniformGoals(SQUARE),
    g.GridGoals(3),
    g.GridGoals(np.array([4, 5]), box=SQUARE),
    g.UncoveredGoals(0.1),
    g.UncoveredGoals(1, tries=7, box=SQUARE),
    g.FrontierGoals(0.1),
    g.FrontierGoals(1, reach=3, tries=7, box=SQUARE),
    g.NovelGoals(),
    g.NovelGoals(3, box=SQUARE),
    g.UntriedGoals(0.1),
    g.UntriedGoals(1, candidates=3, tries=7, reach=3, box=SQUARE),
    # Inverse models.
    i.Nearest(),
    i.Nearest(0.25),
    i.KNearest(),
    i.KNearest(3, 1),
    i.LineVariation(),
    i.LineVariation(0.25, along=1),
    i.Crossover(),
    i.Crossover(3, 0.25),
    i.LocalRegression(),
    i.LocalRegression(3, 0.25, ridge=1, reach=2),
    i.LocalJacobian(),
    i.LocalJacobian(9, 5, ridge=1, reach=0.5, noise=0),
    # Measures.
    m.BallCoverage(0.1),
    m.BallCoverage(1, accuracy=0.5),
    m.GridCoverage(0.5),
    m.GridCoverage(np.array([0.5, 1]), origin=[1, 2]),
    m.Sparseness(),
    m.Sparseness(3),
    m.Entropy(0.5),
    m.Entropy([0.5, 1], origin=1),
    # Rewards.
    b.Gain(m.BallCoverage(0.1)),
    b.CompetenceProgress(),
    b.FunctionReward(height),
    b.FunctionReward(height, bound=1),
    # Estimators.
    b.Window(),
    b.Window(5, head_start=0),
    b.RecentWindow(5),
    b.Discounted(0.9),
    b.Discounted(1, head_start=2),
    b.WholePast(),
    # Policies.
    b.Proportional(),
    b.Proportional(0.25, power=2),
    b.EpsilonGreedy(0.25),
    b.Softmax(),
    b.Softmax(0.25, scaled=False),
    b.UCB(),
    b.UCB(0.5),
    b.Thompson(),
    b.Exp3(0.25),
    b.Exp3S(0.25, 0.5),
    b.RoundRobin(),
    b.Uniform(),
    # Policies of MABWiser are tuples, which compare equal across kinds.
    MabwiserPolicy(Of.UCB1(alpha=1.5)),
    MabwiserPolicy(Of.Popularity()),
    MabwiserPolicy(Of.Random()),
    # Strategies.
    RMB,
    db.GoalBabbling(),
    RGB,
    db.GoalBabbling(0.25, goals=SQUARE),
    db.GoalBabbling(goals=g.NovelGoals(3), inverse=i.KNearest(3)),
    db.Mixture([RMB, RGB]),
    db.Mixture((RMB, RGB), weights=np.array([1, 3])),
    db.Schedule([(3, RMB), (None, RGB)]),
    db.Adapt([RMB, RGB]),
    db.Adapt([RMB], tau=1, window=5, alpha=0.25, head_start=0, power=2),
    db.Adapt(iter([RMB]), reward=height),
    db.Adapt([RMB], reward=b.Gain(m.GridCoverage(0.5))),
    db.Bandit([RMB, RGB], estimator=b.Window(), policy=b.UCB(), tau=0.5),
    db.Bandit([RMB], estimator=b.WholePast(), policy=b.Thompson(), reward=b.CompetenceProgress()),
    db.default_strategy(0.1, goals=SQUARE),
    QuasiRandomBabbling(),
    OptunaSampler(),
    OptunaSampler(optuna.samplers.RandomSampler, reward=b.CompetenceProgress()),
    OptunaSampler(parzen),
    RibsEmitter(),
    RibsEmitter("evolution", box=SQUARE, cells=50, objective=height),
    RibsEmitter(hold, archive=product),
]
IDS = [f"{type(part).__name__}-{index}" for index, part in enumerate(PARTS)]

#: Where the public classes are.
PACKAGES = (
    db,
    db.environments,
    db.benchmarks,
    db.controllers,
    db.goals,
    db.inverse,
    db.measures,
    db.bandits,
    db.adapters,
    db.callbacks,
    db.experiments,
)

#: What the representation of a part may name.
NAMES = {
    **{name: item for package in PACKAGES for name, item in vars(package).items()},
    **{each.__name__: each for each in (swap, product, hold, halves, final, height, parzen)},
    **vars(optuna.samplers),
    **{each.__name__: each for each in (Of.UCB1, Of.Popularity, Of.Random)},
}

each_part = pytest.mark.parametrize("part", PARTS, ids=IDS)


def repickled(part):
    return pickle.loads(pickle.dumps(part))  # noqa: S301 - just written


def assert_alike(other, part):
    assert type(other) is type(part)
    assert repr(other) == repr(part)
    assert other == part
    assert hash(other) == hash(part)


@each_part
def test_fields_are_the_arguments_of_the_constructor(part):
    assert isinstance(part, Value)
    assert field_names(part) == list(inspect.signature(type(part)).parameters)


@each_part
def test_no_field_can_be_set_or_deleted(part):
    for name in field_names(part):
        with pytest.raises(dataclasses.FrozenInstanceError):
            setattr(part, name, getattr(part, name))
        with pytest.raises(dataclasses.FrozenInstanceError):
            delattr(part, name)


@each_part
def test_no_other_attribute_can_be_set(part):
    with pytest.raises(dataclasses.FrozenInstanceError):
        part.no_such_field = 1


@each_part
def test_its_repr_evaluates_to_an_equal_part(part):
    assert_alike(eval(repr(part), dict(NAMES)), part)  # noqa: S307 - our own


@pytest.mark.parametrize(
    "words",
    [
        "Box([-1.0, 0.0], [1.0, 2.0])",
        "RibsEmitter()",
        "LocalJacobian(reach=0.5)",
        "Task(PlanarArm(2), MotorBabbling(), 10, engine='rust')",
        "Adapt([MotorBabbling()], tau=0.02)",
        "Adapt([MotorBabbling()], reward=Gain(GridCoverage([0.5, 1.0], origin=2.0)))",
    ],
)
def test_its_repr_omits_defaults(words):
    assert repr(eval(words, dict(NAMES))) == words  # noqa: S307 - our own


@each_part
@pytest.mark.parametrize("again", [repickled, copy.copy, copy.deepcopy, dataclasses.replace])
def test_copies_are_equal(part, again):
    assert_alike(again(part), part)


@each_part
def test_it_is_made_of_its_fields(part):
    assert_alike(type(part)(**{name: getattr(part, name) for name in field_names(part)}), part)


@pytest.mark.parametrize("k", range(len(PARTS)), ids=IDS)
def test_parts_differ(k):
    assert [part == PARTS[k] for part in PARTS] == [index == k for index in range(len(PARTS))]
    assert PARTS[k] != "another thing"


def test_equal_arguments_of_other_types_make_equal_parts():
    assert e.Disc((0, 0.5), np.float64(0.1)) == DISC
    assert e.PlanarArm(np.int64(20), limit=math.radians(150)) == e.PlanarArm()
    assert e.PlanarArm(2, obstacles=iter([DISC])) == e.PlanarArm(2, obstacles=[DISC])
    assert len({e.PlanarArm(2), e.PlanarArm(2), e.PlanarArm(2, limit=2), e.PushArm(2)}) == 3


def test_replacing_an_argument_checks_it():
    assert dataclasses.replace(e.PlanarArm(2), joints=3).motor_space.dim == 3
    with pytest.raises(ValueError, match="limit"):
        dataclasses.replace(e.PlanarArm(2), limit=-1)


@pytest.mark.parametrize("make", [mujoco.reacher, mujoco.pusher])
def test_the_arms_of_mujoco_are_values_too(make):
    environment = make()
    assert repickled(environment) == environment
    assert eval(repr(environment), {**NAMES, **vars(mujoco)}) == environment  # noqa: S307 - our own


def public_values():
    return {
        each
        for package in PACKAGES
        for each in (getattr(package, name) for name in package.__all__)
        if isinstance(each, type) and issubclass(each, Value)
    }


def test_every_public_class_has_an_instance_here():
    # An Obstacle is abstract; a Loop is a result, which has its own tests.
    assert public_values() - {type(part) for part in PARTS} - {Obstacle, m.Loop} == set()


def test_no_public_part_is_anything_else():
    """All that can be started or gives effects is a value, but for what users derive from."""
    named = {
        f"{package.__name__}.{name}": getattr(package, name)
        for package in PACKAGES
        for name in package.__all__
        if isinstance(getattr(package, name), type)
    }
    parts = {name for name, each in named.items() if hasattr(each, "start") or is_black_box(each)}
    values = {name for name, each in named.items() if issubclass(each, Value)}
    theirs = {"Strategy", "Composite", "Environment", "Measure", "Reward", "Estimator", "Policy"}
    theirs.add("Callback")
    assert {name for name in parts - values if name.split(".")[-1] not in theirs} == set()


def is_black_box(each):
    return "__call__" in dir(each) and hasattr(each, "sensory_space")


OF_STRATEGIES = [part for part in PARTS if type(part).__module__.split(".")[1] not in NOT_IN_FILES]


@pytest.mark.parametrize("part", OF_STRATEGIES, ids=repr)
def test_a_recipe_in_json_makes_an_equal_part(part):
    try:
        recipe = json.loads(json.dumps(recipe_of(part)))
    except NoRecipeError:
        assert has_a_users(part)
    else:
        assert not has_a_users(part)
        assert_alike(made_from(recipe), part)


def has_a_users(part):
    """Say whether a function, or a part of another library, is among its fields."""
    fields = [getattr(part, name) for name in field_names(part)]
    return any(
        has_a_users(each) if isinstance(each, Value) else callable(each) or hasattr(each, "_fields")
        for each in fields
    )


def stepped(explorer, count):
    for _ in range(count):
        trial = explorer.ask()
        explorer.tell(trial, ARM(trial.command))


@pytest.mark.parametrize(
    ("name", "engine"),
    [(name, "python") for name in STRATEGIES]
    + [(name, "auto") for name in STRATEGIES if name not in adapted()],
)
def test_a_strategy_in_two_explorations_at_once(name, engine):
    """Neither notices the other, and the value is what it was."""
    strategy = compositions()[name]
    before, pickled = repr(strategy), pickle.dumps(strategy)

    def explorer(seed):
        return db.Explorer(strategy, ARM.motor_space, ARM.sensory_space, rng=seed, engine=engine)

    alone = [explorer(seed) for seed in range(2)]
    for each in alone:
        stepped(each, 24)
    together = [explorer(seed) for seed in range(2)]
    for count in (1, 2, 5, 16):
        for each in together:
            stepped(each, count)
    for one, other in zip(together, alone, strict=True):
        assert one.history.commands.tobytes() == other.history.commands.tobytes()
        assert one.history.paths == other.history.paths
        assert one.estimates == other.estimates
    assert together[0].history.commands.tobytes() != together[1].history.commands.tobytes()
    assert (repr(strategy), pickle.dumps(strategy)) == (before, pickled)
