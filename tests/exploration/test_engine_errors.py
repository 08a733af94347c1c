"""What is refused, or goes wrong on the way, is the same whichever engine makes the steps."""

import copy
import re

import numpy as np
import pytest

import divbandit as db
from tests.exploration.refusals import ENGINES, Mine, N, assert_refused, spaced
from tests.exploration.sameness import differences
from tests.generators import state, twins

RMB, RGB = db.MotorBabbling, db.GoalBabbling


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
