"""Summaries: coverage at the steps asked for, and how often each part was chosen."""

import gc
import pickle
import weakref
from dataclasses import replace

import numpy as np
import pytest

import divbandit as db
from divbandit.plot.data import usage_of as plot_usage

ARM = db.PlanarArm(3)
PARTS = [db.MotorBabbling(), db.GoalBabbling(0.05), db.GoalBabbling(0.5)]
RUN = db.explore(ARM, db.Adapt(PARTS), n=40, rng=0)


def by_hand(choices, *, believed=None):
    """Return an exploration of points on a line, an effect a unit, with these choices."""
    history = db.History(db.Box([0], [1]))
    for place, choice in enumerate(choices):
        history.append([0.5], [place], path=() if choice is None else (choice,))
    beliefs = None if believed is None else np.array([believed] * len(choices))
    return replace(db.Exploration.of(history), estimates=beliefs)


def test_coverage_is_that_after_the_steps_asked_for():
    at = [7, 40, 1, 7]
    expected = [db.coverage(RUN.effects[:count], 0.1) for count in at]
    found = db.experiments.summarize(0.1, at=at)(RUN)
    np.testing.assert_allclose(found.coverage, expected, rtol=1e-13)
    assert found.coverage.tobytes() == RUN.coverage(0.1)[[6, 39, 0, 6]].tobytes()


def test_coverage_on_a_line_is_a_length():
    found = db.experiments.summarize(0.25, at=(1, 2, 4))(by_hand([0, 0, 0, 0]))
    assert found.coverage.tolist() == [0.5, 1.0, 2.0]


@pytest.mark.parametrize(
    ("options", "steps"), [({}, [39]), ({"at": []}, []), ({"at": iter(np.array([3, 5]))}, [2, 4])]
)
def test_steps_are_the_last_by_default_none_or_numpys_and_read_once(options, steps):
    keep = db.experiments.summarize(0.1, **options)
    for _ in range(2):
        assert keep(RUN).coverage.tolist() == RUN.coverage(0.1)[steps].tolist()


@pytest.mark.parametrize(
    ("choices", "believed", "usage"),
    [
        ([0, 1, 1, 2], (0.1, 0.2, 0.3), [0.25, 0.5, 0.25]),
        ([0, 1, 1, 0], (0.1, 0.2, 0.3), [0.5, 0.5, 0.0]),  # the last was never chosen
        ([0, 1, 1, 0], None, [0.5, 0.5]),  # not known of
        ([2, 2, 0, 2], None, [0.25, 0.0, 0.75]),
        ([None] * 4, None, [1.0]),
        ([0] * 4, None, [1.0]),
        ([None, 1, 0, 1, 1], None, [0.25, 0.75]),  # an earlier one is of no strategy
    ],
)
def test_usage_counts_choices(choices, believed, usage):
    assert (
        db.experiments.summarize(0.1)(by_hand(choices, believed=believed)).usage.tolist() == usage
    )


def test_it_counts_parts_at_the_top_alone():
    nested = db.Mixture([db.Mixture(PARTS), db.MotorBabbling()])
    run = db.explore(ARM, nested, n=50, rng=0)
    assert db.experiments.summarize(0.1)(run).usage.tolist() == [
        (run.choices == part).sum() / 50 for part in range(2)
    ]


def test_no_exploration_is_kept_alive_by_its_summary():
    run = db.explore(ARM, db.Adapt(PARTS), n=40, rng=0)
    alive, effects = weakref.ref(run), weakref.ref(run.effects)
    summary = db.experiments.summarize(0.1)(run)
    del run
    gc.collect()
    assert alive() is None
    assert effects() is None
    assert summary.coverage.base is None


def test_an_empty_exploration_has_no_summary():
    explorer = db.Explorer(db.MotorBabbling(), ARM.motor_space)
    with pytest.raises(ValueError, match="run must have at least one effect, got none"):
        db.experiments.summarize(0.1)(explorer.result())


def test_both_say_what_they_are_and_can_be_pickled():
    keep = db.experiments.summarize(0.1, at=[2, 40])
    assert repr(keep) == "summarize(0.1, at=(2, 40))"
    again = pickle.loads(pickle.dumps(keep))  # noqa: S301
    assert again == keep
    summary = pickle.loads(pickle.dumps(again(RUN)))  # noqa: S301
    assert isinstance(summary, db.experiments.Summary)
    assert summary.coverage.tolist() == keep(RUN).coverage.tolist()
    assert repr(db.experiments.summarize(0.25)(by_hand([1, 0]))) == (
        "Summary(coverage=array([1.]), usage=array([0.5, 0.5]))"
    )


def test_failed_evaluations_count_among_those_before():
    fates = iter([None, 1.0, None, None, 3.0, 5.0, None])

    def fragile(_):
        fate = next(fates)
        if fate is None:
            raise RuntimeError
        return [fate]

    box = db.FunctionEnvironment(fragile, db.Box([0], [1]))
    run = db.explore(box, db.MotorBabbling(), 7, rng=0, on_error="record")
    summary = db.experiments.summarize(0.5, at=range(1, 8))(run)
    assert summary.coverage.tolist() == [0, 1, 1, 1, 2, 3, 3]
    assert summary.usage.tolist() == [1.0]


def test_earlier_evaluations_are_of_no_strategy():
    earlier = db.explore(ARM, db.MotorBabbling(), 30, rng=0)
    run = db.explore(ARM, db.Mixture(PARTS), 50, rng=0, past=earlier)
    usage = db.experiments.summarize(0.1)(run).usage
    assert usage.sum() == pytest.approx(1)
    shares = plot_usage(run, window=20)
    assert np.isnan(shares[:10]).all()
    np.testing.assert_allclose(shares[40:].sum(axis=1), 1)
