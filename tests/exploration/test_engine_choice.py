"""Which engine runs what: "rust" names what stands in its way, "auto" runs it in Python."""

from dataclasses import dataclass
from types import SimpleNamespace

import numpy as np
import pytest

import divbandit as db
from divbandit import bandits, goals, inverse
from divbandit.adapters import QuasiRandomBabbling
from divbandit.exploration import drivers
from tests.exploration.refusals import ARM, ENGINES, Mine, N, assert_refused
from tests.exploration.sameness import differences
from tests.generators import state, twins
from tests.measures.every import Furthest

RMB, RGB = db.MotorBabbling(), db.GoalBabbling(0.05)


class Corners(db.Strategy):
    def propose(self, history, rng):
        space = history.motor_space
        return np.where(rng.random(space.dim) < 0.5, space.low, space.high)


class InTurn(db.Composite):
    def choose(self, history, rng):
        del rng
        return len(history) % len(self.strategies)


class Mirrored(db.MotorBabbling):
    """A subclass of the library's, with a method of its own."""

    def propose(self, history, rng):
        return -super().propose(history, rng).command


class Origin:
    """A goal sampler and an inverse model."""

    def sample(self, history, rng):
        del rng
        return [0.0] * history.effect_dim

    def command(self, goal, history, rng):
        del goal
        return history.motor_space.sample(rng) / 2


class Chance:
    """A policy."""

    def start(self, parts, largest):
        del parts, largest
        return self

    def choose(self, estimates, rng):
        return int(rng.random() * len(estimates.means))


class Newest:
    """An estimator: of each part the newest reward."""

    def start(self, parts, largest):
        self.means, self.counts, self.largest = [0.0] * parts, [0.0] * parts, largest
        return self

    def add(self, part, reward):
        self.means[part] = reward
        self.counts[part] += 1


class Far:
    """A reward: how far the newest effect is from the origin."""

    def start(self, dim):
        del dim
        return self

    def largest(self, dim):
        return 1.0 + 0 * dim

    def of(self, trial, effect, history):
        del trial, history
        return float(np.hypot(*effect))


@dataclass(frozen=True, init=False, repr=False)
class MyUniformGoals(goals.UniformGoals):
    """The library's sampler, but not its class."""


def height(effect, history):
    del history
    return float(effect[1])


def bandit(**parts):
    given = {"tau": 0.1, "estimator": bandits.WholePast(), "policy": bandits.UCB(), **parts}
    return db.Bandit([RMB, RGB], **given)


#: A strategy; the part of it that stands in the way, and its class.
STRATEGIES = {
    "a strategy": (Corners(), "strategy", "Corners"),
    "a composite": (InTurn([RMB]), "strategy", "InTurn"),
    "a subclass": (Mirrored(), "strategy", "Mirrored"),
    "in a mixture": (db.Mixture([RMB, Corners()]), "strategy.strategies[1]", "Corners"),
    "in a schedule": (
        db.Schedule([(5, RMB), (5, RGB), (5, Corners())]),
        "strategy.phases[2]",
        "Corners",
    ),
    "in a bandit": (db.Adapt([Mirrored(), RMB]), "strategy.strategies[0]", "Mirrored"),
    "deep inside": (
        db.Adapt([RMB, db.Mixture([db.Schedule([(1, RMB), (None, Corners())])])]),
        "strategy.strategies[1].strategies[0].phases[1]",
        "Corners",
    ),
    "goals": (db.GoalBabbling(goals=Origin()), "strategy.goals", "Origin"),
    "an inverse model": (
        db.Adapt([RMB, db.GoalBabbling(inverse=Origin())]),
        "strategy.strategies[1].inverse",
        "Origin",
    ),
    "a function as reward": (
        db.Adapt([RMB, RGB], reward=height),
        "strategy.reward",
        "FunctionReward",
    ),
    "a reward": (db.Adapt([RMB, RGB], reward=Far()), "strategy.reward", "Far"),
    "a measure": (
        bandit(tau=None, reward=bandits.Gain(Furthest())),
        "strategy.reward.measure",
        "Furthest",
    ),
    "an estimator": (bandit(estimator=Newest()), "strategy.estimator", "Newest"),
    "a policy": (
        db.Mixture([RMB, bandit(policy=Chance())]),
        "strategy.strategies[1].policy",
        "Chance",
    ),
    "an adapter": (QuasiRandomBabbling(), "strategy", "QuasiRandomBabbling"),
}


@pytest.mark.parametrize("name", STRATEGIES)
def test_rust_names_the_part(name):
    strategy, part, kind = STRATEGIES[name]
    assert_refused(part, kind, strategy, np.random.default_rng(0))


@pytest.mark.parametrize("name", STRATEGIES)
def test_auto_runs_it_in_python(name):
    strategy, *_ = STRATEGIES[name]
    rngs = twins(np.random.PCG64)
    runs = [
        db.explore(ARM, strategy, N, rng=rng, engine=engine)
        for rng, engine in zip(rngs, ("auto", "python"), strict=True)
    ]
    assert differences(*runs) == []
    assert state(rngs[0]) == state(rngs[1])


def test_an_explorer_names_the_part_too():
    with pytest.raises(ValueError, match=r'"rust" .*got strategy\.strategies\[1\], a Corners'):
        db.Explorer(db.Mixture([RMB, Corners()]), ARM.motor_space, engine="rust")


@pytest.mark.parametrize("engine", ENGINES)
def test_a_subclass_of_a_sampler_is_refused_by_name(engine):
    """It inherits how the library's starts, which a method of its own would not change."""
    strategy = db.GoalBabbling(goals=MyUniformGoals())
    with pytest.raises((TypeError, ValueError), match="MyUniformGoals"):
        db.explore(ARM, strategy, N, rng=0, engine=engine)


class MyArm(db.PlanarArm):
    def __call__(self, command):
        return super().__call__(command) / 2


LIKE_A_BOX = SimpleNamespace(low=[-1] * 3, high=[1] * 3)
LIKE_A_PLANE = SimpleNamespace(low=[-1, -1], high=[1, 1])


@pytest.mark.parametrize(
    "environment",
    [
        MyArm(3),
        Mine(),
        Mine(motor_space=LIKE_A_BOX),
        Mine(sensory_space=LIKE_A_PLANE),
        Mine(motor_space=LIKE_A_BOX, sensory_space=None),
        db.FunctionEnvironment(ARM, db.Box([-1] * 3, [1] * 3), LIKE_A_PLANE),
    ],
    ids=["subclass", "class", "motor space", "sensory space", "no sensory space", "function"],
)
def test_no_environment_stands_in_the_way(environment):
    wide = db.GoalBabbling(0.5, goals=db.Box([-1, -1], [1, 1]))
    strategy = db.Mixture([RMB, db.Adapt([RMB, wide], tau=0.1)])
    rngs = twins(np.random.PCG64)
    runs = [
        db.explore(environment, strategy, N, rng=rng, engine=engine)
        for rng, engine in zip(rngs, ("python", "rust"), strict=True)
    ]
    assert differences(*runs) == []
    assert state(rngs[0]) == state(rngs[1])


@pytest.mark.parametrize("engine", ["fast", "Rust", "", None, 1, True, ["rust"]])
def test_an_unknown_engine(engine):
    rng, plain = twins(np.random.PCG64)
    for call in (
        lambda: db.explore(ARM, RMB, N, rng=rng, engine=engine),
        lambda: db.Explorer(RMB, ARM.motor_space, rng=rng, engine=engine),
    ):
        with pytest.raises((TypeError, ValueError), match=r"^engine must be .*got ") as caught:
            call()
        assert not isinstance(engine, str) or all(name in str(caught.value) for name in ENGINES)
    assert state(rng) == state(plain)


class Forbidden(Exception):  # noqa: N818 - it is no error
    """The loop in Python was entered."""


@pytest.mark.parametrize(
    "strategy",
    [
        RMB,
        db.GoalBabbling(inverse=inverse.LocalJacobian(), goals=goals.UntriedGoals(0.1)),
        db.Schedule([(5, RMB), (None, db.Adapt([RMB, db.Mixture([RMB, RGB])], tau=0.1))]),
        bandit(),
        db.default_strategy(0.1),
    ],
    ids=["motor", "goals", "schedule", "bandit", "default"],
)
def test_auto_takes_rust_where_it_can(strategy, monkeypatch):
    def driver(*_):
        raise Forbidden

    monkeypatch.setattr(drivers, "PythonDriver", driver)
    for engine in ("auto", "rust"):
        for environment in (ARM, Mine()):
            assert len(db.explore(environment, strategy, N, rng=0, engine=engine)) == N
    for other, engine in ((strategy, "python"), (db.Mixture([strategy, Corners()]), "auto")):
        with pytest.raises(Forbidden):
            db.explore(ARM, other, N, rng=0, engine=engine)


def test_one_value_explores_again_and_again():
    schedule = db.Schedule([(4, RMB), (None, RGB)])
    strategy = db.Mixture([db.Adapt([RMB, schedule], tau=0.2), schedule])
    words = repr(strategy)
    runs = [db.explore(ARM, strategy, N, rng=0, engine=engine) for engine in ENGINES * 2]
    assert [differences(run, runs[0]) for run in runs] == [[]] * 6
    assert repr(strategy) == words
