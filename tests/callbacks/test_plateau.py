"""Plateau: when it stops, held against a plain sum, and by which measure."""

import numpy as np
import pytest

import divbandit as db
from divbandit.bandits import CompetenceProgress, Gain
from divbandit.callbacks import Every, Plateau
from divbandit.callbacks.diversity import measure_for
from divbandit.measures import BallCoverage, Entropy, GridCoverage
from tests.callbacks.scripts import UNIT, Total, explorer, scripted

RMB = db.MotorBabbling()


def specified(gains, trials, share):
    """Return after how many evaluations it is to stop, None for a failure; all if it never is."""
    gained = [gain or 0.0 for gain in gains]
    for made in range(trials, len(gains) + 1):
        added = sum(gained[made - trials : made])
        if added <= 0 or added < share * sum(gained[:made]):
            return made
    return len(gains)


def made(gains, plateau, one=None):
    """Return after how many evaluations it stops."""
    one = one or explorer()
    one.run(scripted(gains), len(gains), on_error="record", callbacks=[plateau])
    return len(one.history) + len(one.history.failures)


@pytest.mark.parametrize("seed", range(40))
def test_it_stops_where_the_specification_says(seed):
    rng = np.random.default_rng(seed)
    # Whole numbers of 32nds: their sums are exact in any order.
    gains = [round(32 * rng.random() / k) / 32 for k in range(1, 80)]
    gains = [None if rng.random() < 0.2 else gain for gain in gains]
    trials, share = int(rng.integers(1, 20)), float(rng.choice([0.0, 0.125, 0.25, 0.5]))
    expected = specified(gains, trials, share)
    assert made(gains, Plateau(trials, share, measure=Total())) == expected


def test_by_hand():
    plateau = Plateau(3, 0.5, measure=Total())
    # After five, the last three added 4 of 6; after six 3 of 7, or 3 of 6, which is not less.
    assert made([1, 1, 2, 1, 1, 1, 9], plateau) == 6
    assert made([1, 1, 1, 2, 1, 0, 9], plateau) == 7


def test_nothing_but_failures_is_a_plateau():
    plateau, one = Plateau(5, 0, measure=Total()), explorer()
    with pytest.raises(RuntimeError, match="all 5 evaluations failed"):
        made([None] * 9, plateau, one)
    assert made([1] + [None] * 9, plateau) == 6


def test_a_share_of_zero_waits_until_nothing_is_added():
    gains = [1, 0.001, 0, 0, 0, 1]
    assert made(gains, Plateau(3, 0, measure=Total())) == 5
    assert made(gains, Plateau(3, 0.01, measure=Total())) == 4


def test_a_second_run_makes_its_own_trials_and_knows_what_was_reached():
    one, plateau = explorer(), Plateau(3, 0.5, measure=Total())
    assert made([1] * 9, plateau, one) == 7  # 3 of 7
    assert made([1] * 9, plateau, one) == 10  # 3 of 10, and not before 3 of its own


def test_every_effect_is_measured_once():
    effects = []

    class Noting(Total):
        def extend(self, new):
            effects.extend(float(effect[0]) for effect in new)
            return super().extend(new)

    one = explorer()
    one.add_past(np.full((5, 1), 0.5), np.full((5, 1), 0.25))
    one.run(scripted(range(1, 8)), 7, callbacks=[Plateau(50, 0.5, measure=Noting())])
    assert effects == [0.25] * 5 + [1, 2, 3, 4, 5, 6, 7]


def test_it_looks_every_hundredth_part():
    assert [Plateau(trials, 0.1).every for trials in (1, 199, 200, 1000)] == [1, 1, 2, 10]
    gains = [1] * 100 + [0] * 1000
    assert made(gains, Plateau(500, 0, measure=Total())) == 600
    assert made([1, 1, *gains], Plateau(500, 0, measure=Total())) == 605
    assert made([1, 1, *gains], Every(100, Plateau(500, 0, measure=Total()))) == 700


def test_what_it_remembers_is_bounded():
    running = Plateau(1000, 0, measure=Total()).start(explorer(), None)
    one = explorer()
    for _ in range(3000):
        one.tell(one.ask(), [1])
        running(one, None)
    assert len(running._looks) <= 1001  # noqa: SLF001 - all that it remembers


ADAPT = db.Adapt([RMB], reward=Gain(Entropy(0.5)))
PROGRESS = db.Adapt([RMB], reward=CompetenceProgress())


@pytest.mark.parametrize(
    ("strategy", "measure"),
    [
        (db.Adapt([RMB], tau=0.25), BallCoverage(0.25)),
        (ADAPT, Entropy(0.5)),
        (db.Mixture([RMB, db.Mixture([ADAPT, ADAPT])]), Entropy(0.5)),
        (db.Adapt([ADAPT], tau=0.25), BallCoverage(0.25)),
        (db.Adapt([RMB, ADAPT], reward=CompetenceProgress()), Entropy(0.5)),
        (db.default_strategy(0.125), BallCoverage(0.125, accuracy=0.05)),
    ],
)
@pytest.mark.parametrize("engine", ["auto", "python"])
def test_by_default_it_measures_what_the_bandit_is_rewarded_by(strategy, measure, engine):
    one = db.Explorer(strategy, UNIT, UNIT, rng=0, engine=engine)
    assert measure_for(None, None, one) == measure


@pytest.mark.parametrize(
    "strategy", [RMB, PROGRESS, db.Mixture([ADAPT, db.Adapt([RMB], tau=0.25)])]
)
def test_without_a_measure_the_run_does_not_begin(strategy):
    one = explorer(strategy)
    message = "measure must be given to Plateau, or tau, where the strategy is not a bandit"
    with pytest.raises(ValueError, match=message):
        one.run(scripted([1]), 1, callbacks=[Plateau(3, 0.1)])
    assert len(one.history) == 0
    assert one.run(scripted([1]), 1, callbacks=[Plateau(3, 0.1, tau=0.5)])


def test_a_measure_of_another_dimension_is_refused_when_the_run_begins():
    arm = db.PlanarArm(2)
    plateau = Plateau(3, 0.1, measure=GridCoverage([1, 1, 1]))
    with pytest.raises(ValueError, match="cell must have length 2, got 3"):
        db.explore(arm, RMB, 5, callbacks=[plateau])


def test_an_arm_that_reaches_all_it_can():
    arm, plateau = db.PlanarArm(2), Plateau(300, 0.05)
    few = db.explore(
        arm, db.Adapt([RMB, db.GoalBabbling()], tau=0.2), 5000, rng=0, callbacks=[plateau]
    )
    reached = few.coverage(0.2)
    assert 300 <= len(few) < 5000
    assert reached[-1] - reached[-301] < 0.05 * reached[-1]
    assert reached[-2] - reached[-302] >= 0.05 * reached[-2] or len(few) == 300


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        ({"trials": 0}, "trials must be at least 1, got 0"),
        ({"trials": 2.5}, "trials must be a whole number, got float"),
        ({"share": 1.5}, r"share must be a finite number in \[0.0, 1.0\], got 1.5"),
        ({"share": "1%"}, "share must be a number, got str"),
        ({"tau": 0}, "tau"),
        ({"measure": 5}, r"measure must be a Measure, such as BallCoverage\(0.02\), got int"),
        ({"tau": 0.5, "measure": Total()}, "tau must not be given together with a measure"),
    ],
)
def test_bad_arguments_are_refused(arguments, message):
    with pytest.raises((TypeError, ValueError), match=message):
        Plateau(**{"trials": 3, "share": 0.1} | arguments)
