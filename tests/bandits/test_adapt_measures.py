"""Adapt by other measures than the discs' area: by hand and by replay."""

import copy
import math
import pickle

import numpy as np
import pytest

import divbandit as db
from tests.bandits.beliefs import replay
from tests.bandits.script import Always, Drive, Scripted, towards

ARM = db.PlanarArm(20)
RMB, RGB = db.MotorBabbling, db.GoalBabbling
MEASURES = {
    "coverage": lambda: db.Coverage(0.05),
    "grid": lambda: db.GridCoverage(0.05),
    "sparseness": lambda: db.Sparseness(3),
    "entropy": lambda: db.Entropy(0.2),
}


@pytest.mark.parametrize("name", MEASURES)
def test_a_run_equals_its_replay_and_is_reproducible(name):
    head_start = {"coverage": math.pi * 0.05 * 0.05, "grid": 1.0, "entropy": math.log(2)}
    adapt = db.Adapt([RMB(), RGB(0.05)], window=7, measure=MEASURES[name](), alpha=0.2)
    run, again = (db.explore(ARM, adapt, n=500, rng=5) for _ in range(2))
    expected = replay(adapt, run, head_start.get(name, 0.0), MEASURES[name]())
    np.testing.assert_allclose(run.diversities, expected, rtol=1e-15, atol=1e-300)
    assert run.commands.tobytes() == again.commands.tobytes()
    assert run.diversities.tobytes() == again.diversities.tobytes()
    assert len(set(run.choices.tolist())) == 2
    assert len(adapt.measure) == 0


def test_the_default_is_coverage_with_the_papers_tau():
    runs = [
        db.explore(ARM, db.Adapt([RMB(), RGB(0.05)], **by), n=400, rng=1)
        for by in ({}, {"tau": 0.02}, {"measure": db.Coverage(0.02)})
    ]
    assert len({run.commands.tobytes() for run in runs}) == 1
    assert len({run.diversities.tobytes() for run in runs}) == 1


def test_windows_by_hand():
    run = Drive(measure=db.GridCoverage(1.0), window=3, alpha=0.5)
    assert run.adapt.diversities == (1.0, 1.0)
    assert run.step(0, new=True) == (1.0, 1.0)
    assert run.step(0, new=False) == (2 / 3, 1.0)
    assert run.step(1, new=False) == (2 / 3, 0.5)
    assert run.step(1, new=True) == (2 / 3, 2 / 3)


def test_two_head_starts():
    adapt = db.Adapt([RMB()], measure=db.GridCoverage(1.0), head_start=2, window=2)
    assert adapt.diversities == (1.0,)
    run = Drive(1, measure=db.GridCoverage(1.0), head_start=2, window=3, alpha=1)
    run.step(0, new=True)
    assert run.step(0, new=False) == (2 / 3,)


def negative(alpha):
    """Return a Drive by entropy whose first strategy lost and whose second gained."""
    run = Drive(3, measure=db.Entropy(1.0), window=1, head_start=0, alpha=1.0)
    run.step(1, new=True)
    run.step(1, new=True)
    run.step(0, new=False)
    run.adapt.alpha = alpha
    return run


def test_a_negative_diversity_counts_as_zero():
    run = negative(0.0)
    first, second, third = run.adapt.diversities
    assert (first < 0, second, third) == (True, math.log(2), 0.0)
    for u in (0.0, 0.3, 0.7, 1 - 2**-53):
        assert run.adapt.choose(run.history, Scripted(0.5, u)) == 1


def test_a_negative_diversity_takes_nothing_from_the_others():
    """Diversities log 2, log 3 - log 2 and less than 0: the first has log 2 / log 3 = 0.631."""
    run = Drive(3, measure=db.Entropy(1.0), window=1, head_start=0, alpha=1.0)
    for index, new in ((0, True), (0, True), (1, True), (2, False)):
        run.step(index, new=new)
    run.adapt.alpha = 0.0
    assert run.adapt.diversities[2] < 0
    chosen = [run.adapt.choose(run.history, Scripted(0.5, u)) for u in (0.0, 0.63, 0.64, 0.99)]
    assert chosen == [0, 0, 1, 1]


def test_a_negative_diversity_is_chosen_at_random_all_the_same():
    run = negative(0.1)
    assert run.adapt.choose(run.history, Scripted(0.05, 0.2)) == 0


def test_where_none_is_above_zero_all_are_chosen_uniformly():
    run = negative(1.0)
    run.step(1, new=False)
    run.step(1, new=False)
    run.adapt.alpha = 0.0
    assert max(run.adapt.diversities) == 0.0
    assert min(run.adapt.diversities) < 0.0
    chosen = [run.adapt.choose(run.history, Scripted(0.5, u)) for u in (0.1, 0.5, 0.9)]
    assert chosen == [0, 1, 2]


def test_the_measure_given_is_a_template():
    template = db.GridCoverage(0.05)
    adapt = db.Adapt([RMB(), RGB(0.05)], measure=template)
    first = db.explore(ARM, adapt, n=200, rng=0).diversities.tobytes()
    assert len(template) == len(adapt.measure) == 0
    template.add([0.0, 0.0])  # too late to matter
    assert db.explore(ARM, adapt, n=200, rng=0).diversities.tobytes() == first
    with pytest.raises(ValueError, match="measure must be empty, got one that holds 1 effects"):
        db.Adapt([RMB()], measure=template)


def test_a_plain_class_without_any_copying_of_its_own_is_not_shared():
    class Count:
        dim, largest_gain, measure = 2, 1.0, 0.0

        def __init__(self):
            self.effects = []

        def __len__(self):
            return len(self.effects)

        def gain(self, effect):
            return 1.0 / (1 + len(self.effects)) + 0.0 * effect[0]

        def add(self, effect):
            gain = self.gain(effect)
            self.effects.append(effect)
            self.measure += gain
            return gain

        def extend(self, effects):
            return np.array([self.add(effect) for effect in effects])

    template = Count()
    adapt = db.Adapt([RMB(), RGB(0.05)], measure=template)
    runs = {db.explore(ARM, adapt, n=50, rng=0).diversities.tobytes() for _ in range(3)}
    assert len(runs) == 1
    assert template.effects == []


@pytest.mark.parametrize("bad", [math.nan, math.inf, -math.inf])
def test_gains_that_are_not_finite_are_refused(bad):
    class Bad(db.GridCoverage):
        def add(self, effect):
            super().add(effect)
            return bad

    adapt = db.Adapt([Always()], measure=Bad(1.0))
    explorer = db.Explorer(adapt, db.Box([0], [1]), rng=0)
    trial = explorer.ask()
    with pytest.raises(ValueError, match="measure must give finite gains, got"):
        explorer.tell(trial, [0.0, 0.0])
    assert explorer.strategy.diversities == (1.0,)


@pytest.mark.parametrize("way", [copy.deepcopy, lambda x: pickle.loads(pickle.dumps(x))])  # noqa: S301
@pytest.mark.parametrize("name", MEASURES)
def test_a_copy_made_half_way_goes_on_alike(name, way):
    adapt = db.Adapt([RMB(), RGB(0.05)], window=7, measure=MEASURES[name](), alpha=0.2)
    explorer = db.Explorer(adapt, ARM.motor_space, ARM.sensory_space, rng=0)

    def go_on(explorer, steps):
        for _ in range(steps):
            trial = explorer.ask()
            explorer.tell(trial, ARM(trial.command))
        return explorer.result().diversities.tobytes()

    go_on(explorer, 60)
    other = way(explorer)
    assert go_on(other, 60) == go_on(explorer, 60)


def test_what_was_measured_is_left_out_of_pickles():
    run = Drive(measure=db.Sparseness())
    empty = len(pickle.dumps(run.adapt.__getstate__()["measure"]))
    for _ in range(100):
        run.step(0, new=True)
    state = run.adapt.__getstate__()
    assert state["_credit"].__getstate__()["_measured"] is None
    assert len(pickle.dumps(state["measure"])) == empty


def test_is_shown_with_its_measure():
    adapt = db.Adapt([RMB()], measure=db.GridCoverage(0.5))
    assert repr(adapt) == (
        "Adapt([MotorBabbling()], measure=<GridCoverage of 0 effects, cell=(0.5, 0.5), "
        "measure=0.0>, window=50, alpha=0.1, head_start=1)"
    )
    assert adapt.tau is None
    assert repr(db.Adapt([RMB()])) == (
        "Adapt([MotorBabbling()], tau=0.02, window=50, alpha=0.1, head_start=1)"
    )


def test_another_history_begins_anew():
    run = Drive(measure=db.GridCoverage(1.0), window=2)
    for _ in range(3):
        run.step(0, new=False)
    assert run.adapt.diversities == (0.0, 1.0)
    run.history = db.History(run.history.motor_space, run.history.sensory_space)
    trial = run.adapt.propose(run.history, towards(1, 2))
    assert run.adapt.diversities == (1.0, 1.0)
    assert trial.path == (1,)
