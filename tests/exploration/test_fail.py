"""Trials that fail: the budget is spent, nothing is rewarded, the log tells."""

import pytest

import divbandit as db

ARM = db.PlanarArm(4)


def new_explorer(strategy, rng=0):
    return db.Explorer(strategy, ARM.motor_space, ARM.sensory_space, rng=rng)


def test_the_log_tells_of_it_and_nothing_else_does():
    explorer = new_explorer(db.Adapt([db.MotorBabbling(), db.GoalBabbling()]))
    first, second, third = (explorer.ask() for _ in range(3))
    explorer.tell(second, [0.5, 0.5])
    explorer.fail(first, "the robot fell over")
    explorer.tell(third, [0.1, 0.5])
    assert len(explorer.history) == 2
    (failure,) = explorer.history.failures
    assert failure.command.tolist() == first.command.tolist()
    assert (failure.reason, failure.path, failure.place) == ("the robot fell over", first.path, 1)
    assert explorer.result().failures == (failure,)
    assert explorer.result().effects.tolist() == [[0.5, 0.5], [0.1, 0.5]]
    assert explorer.open_trials == ()
    for call in (lambda: explorer.fail(first, "again"), lambda: explorer.tell(first, [0, 0])):
        with pytest.raises(ValueError, match="trial must be pending"):
            call()


def test_a_bandit_takes_it_for_a_trial_without_gain():
    adapt = db.Adapt([db.MotorBabbling()], tau=0.5, window=4, head_start=1)
    explorer = new_explorer(adapt)
    disc = explorer.estimates[0]
    explorer.fail(explorer.ask(), "fell over")
    assert explorer.estimates == (disc / 2,)  # a whole disc and nothing
    explorer.tell(explorer.ask(), [0.0, 0.0])
    assert explorer.estimates[0] == pytest.approx(2 * disc / 3)
    for _ in range(4):
        explorer.fail(explorer.ask(), "fell over")
    assert explorer.estimates == (0.0,)


def test_one_that_always_fails_is_left_alone():
    explorer = new_explorer(db.Adapt([db.GoalBabbling(), db.MotorBabbling()]))
    asked = [0, 0]
    for _ in range(500):
        trial = explorer.ask()
        asked[trial.path[0]] += 1
        if trial.path[0] == 1:
            explorer.fail(trial, "fell over")
        else:
            explorer.tell(trial, ARM(trial.command))
    # Half of the tenth that is drawn uniformly: 25 of 500, and some at the beginning.
    assert asked[1] < 75


def test_a_strategy_is_told_of_its_own_failures_alone():
    class Counting(db.Strategy):
        def __init__(self):
            self.failed = []

        def propose(self, history, rng):
            return history.motor_space.sample(rng)

        def fail(self, trial, reason):
            self.failed.append((trial.command.tolist(), reason))

    explorer = new_explorer(db.Mixture([Counting(), db.Mixture([Counting(), Counting()])]))
    expected = {}
    for step in range(30):
        trial = explorer.ask()
        explorer.fail(trial, f"reason {step}")
        expected.setdefault(trial.path, []).append((trial.command.tolist(), f"reason {step}"))
    outer, inner = explorer.strategy.strategies
    found = {(0,): outer.failed}
    found |= {(1, i): part.failed for i, part in enumerate(inner.strategies)}
    assert found == expected


def test_failures_are_saved_with_an_exploration(tmp_path):
    explorer = new_explorer(db.Adapt([db.MotorBabbling(), db.GoalBabbling()]))
    reasons = ["plain", "", "ünïcode \ud800 \x00", "end"]
    for reason in reasons:
        explorer.fail(explorer.ask(), reason)
        explorer.tell(explorer.ask(), [0.5, 0.25])
    run = explorer.result()
    run.save(tmp_path / "run")
    again = db.Exploration.load(tmp_path / "run")
    assert [failure.reason for failure in again.failures] == reasons
    for one, other in zip(again.failures, run.failures, strict=True):
        assert one.command.tolist() == other.command.tolist()
        assert one[1:] == other[1:]
