"""The library's parts are immutable values: what each is follows from its fields.

`PARTS` holds instances of every public class; whatever is asked of values is asked of each.
"""

import copy
import dataclasses
import inspect
import math
import pickle

import numpy as np
import pytest
from mabwiser.mab import LearningPolicy
from optuna.samplers import CmaEsSampler

import divbandit as db
from divbandit import adapters, bandits, goals, inverse, measures
from divbandit._value import Value, field_names
from divbandit.controllers import (
    FunctionController,
    MovementPrimitives,
    OpenLoop,
    Tracking,
    ViaPoints,
)
from divbandit.environments import (
    Controlled,
    Disc,
    FunctionEnvironment,
    GymnasiumEnvironment,
    PlanarArm,
    Polygon,
    ProcessEnvironment,
    PushArm,
    Rectangle,
    Wall,
    mujoco,
)
from divbandit.environments.obstacles import Obstacle
from divbandit.experiments import Task

SQUARE = db.Box([-1, -1], [1, 1])
RMB, RGB = db.MotorBabbling(), db.GoalBabbling()


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


DISC = Disc([0, 0.5], 0.1)
HOLD = FunctionController(hold, db.Box([-2], [2]))

#: Instances of every class: with defaults alone, and with other arguments.
PARTS = [
    SQUARE,
    # Obstacles.
    DISC,
    Rectangle([0.2, 0.1], [0.6, 0.3]),
    Polygon([[0.5, 0.5], [0.9, 0.5], [0.6, 0.6]]),
    Wall([0, 0.5], [0, 2]),
    Wall((0, 0.5), np.array([0, 2]), thickness=0.125),
    # Environments.
    PlanarArm(),
    PlanarArm(3, limit=1, thickness=0.02, obstacles=[DISC], self_contact=True),
    PushArm(),
    PushArm(2, limit=2.5, obstacles=(DISC,), ball=np.array([0.4, 0.2]), ball_radius=0.04),
    FunctionEnvironment(swap, SQUARE),
    FunctionEnvironment(product, SQUARE, db.Box([-1], [1]), scalars=True),
    ProcessEnvironment(["echo"], SQUARE),
    ProcessEnvironment(["echo", "--"], SQUARE, db.Box([0], [1]), timeout=5, entry="y"),
    GymnasiumEnvironment("Pendulum-v1", HOLD, final, 10, 0),
    GymnasiumEnvironment("Pendulum-v1", HOLD, final, 10, 0, sensory_space=SQUARE),
    Controlled(PlanarArm(2), ViaPoints([-1, -1], [1, 1], steps=3)),
    # Controllers.
    HOLD,
    MovementPrimitives(2),
    MovementPrimitives(2, basis=3, steps=7, weights=2, goals=None, start=[0.5, 0], limit=1),
    ViaPoints([-1], [1], steps=4),
    ViaPoints(np.array([-1.0]), [1], steps=4, points=2, start=[0.5]),
    OpenLoop(MovementPrimitives(1, basis=2, steps=3)),
    Tracking(ViaPoints([-1], [1], steps=4), halves, halves, dt=1, stiffness=2, damping=0),
    Tracking(
        ViaPoints([-1], [1], steps=4),
        positions=halves,
        velocities=halves,
        dt=0.5,
        stiffness=[2],
        damping=np.array([0.5]),
        limit=1,
        turns=True,
    ),
    # Goal samplers and inverse models.
    goals.UniformGoals(),
    goals.UniformGoals(SQUARE),
    goals.GridGoals(5),
    goals.GridGoals([4, 5], box=SQUARE),
    goals.UncoveredGoals(0.1),
    goals.UncoveredGoals(0.1, box=SQUARE),
    goals.FrontierGoals(0.1),
    goals.FrontierGoals(0.1, box=SQUARE),
    goals.NovelGoals(3),
    goals.NovelGoals(2, box=SQUARE),
    goals.UntriedGoals(0.1),
    goals.UntriedGoals(0.1, box=SQUARE, candidates=4),
    inverse.Nearest(0.05),
    inverse.KNearest(3, 0.05),
    inverse.KNearest(2),
    inverse.LocalRegression(8, 0.05),
    inverse.LocalJacobian(),
    # Measures.
    measures.BallCoverage(0.1),
    measures.BallCoverage(0.1, accuracy=0.01),
    measures.GridCoverage(0.1),
    measures.GridCoverage([0.1, 0.2], origin=[0, 1]),
    measures.Sparseness(),
    measures.Sparseness(3),
    measures.Entropy(0.1),
    measures.Entropy([0.1, 0.2], origin=0.5),
    # Rewards, estimators and policies.
    bandits.Gain(measures.Sparseness()),
    bandits.CompetenceProgress(),
    bandits.FunctionReward(product),
    bandits.FunctionReward(product, bound=2),
    bandits.Window(),
    bandits.Window(20, head_start=0),
    bandits.RecentWindow(20),
    bandits.Discounted(0.5),
    bandits.Discounted(0.5, head_start=1),
    bandits.WholePast(),
    bandits.Proportional(),
    bandits.Proportional(0.2, power=2),
    bandits.EpsilonGreedy(0.1),
    bandits.Softmax(0.1),
    bandits.UCB(2),
    bandits.Thompson(),
    bandits.Exp3(0.1),
    bandits.Exp3S(0.1, 0.01),
    bandits.RoundRobin(),
    bandits.Uniform(),
    adapters.MabwiserPolicy(LearningPolicy.UCB1(0.5)),
    adapters.MabwiserPolicy(LearningPolicy.Popularity()),
    # Strategies.
    RMB,
    RGB,
    db.GoalBabbling(0.25, goals=SQUARE),
    db.GoalBabbling(goals=goals.NovelGoals(3), inverse=inverse.LocalJacobian()),
    db.Mixture([RMB, RGB]),
    db.Mixture([RMB, RGB], weights=[0.25, 0.75]),
    db.Schedule([(10, RMB), (None, RGB)]),
    db.Adapt([RMB, RGB]),
    db.Adapt([RMB, RGB], tau=0.1, window=20, alpha=0.2, head_start=0, power=2),
    db.Adapt([RMB, db.Mixture([RMB, RGB])], reward=product),
    db.Adapt([RMB, RGB], reward=bandits.Gain(measures.GridCoverage(0.1))),
    db.Bandit([RMB, RGB], tau=0.1, estimator=bandits.Window(), policy=bandits.Uniform()),
    db.Bandit([RMB], reward=product, estimator=bandits.Window(9), policy=bandits.UCB(2)),
    db.default_strategy(0.1),
    adapters.QuasiRandomBabbling(),
    adapters.OptunaSampler(),
    adapters.OptunaSampler(CmaEsSampler, reward=bandits.CompetenceProgress()),
    adapters.RibsEmitter(),
    adapters.RibsEmitter("evolution", box=SQUARE, cells=7, objective=product),
    adapters.RibsEmitter(hold, archive=product),
    # Experiments.
    Task(PlanarArm(2), db.MotorBabbling(), 10),
]
IDS = [f"{type(part).__name__}-{index}" for index, part in enumerate(PARTS)]

#: What the representation of a part may name.
NAMES = {
    **vars(db),
    **vars(db.controllers),
    **vars(db.environments),
    **vars(db.experiments),
    **vars(db.goals),
    **vars(db.inverse),
    **vars(db.measures),
    **vars(db.bandits),
    **vars(db.adapters),
    **{each.__name__: each for each in (LearningPolicy.UCB1, LearningPolicy.Popularity)},
    "CmaEsSampler": CmaEsSampler,
    **{each.__name__: each for each in (swap, product, hold, halves, final)},
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
    assert Disc((0, 0.5), np.float64(0.1)) == DISC
    assert PlanarArm(np.int64(20), limit=math.radians(150)) == PlanarArm()
    assert PlanarArm(2, obstacles=iter([DISC])) == PlanarArm(2, obstacles=[DISC])
    assert len({PlanarArm(2), PlanarArm(2), PlanarArm(2, limit=2), PushArm(2)}) == 3


def test_replacing_an_argument_checks_it():
    assert dataclasses.replace(PlanarArm(2), joints=3).motor_space.dim == 3
    with pytest.raises(ValueError, match="limit"):
        dataclasses.replace(PlanarArm(2), limit=-1)


@pytest.mark.parametrize("make", [mujoco.reacher, mujoco.pusher])
def test_the_arms_of_mujoco_are_values_too(make):
    environment = make()
    assert repickled(environment) == environment
    assert eval(repr(environment), {**NAMES, **vars(mujoco)}) == environment  # noqa: S307 - our own


def public_values():
    kinds = (getattr(db, name) for name in db.__all__)
    packages = [db, *filter(inspect.ismodule, kinds)]
    return {
        each
        for package in packages
        for each in (getattr(package, name) for name in package.__all__)
        if isinstance(each, type) and issubclass(each, Value)
    }


def test_every_public_class_has_an_instance_here():
    assert public_values() - {type(part) for part in PARTS} - {Obstacle} == set()
