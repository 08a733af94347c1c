"""Which engine runs what: "rust" names what stands in its way, "auto" honours what is Python."""

from types import SimpleNamespace

import numpy as np
import pytest

import divbandit as db
from tests.exploration.refusals import ENGINES, Mine, N, assert_refused, spaced
from tests.exploration.sameness import differences
from tests.generators import state, twins

RMB, RGB = db.MotorBabbling, db.GoalBabbling


class Corners(db.Strategy):
    def propose(self, history, rng):
        space = history.motor_space
        return np.where(rng.random(space.dim) < 0.5, space.low, space.high)


class InTurn(db.Composite):
    def choose(self, history, rng):
        del rng
        return len(history) % len(self.strategies)


class MyBabbling(db.MotorBabbling):
    pass


class MyGoals(db.GoalBabbling):
    pass


class MyMixture(db.Mixture):
    pass


class MySchedule(db.Schedule):
    pass


class MyAdapt(db.Adapt):
    pass


class MyCoverage(db.Coverage):
    pass


class MyUniformGoals(db.UniformGoals):
    pass


class MyNearest(db.NearestNeighbor):
    pass


class MyBox(db.Box):
    def sample(self, rng):
        return (self.low + self.high) / 2 + 0 * rng.random()


class MyArm(db.PlanarArm):
    def __call__(self, command):
        return super().__call__(command) / 2


class MyGenerator(np.random.Generator):
    pass


def shadowed(strategy, **methods):
    """Return a strategy, some of whose methods are attributes of its own."""
    for name, method in methods.items():
        setattr(strategy, name, method)
    return strategy


def half(history, rng):
    del rng
    return history.motor_space.high / 2


def nothing(*args, **names):
    del args, names


def last(history, rng):
    del history, rng
    return 1


WIDE = MyBox([-1, -1], [1, 1])
WIDE_PLANE = db.Box([-1, -1], [1, 1])
LIKE_A_BOX = SimpleNamespace(low=[-1] * 3, high=[1] * 3)
LIKE_A_PLANE = SimpleNamespace(low=[-1, -1], high=[1, 1])

#: A strategy; the part of it that stands in the way, and what it is.
STRATEGIES = [
    (Corners(), "strategy", "Corners"),
    (InTurn([RMB()]), "strategy", "InTurn"),
    (MyBabbling(), "strategy", "MyBabbling"),
    (MyGoals(0.05), "strategy", "MyGoals"),
    (MyMixture([RMB()]), "strategy", "MyMixture"),
    (MySchedule([(None, RMB())]), "strategy", "MySchedule"),
    (MyAdapt([RMB()]), "strategy", "MyAdapt"),
    (db.Mixture([RMB(), Corners()]), "strategy.strategies[1]", "Corners"),
    (db.Schedule([(5, RMB()), (5, RGB()), (5, Corners())]), "strategy.strategies[2]", "Corners"),
    (db.Adapt([MyBabbling(), RMB()]), "strategy.strategies[0]", "MyBabbling"),
    (
        db.Adapt([RMB(), db.Mixture([db.Schedule([(1, RMB()), (None, Corners())])])]),
        "strategy.strategies[1].strategies[0].strategies[1]",
        "Corners",
    ),
    (db.Adapt([RMB()], measure=db.GridCoverage(0.1)), "strategy.measure", "GridCoverage"),
    (db.Adapt([RMB()], measure=db.Sparseness()), "strategy.measure", "Sparseness"),
    (db.Adapt([RMB()], measure=db.Entropy([0.1, 0.2])), "strategy.measure", "Entropy"),
    (db.Adapt([RMB()], measure=MyCoverage(0.1)), "strategy.measure", "MyCoverage"),
    (
        db.Mixture([RMB(), db.Adapt([RMB()], measure=db.GridCoverage(0.1))]),
        "strategy.strategies[1].measure",
        "GridCoverage",
    ),
    (RGB(0.05, goals=WIDE), "strategy.goals", "MyBox"),
    (db.Mixture([RGB(0.05, goals=WIDE)]), "strategy.strategies[0].goals", "MyBox"),
    (RGB(goals=db.UniformGoals(WIDE)), "strategy.goals.box", "MyBox"),
    (RGB(goals=MyUniformGoals()), "strategy.goals", "MyUniformGoals"),
    (RGB(goals=shadowed(db.UniformGoals(), check=nothing)), "strategy.goals", "check"),
    (RGB(goals=db.NovelGoals()), "strategy.goals", "NovelGoals"),
    (RGB(goals=db.GridGoals(3)), "strategy.goals", "GridGoals"),
    (RGB(inverse=db.KNearest()), "strategy.inverse", "KNearest"),
    (RGB(inverse=MyNearest()), "strategy.inverse", "MyNearest"),
    (
        db.Adapt([RMB(), RGB(inverse=db.LocalRegression())]),
        "strategy.strategies[1].inverse",
        "LocalRegression",
    ),
    (db.QuasiRandomBabbling(), "strategy", "QuasiRandomBabbling"),
    (shadowed(RMB(), propose=half), "strategy", "propose"),
    (shadowed(RMB(), observe=nothing), "strategy", "observe"),
    (shadowed(RMB(), check=nothing), "strategy", "check"),
    (shadowed(db.Mixture([RMB(), RGB()]), choose=last), "strategy", "choose"),
    (db.Adapt([RMB(), shadowed(RGB(), propose=half)]), "strategy.strategies[1]", "propose"),
]

#: An environment; the part of it that stands in the way, and what it is.
ENVIRONMENTS = [
    (
        db.FunctionEnvironment(db.PlanarArm(3), db.PlanarArm(3).motor_space, WIDE),
        "environment",
        "FunctionEnvironment",
    ),
    (Mine(), "environment", "Mine"),
    (MyArm(3), "environment", "MyArm"),
    (spaced(motor_space=MyBox([-1] * 3, [1] * 3)), "environment.motor_space", "MyBox"),
    (spaced(sensory_space=WIDE), "environment.sensory_space", "MyBox"),
]


@pytest.mark.parametrize(("strategy", "part", "kind"), STRATEGIES, ids=str)
def test_rust_names_the_part_of_the_strategy(strategy, part, kind):
    assert_refused(part, kind, db.PlanarArm(3), strategy, np.random.default_rng(0))


@pytest.mark.parametrize(("environment", "part", "kind"), ENVIRONMENTS, ids=str)
def test_rust_names_the_environment(environment, part, kind):
    assert_refused(part, kind, environment, db.Adapt([RMB(), RGB()]), np.random.default_rng(0))


def test_rust_names_the_generator():
    rng = MyGenerator(np.random.PCG64(0))
    assert_refused("rng", "MyGenerator", db.PlanarArm(3), RMB(), rng)


@pytest.mark.parametrize(
    "environment",
    [
        spaced(motor_space=LIKE_A_BOX),
        spaced(sensory_space=LIKE_A_PLANE),
        spaced(sensory_space=None),
        spaced(motor_space=LIKE_A_BOX, sensory_space=None),
    ],
    ids=str,
)
@pytest.mark.parametrize(
    "strategy",
    [
        db.Adapt([RMB(), RGB(0.05, goals=WIDE_PLANE)]),
        db.Mixture(
            [RMB(), db.Adapt([RMB(), RGB(0.5, goals=WIDE_PLANE)], measure=db.Coverage(0.1))]
        ),
    ],
    ids=str,
)
def test_other_kinds_of_spaces_are_no_obstacle(environment, strategy):
    one, other = twins(np.random.PCG64)
    looped = db.explore(environment, strategy, N, rng=one, engine="python")
    assert not differences(looped, db.explore(environment, strategy, N, rng=other, engine="rust"))
    assert state(one) == state(other)


@pytest.mark.parametrize("engine", ["fast", "Rust", "", None, 1, True, ["rust"]])
def test_an_unknown_engine(engine):
    rng, plain = twins(np.random.PCG64)
    with pytest.raises((TypeError, ValueError), match=r"^engine must be .*got ") as caught:
        db.explore(db.PlanarArm(3), RMB(), N, rng=rng, engine=engine)
    assert not isinstance(engine, str) or all(name in str(caught.value) for name in ENGINES)
    assert state(rng) == state(plain)


@pytest.mark.parametrize(("strategy", "part", "kind"), STRATEGIES, ids=str)
def test_auto_runs_parts_that_are_python(strategy, part, kind):
    del part, kind
    assert_alike(db.PlanarArm(3), strategy)


@pytest.mark.parametrize(("environment", "part", "kind"), ENVIRONMENTS, ids=str)
def test_auto_runs_environments_that_are_python(environment, part, kind):
    del part, kind
    assert_alike(environment, db.Adapt([RMB(), RGB(0.05)]))


def assert_alike(environment, strategy):
    """Check that "auto" makes of it what "python" does."""
    rngs = twins(np.random.PCG64)
    runs = [
        db.explore(environment, strategy, N, rng=rng, engine=engine)
        for rng, engine in zip(rngs, ("auto", "python"), strict=True)
    ]
    assert differences(*runs) == []
    assert state(rngs[0]) == state(rngs[1])


def test_auto_is_the_default():
    rngs = twins(np.random.PCG64)
    strategy = shadowed(RMB(), propose=half)
    run = db.explore(db.PlanarArm(3), strategy, N, rng=rngs[0])
    assert differences(run, db.explore(db.PlanarArm(3), strategy, N, rng=rngs[1])) == []
    assert (run.commands == db.PlanarArm(3).limit / 2).all()


BUILT_IN = {
    RMB: (),
    RGB: (0.05,),
    db.Mixture: ([RMB(), RGB(0.05)],),
    db.Schedule: ([(5, RMB()), (None, RGB(0.05))],),
    db.Adapt: ([RMB(), RGB(0.05)],),
}


@pytest.mark.parametrize("nested", [False, True])
@pytest.mark.parametrize("method", ["propose", "observe", "choose"])
@pytest.mark.parametrize("kind", BUILT_IN, ids=lambda kind: kind.__name__)
def test_auto_calls_what_a_subclass_overrides(kind, method, nested):
    """Each call is made, in order, with what the Python loop gives."""
    if not hasattr(kind, method):
        assert kind in (RMB, RGB)
        return

    def recorded(self, first, second):
        seen.append((repr(first), str(second) if method == "observe" else repr(state(second))))
        return getattr(kind, method)(self, first, second)

    strategy = type("Recording", (kind,), {method: recorded})(*BUILT_IN[kind])
    if nested:
        strategy = db.Adapt([RMB(), db.Schedule([(None, strategy)])])
    calls = {}
    for engine in ("auto", "python"):
        seen = []
        run = db.explore(db.PlanarArm(3), strategy, N, rng=0, engine=engine)
        calls[engine] = seen
    assert len(seen) == ((run.choices == 1).sum() if nested else N)
    assert calls["auto"] == calls["python"]


@pytest.mark.parametrize("nested", [False, True])
def test_auto_calls_an_attribute_that_shadows_a_method(nested):
    seen, strategy = [], RMB()

    def propose(history, rng):
        seen.append(len(history))
        return history.motor_space.low + 0 * rng.random()

    strategy.propose = propose
    whole = db.Mixture([strategy, strategy]) if nested else strategy
    run = db.explore(db.PlanarArm(3), whole, N, rng=0, engine="auto")
    assert seen == list(range(N))
    assert (run.commands == -db.PlanarArm(3).limit).all()


def test_auto_draws_from_a_generator_that_is_a_subclass():
    class Counting(np.random.Generator):
        drawn = 0

        def random(self, *args, **names):
            self.drawn += 1
            return super().random(*args, **names)

    drawn = []
    for engine in ("auto", "python"):
        rng = Counting(np.random.PCG64(0))
        db.explore(db.PlanarArm(3), db.Adapt([RMB(), RGB(0.05)]), N, rng=rng, engine=engine)
        drawn.append(rng.drawn)
    assert drawn == [2 * N, 2 * N]


class Forbidden(Exception):  # noqa: N818 - it is no error
    """The Python loop was entered."""


@pytest.mark.parametrize(
    "strategy",
    [
        RMB(),
        RGB(0.05, goals=db.Box([0, 0], [1, 1])),
        db.Schedule([(5, RMB()), (None, db.Adapt([RMB(), db.Mixture([RMB(), RGB()])], tau=0.1))]),
        db.Adapt([RMB(), RGB()], measure=db.Coverage(0.1)),
    ],
    ids=str,
)
@pytest.mark.parametrize("rng", [None, 0, np.random.SeedSequence(1), np.random.default_rng(2)])
def test_auto_takes_rust_where_it_can(strategy, rng, monkeypatch):
    """Seen by that nobody asks an Explorer; the Python loop does."""

    def ask(_):
        raise Forbidden

    monkeypatch.setattr(db.Explorer, "ask", ask)
    with pytest.raises(Forbidden):
        db.explore(db.PlanarArm(3), strategy, N, rng=rng, engine="python")
    for engine in ("auto", "rust"):
        assert len(db.explore(db.PlanarArm(3), strategy, N, rng=rng, engine=engine)) == N
    with pytest.raises(Forbidden):
        db.explore(db.PlanarArm(3), db.Mixture([strategy, Corners()]), N, rng=rng, engine="auto")


def used_schedule():
    schedule = db.Schedule([(4, RMB()), (None, RGB(0.05))])
    schedule.choose(None, None)
    return schedule


def insides(strategy):
    """Return all that a strategy holds, in words, with that of its parts."""
    own = {name: repr(value) for name, value in vars(strategy).items() if name != "_windows"}
    windows = [window.mean() for window in getattr(strategy, "_windows", ())]
    return own, windows, [insides(part) for part in getattr(strategy, "strategies", ())]


@pytest.mark.parametrize(
    "strategy",
    [
        used_schedule(),
        db.Adapt([RMB(), used_schedule()], tau=0.2),
        db.Mixture([db.Adapt([RMB(), RGB()], measure=db.Coverage(0.1)), used_schedule()]),
    ],
    ids=str,
)
def test_the_strategy_given_is_never_changed(strategy):
    """One object explores again and again, with any engine, and always the same."""
    before, runs = insides(strategy), []
    for engine in (*ENGINES, *ENGINES):
        runs.append(db.explore(db.PlanarArm(3), strategy, N, rng=0, engine=engine))
        assert insides(strategy) == before
    assert [differences(run, runs[0]) for run in runs] == [[]] * 6
