"""Which engine runs what: "rust" names what stands in its way, "auto" honours what is Python."""

import copy
import re
from types import SimpleNamespace

import numpy as np
import pytest

import divbandit as db
from tests.exploration.sameness import differences
from tests.generators import state, twins

ENGINES = ("auto", "python", "rust")
RMB, RGB = db.MotorBabbling, db.GoalBabbling
N = 60


class Corners(db.Strategy):
    def propose(self, history, rng):
        space = history.motor_space
        return np.where(rng.random(space.dim) < 0.5, space.low, space.high)


class InTurn(db.Composite):
    def choose(self, history, rng):
        del rng
        return len(history) % len(self.strategies)


class Mine:
    """An environment that is the arm, but not of its class."""

    def __init__(self):
        self.arm = db.PlanarArm(3)
        self.motor_space, self.sensory_space = self.arm.motor_space, self.arm.sensory_space

    def __call__(self, command):
        return self.arm(command)


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


class MyBox(db.Box):
    def sample(self, rng):
        return (self.low + self.high) / 2 + 0 * rng.random()


class MyArm(db.PlanarArm):
    def __call__(self, command):
        return super().__call__(command) / 2


class MyGenerator(np.random.Generator):
    pass


def spaced(**spaces):
    """Return an arm with other spaces."""
    arm = db.PlanarArm(3)
    for name, space in spaces.items():
        setattr(arm, name, space)
    return arm


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

PART = r"(?:strategy|environment)(?:\.strategies\[\d+\]|\.\w+)*|\brng\b"


def assert_refused(part, kind, environment, strategy, rng):
    """Check that the Rust engine names `part` and what it is, and draws nothing."""
    before = state(rng)
    with pytest.raises(ValueError, match=re.escape(kind)) as caught:
        db.explore(environment, strategy, N, rng=rng, engine="rust")
    message = str(caught.value)
    # The longest, and a method in the way may be a part of it.
    assert max(re.findall(PART, message), key=len) in (part, f"{part}.{kind}")
    assert "rust" in message
    assert state(rng) == before


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


def outcome(environment, strategy, n, rng, engine):
    """Return the type and the text of the error that it must raise."""
    with pytest.raises(Exception, match=r"must|cannot") as caught:
        db.explore(environment, strategy, n, rng=rng, engine=engine)
    return type(caught.value), str(caught.value)


LINE, PLANE, SPACE = (db.Box([-1] * dim, [1] * dim) for dim in (1, 2, 3))
MANY = db.Box([-1] * 33, [1] * 33)
ADAPT = db.Adapt([RMB(), RGB(0.05)])

#: What is refused before the first step: changes of what `explore` is given.
REFUSED = {
    "n = 0": {"n": 0},
    "n < 0": {"n": -1},
    "n a float": {"n": 2.0},
    "n a bool": {"n": True},
    "n a text": {"n": "2"},
    "n nothing": {"n": None},
    "no environment": {"environment": lambda command: command},
    "a class of environments": {"environment": Mine},
    "no strategy": {"strategy": None},
    "a class of strategies": {"strategy": RMB},
    "no motor space": {"environment": spaced(motor_space=3)},
    "no sensory space": {"environment": spaced(sensory_space=[[-1, -1], [1, 1]])},
    "goals from nowhere": {"environment": spaced(sensory_space=None)},
    "goals on a line": {"strategy": RGB(0.05, goals=LINE)},
    "goals in space": {"strategy": db.Mixture([RMB(), db.Adapt([RGB(0.05, goals=SPACE)])])},
    "a measure of space": {"strategy": db.Adapt([RMB()], measure=db.Coverage(0.1, dim=3))},
    "a measure of lines": {
        "strategy": db.Mixture([db.Adapt([RMB()], measure=db.Coverage(0.1, dim=1))])
    },
    "effects of 33 dimensions": {"environment": spaced(sensory_space=MANY)},
    "two mistakes": {"strategy": RGB(0.05, goals=LINE), "n": 0},
    "two others": {"environment": spaced(sensory_space=None), "n": None},
}


@pytest.mark.parametrize("what", REFUSED)
def test_what_is_refused_is_the_same_for_all_engines(what):
    given = {"environment": db.PlanarArm(3), "strategy": ADAPT, "n": N, **REFUSED[what]}
    outcomes = set()
    for engine in ENGINES:
        rng, plain = twins(np.random.PCG64)
        outcomes.add(outcome(**given, rng=rng, engine=engine))
        assert state(rng) == state(plain)
    assert len(outcomes) == 1


@pytest.mark.parametrize("rng", [-1, np.int64(-7), True, "0", 0.5, [1], np.random.PCG64(0)])
@pytest.mark.parametrize("n", [N, 0])
def test_a_bad_seed_is_the_same_for_all_engines(rng, n):
    found = {outcome(db.PlanarArm(3), ADAPT, n, rng, engine) for engine in ENGINES}
    assert len(found) == 1
    assert found.pop()[1].startswith("rng must be")


#: What goes wrong on the way in both: an environment, a strategy and what the error says.
ON_THE_WAY = {
    "wider than the arm's limit": (
        spaced(motor_space=db.Box([-1, -1, -2.7], [1, 1, 1])),
        ADAPT,
        r"^command\[2\] must be within the joint's limit .*got -2\.6",
    ),
    "wider by a little": (
        spaced(motor_space=db.Box([-2.62, -1, -1], [1, 1, 1])),
        db.Mixture([RMB(), RGB(0.5)]),
        r"^command\[0\] must be within the joint's limit .*got -2\.6",
    ),
}

MOTOR, SENSORY = "environment.motor_space", "environment.sensory_space"

#: The same where the Rust engine does not begin at all: what stands in its way comes last.
NOT_IN_RUST = {
    "fewer angles than joints": (spaced(motor_space=PLANE), RMB(), "must have shape", MOTOR),
    "more angles than joints": (spaced(motor_space=MANY), RMB(), "must have shape", MOTOR),
    "effects said to be on a line": (
        spaced(sensory_space=LINE),
        ADAPT,
        "effect must have shape",
        SENSORY,
    ),
    "effects said to be in space": (
        spaced(sensory_space=SPACE),
        ADAPT,
        "effect must have shape",
        SENSORY,
    ),
    "goals, then effects, of other dimensions": (
        spaced(sensory_space=None),
        db.Schedule([(5, RMB()), (None, RGB(0.05, goals=SPACE))]),
        "goals must have the dimension of the effects, 2, got 3",
        SENSORY,
    ),
    "a measure of another dimension": (
        spaced(sensory_space=None),
        db.Schedule([(5, RMB()), (None, db.Adapt([RMB()], measure=db.Coverage(0.1, dim=3)))]),
        "measure must have the dimension of the effects, 2, got 3",
        SENSORY,
    ),
}


def failure(environment, strategy, engine):
    """Return the error of an exploration that fails after some draws, and the generator's state."""
    rng, plain = twins(np.random.PCG64)
    found = outcome(environment, strategy, 3000, rng, engine)
    assert state(rng) != state(plain)
    return found, state(rng)


@pytest.mark.parametrize("what", ON_THE_WAY)
def test_what_goes_wrong_on_the_way_is_the_same_for_all_engines(what):
    """Also where: the generators end in the same state."""
    environment, strategy, text = ON_THE_WAY[what]
    expected = failure(environment, strategy, "python")
    assert re.search(text, expected[0][1])
    assert failure(environment, strategy, "auto") == expected
    assert failure(environment, strategy, "rust") == expected


@pytest.mark.parametrize("what", NOT_IN_RUST)
def test_what_goes_wrong_in_python_alone(what):
    environment, strategy, text, part = NOT_IN_RUST[what]
    expected = failure(environment, strategy, "python")
    assert re.search(text, expected[0][1])
    assert failure(environment, strategy, "auto") == expected
    space = getattr(environment, part.removeprefix("environment."))
    assert_refused(part, type(space).__name__, environment, strategy, np.random.default_rng(0))


@pytest.mark.parametrize(
    ("strategy", "change"),
    [
        (RGB(0.05), {"d": 7.0}),
        (db.Mixture([RGB(0.05), RMB()]), {"weights": (0.0, 0.0, 1.0)}),
        (db.Mixture([RGB(0.05), RMB()]), {"weights": (-1.0, 2.0)}),
        (db.Mixture([RGB(0.05), RMB()]), {"weights": [2, 1]}),
        (db.Mixture([RGB(0.05), RMB()]), {"strategies": [RMB()]}),
        (db.Schedule([(3, RMB()), (None, RGB())]), {"steps": [0, 0]}),
        (db.Schedule([(3, RMB()), (None, RGB())]), {"steps": (2.5, None)}),
        (db.Mixture([RGB(0.05), RMB()]), {"weights": [0, 0]}),
        (db.Mixture([RGB(0.05), RMB()]), {"weights": [0.5, float("nan")]}),
        (db.Schedule([(3, RMB()), (None, RGB())]), {"steps": (None, None)}),
        (db.Schedule([(3, RMB()), (None, RGB())]), {"steps": (-3, None)}),
        (db.Adapt([RMB(), RGB(0.05)]), {"alpha": 7}),
        (db.Adapt([RMB(), RGB(0.05)]), {"alpha": float("nan")}),
        (db.Adapt([RMB(), RGB(0.05)]), {"window": 2_000_000}),
        (db.Adapt([RMB(), RGB(0.05)]), {"window": 0}),
        (db.Adapt([RMB(), RGB(0.05)]), {"head_start": -1}),
        (db.Adapt([RMB(), RGB(0.05)]), {"window": 1, "head_start": 3}),
        (db.Adapt([RMB(), RGB(0.05)]), {"measure": db.Coverage(0.3)}),
    ],
    ids=str,
)
@pytest.mark.parametrize("nested", [False, True])
def test_attributes_set_by_hand_do_no_silent_harm(strategy, change, nested):
    """Whether they make sense or not: what "auto" makes of them is what Python does."""
    strategy = copy.copy(strategy)
    for name, value in change.items():
        setattr(strategy, name, value)
    whole = db.Mixture([RMB(), strategy]) if nested else strategy
    (run, end), (expected, python_end) = (made(whole, engine) for engine in ("auto", "python"))
    if isinstance(run, db.Exploration):
        assert isinstance(expected, db.Exploration)
        assert differences(run, expected) == []
    else:
        assert run == expected
    assert end == python_end


def test_rust_says_what_was_set_by_hand():
    goals = RGB(0.05)
    goals.d = 7.0
    with pytest.raises(ValueError, match=r'"rust".*strategy\.strategies\[1\].*d must be .*7\.0'):
        db.explore(db.PlanarArm(3), db.Mixture([RMB(), goals]), N, rng=0, engine="rust")


def made(strategy, engine):
    """Return an exploration, or its error in words, and the generator's state."""
    rng = np.random.default_rng(0)
    try:
        run = db.explore(db.PlanarArm(3), strategy, N, rng=rng, engine=engine)
    except (TypeError, ValueError) as error:
        run = repr(error)
    return run, state(rng)


def test_what_an_environment_raises_is_passed_on():
    class Broken(Mine):
        def __call__(self, command):
            raise OSError(f"no connection: {len(command)}")

    for engine in ("auto", "python"):
        with pytest.raises(OSError, match="no connection: 3"):
            db.explore(Broken(), RMB(), N, rng=0, engine=engine)
