"""What is refused, or goes wrong on the way, is the same whichever engine makes the steps."""

import numpy as np
import pytest

import divbandit as db
from divbandit.bandits import Gain
from divbandit.measures import GridCoverage
from tests.exploration.refusals import ARM, ENGINES, Mine, N
from tests.exploration.sameness import everything
from tests.generators import state, twins

RMB, RGB = db.MotorBabbling(), db.GoalBabbling(0.05)


def outcome(environment, strategy, n, rng, engine):
    """Return the type and the text of the error that it must raise."""
    with pytest.raises(Exception, match=r"must|cannot") as caught:
        db.explore(environment, strategy, n, rng=rng, engine=engine)
    return type(caught.value), str(caught.value)


LINE, PLANE, SPACE = (db.Box([-1] * dim, [1] * dim) for dim in (1, 2, 3))
MANY = db.Box([-1] * 33, [1] * 33)
ADAPT = db.Adapt([RMB, RGB])

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
    "a class of strategies": {"strategy": db.MotorBabbling},
    "no motor space": {"environment": Mine(motor_space=3)},
    "no sensory space": {"environment": Mine(sensory_space=[[-1, -1], [1, 1]])},
    "goals from nowhere": {"environment": Mine(sensory_space=None)},
    "goals on a line": {"strategy": db.GoalBabbling(0.05, goals=LINE)},
    "goals in space": {"strategy": db.Mixture([RMB, db.Adapt([db.GoalBabbling(goals=SPACE)])])},
    "a grid of space": {"strategy": db.Adapt([RMB], reward=Gain(GridCoverage([1, 1, 1])))},
    "effects of 33 dimensions": {"environment": Mine(sensory_space=MANY)},
    "two mistakes": {"strategy": db.GoalBabbling(0.05, goals=LINE), "n": 0},
    "two others": {"environment": Mine(sensory_space=None), "n": None},
}


@pytest.mark.parametrize("what", REFUSED)
def test_what_is_refused_is_the_same_for_all_engines(what):
    given = {"environment": ARM, "strategy": ADAPT, "n": N, **REFUSED[what]}
    outcomes = set()
    for engine in ENGINES:
        rng, plain = twins(np.random.PCG64)
        outcomes.add(outcome(**given, rng=rng, engine=engine))
        assert state(rng) == state(plain)
    assert len(outcomes) == 1


@pytest.mark.parametrize("rng", [-1, np.int64(-7), True, "0", 0.5, [1], np.random.PCG64(0)])
@pytest.mark.parametrize("n", [N, 0])
def test_a_bad_seed_is_the_same_for_all_engines(rng, n):
    found = {outcome(ARM, ADAPT, n, rng, engine) for engine in ENGINES}
    assert len(found) == 1
    assert found.pop()[1].startswith("rng must be")


class Failing(Mine):
    """The arm, whose effect is `bad` from the step after `steps` on."""

    def __init__(self, steps, bad, **spaces):
        super().__init__(**spaces)
        self.steps, self.bad, self.calls = steps, bad, 0

    def __call__(self, command):
        self.calls += 1
        return super().__call__(command) if self.calls <= self.steps else self.bad


LATER = {
    "goals": db.Schedule([(5, RMB), (None, db.GoalBabbling(0.05, goals=SPACE))]),
    "a grid": db.Schedule([(5, RMB), (None, db.Adapt([RMB], reward=Gain(GridCoverage([1] * 3))))]),
}

#: What goes wrong on the way: an environment, a strategy, and what the error says.
ON_THE_WAY = {
    "wider than the arm's limit": (
        lambda: Mine(motor_space=db.Box([-1, -1, -2.7], [1, 1, 1])),
        ADAPT,
        r"^command\[2\] must be within the joint's limit .*got -2\.6",
    ),
    "fewer angles than joints": (lambda: Mine(motor_space=PLANE), RMB, "must have shape"),
    "more angles than joints": (lambda: Mine(motor_space=MANY), RMB, "must have shape"),
    "effects said to be on a line": (
        lambda: Mine(sensory_space=LINE),
        ADAPT,
        "effect must have shape",
    ),
    "goals, then effects, of other dimensions": (
        lambda: Mine(sensory_space=None),
        LATER["goals"],
        "goals.* must have the dimension of the effects, 2, got 3",
    ),
    "a grid of another dimension": (
        lambda: Mine(sensory_space=None),
        LATER["a grid"],
        "effects must be of a dimension that Adapt takes, got 2",
    ),
    "an infinite effect": (lambda: Failing(20, [0, np.inf]), ADAPT, r"effect\[1\] must be finite"),
    "a long effect": (lambda: Failing(20, [0, 1, 2]), ADAPT, r"effect must have shape \(2,\)"),
    "no effect": (lambda: Failing(20, None), ADAPT, "effect must be"),
    "text as effect": (lambda: Failing(20, "ab"), ADAPT, "effect must be"),
    "a row of effects": (lambda: Failing(7, [[0, 0]]), ADAPT, "effect must have shape"),
    "an effect beyond any cell": (
        lambda: Failing(20, [0, 1e300]),
        db.Adapt([RMB, RGB], reward=Gain(GridCoverage(1e-9))),
        "effect",
    ),
}


@pytest.mark.parametrize("what", ON_THE_WAY)
def test_what_goes_wrong_on_the_way_is_the_same_for_all_engines(what, tmp_path):
    """Also where: the generators end in the same state, and the explorers hold the same."""
    make, strategy, text = ON_THE_WAY[what]
    found = []
    for engine in ENGINES:
        rng = np.random.default_rng(0)
        with pytest.raises((TypeError, ValueError), match=text) as caught:
            db.explore(make(), strategy, 3000, rng=rng, engine=engine)
        explorer = caught.value.explorer
        assert len(explorer.open_trials) <= 1
        explorer.save(tmp_path / "run")
        again = db.Explorer.load(tmp_path / "run")
        assert everything(again) == everything(explorer)
        found.append((type(caught.value), str(caught.value), everything(explorer)))
    assert found[1:] == found[:1] * 2
