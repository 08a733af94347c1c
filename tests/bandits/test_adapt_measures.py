"""Adapt by other measures than the discs' area: by hand and by replay."""

import math

import numpy as np
import pytest

import divbandit as db
from divbandit.bandits import Gain
from divbandit.measures import BallCoverage, Entropy, GridCoverage, Sparseness
from tests.bandits.script import Drive, both_engines
from tests.measures.every import Furthest
from tests.reference.adapt_replay import beliefs

ARM = db.PlanarArm(20)
RMB, RGB = db.MotorBabbling, db.GoalBabbling
MEASURES = (BallCoverage(0.05), GridCoverage(0.05), Sparseness(3), Entropy(0.2))


@both_engines
@pytest.mark.parametrize("measure", MEASURES, ids=repr)
def test_a_run_equals_its_replay_and_is_reproducible(measure, engine):
    adapt = db.Adapt([RMB(), RGB(0.05)], window=7, reward=Gain(measure), alpha=0.2)
    run, again = (db.explore(ARM, adapt, n=500, rng=5, engine=engine) for _ in range(2))
    expected = beliefs(adapt, run, measure.start(2))
    np.testing.assert_allclose(run.estimates, expected, rtol=1e-15, atol=1e-300)
    assert run.commands.tobytes() == again.commands.tobytes()
    assert run.estimates.tobytes() == again.estimates.tobytes()
    assert len(set(run.choices.tolist())) == 2


@both_engines
def test_the_default_is_coverage_with_the_papers_tau(engine):
    runs = [
        db.explore(ARM, db.Adapt([RMB(), RGB(0.05)], **by), n=400, rng=1, engine=engine)
        for by in ({}, {"tau": 0.02}, {"reward": Gain(BallCoverage(0.02))})
    ]
    assert len({run.commands.tobytes() for run in runs}) == 1
    assert len({run.estimates.tobytes() for run in runs}) == 1


def by_entropy(engine, *steps):
    """Return a Drive of three strategies by entropy, after steps (index, new)."""
    entropy = Gain(Entropy(1.0))
    run = Drive(engine, 3, reward=entropy, window=1, head_start=0, alpha=0.1)
    for index, new in steps:
        run.step(index, new=new)
    return run


#: The first strategy loses, the second gains.
NEGATIVE = ((1, True), (1, True), (0, False))


@both_engines
def test_a_negative_diversity_counts_as_zero(engine):
    run = by_entropy(engine, *NEGATIVE)
    first, second, third = run.estimates
    assert (first < 0, second, third) == (True, math.log(2), 0.0)
    for u in (0.0, 0.3, 0.7, 1 - 2**-53):
        assert run.choice(0.5, u) == 1


@both_engines
def test_a_negative_diversity_takes_nothing_from_the_others(engine):
    """Diversities log 2, log 3 - log 2 and less than 0: the first has log 2 / log 3 = 0.631."""
    run = by_entropy(engine, (0, True), (0, True), (1, True), (2, False))
    assert run.estimates[2] < 0
    assert [run.choice(0.5, u) for u in (0.0, 0.63, 0.64, 0.99)] == [0, 0, 1, 1]


@both_engines
def test_a_negative_diversity_is_chosen_at_random_all_the_same(engine):
    assert by_entropy(engine, *NEGATIVE).choice(0.05, 0.2) == 0


@both_engines
def test_where_none_is_above_zero_all_are_chosen_uniformly(engine):
    run = by_entropy(engine, *NEGATIVE, (1, False), (1, False))
    assert max(run.estimates) == 0.0
    assert min(run.estimates) < 0.0
    assert [run.choice(0.5, u) for u in (0.1, 0.5, 0.9)] == [0, 1, 2]


def test_a_measure_that_sets_itself_up_is_copied_by_each_exploration():
    template = Furthest()
    adapt = db.Adapt([RMB(), RGB(0.05)], reward=Gain(template))
    runs = [db.explore(ARM, adapt, n=50, rng=0) for _ in range(3)]
    assert len({run.estimates.tobytes() for run in runs}) == 1
    np.testing.assert_allclose(
        runs[0].estimates, beliefs(adapt, runs[0], Furthest().start(2)), rtol=1e-15
    )
    assert not hasattr(template, "dim")


@pytest.mark.parametrize("bad", [math.nan, math.inf, -math.inf])
def test_gains_that_are_not_finite_are_refused(bad):
    class Bad(Furthest):
        def gain(self, effect):
            del effect
            return bad

    explorer = db.Explorer(db.Adapt([RMB()], reward=Gain(Bad())), db.Box([0], [1]), rng=0)
    trial = explorer.ask()
    with pytest.raises(ValueError, match="measure must give finite gains, got"):
        explorer.tell(trial, [0.0, 0.0])
    assert explorer.estimates == (0.0,)


RMB = db.MotorBabbling


def cube(dim, *, known):
    space = db.Box([0] * dim, [1] * dim)
    return db.FunctionEnvironment(lambda x: x, space, space if known else None)


@both_engines
@pytest.mark.parametrize("known", [True, False], ids=["known", "unknown"])
@pytest.mark.parametrize("dim", [1, 3, 5])
def test_effects_of_any_dimension(dim, known, engine):
    grid = GridCoverage(0.25)
    adapt = db.Adapt([RMB(), RMB()], reward=Gain(grid))
    run = db.explore(cube(dim, known=known), adapt, n=60, rng=0, engine=engine)
    assert np.array_equal(run.estimates, beliefs(adapt, run, grid.start(dim)))


@both_engines
@pytest.mark.parametrize("known", [True, False], ids=["known", "unknown"])
def test_a_measure_says_which_dimensions_it_takes(known, engine):
    adapt = db.Adapt([RMB()], reward=Gain(Entropy([0.25, 0.5])))
    with pytest.raises(ValueError, match=r"of a dimension that Adapt takes, got 3: .*cell"):
        db.explore(cube(3, known=known), adapt, n=1, rng=0, engine=engine)


@both_engines
@pytest.mark.parametrize("dim", [1, 2, 3, 4, 9])
def test_the_default_measures_in_whatever_dimension_coverage_takes(dim, engine):
    adapt = db.Adapt([RMB(), RMB()], tau=0.3, window=5)
    run = db.explore(cube(dim, known=True), adapt, n=60, rng=0, engine=engine)
    expected = beliefs(adapt, run, BallCoverage(0.3).start(dim))
    np.testing.assert_allclose(run.estimates, expected, rtol=1e-14)
    # Until the first effect tells the dimension, a disc stands for a ball.
    other = db.explore(cube(dim, known=False), adapt, n=60, rng=0, engine=engine)
    assert other.commands.tobytes() == run.commands.tobytes()
    assert other.estimates[0].tolist() == [math.pi * 0.3 * 0.3] * 2
    assert other.estimates[1:].tobytes() == run.estimates[1:].tobytes()


@both_engines
@pytest.mark.parametrize("known", [True, False], ids=["known", "unknown"])
def test_the_default_says_which_dimensions_it_takes(known, engine):
    message = "effects must be of a dimension that Adapt takes, got 40: dim must be from 1 to 32"
    with pytest.raises(ValueError, match=message):
        db.explore(cube(40, known=known), db.Adapt([RMB()]), n=1, rng=0, engine=engine)
