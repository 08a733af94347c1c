"""An Explorer records what it is told, once, of its own trials, or nothing at all."""

import numpy as np
import pytest

import divbandit as db

ARM = db.PlanarArm(3)
ADAPT = db.Adapt([db.MotorBabbling(), db.GoalBabbling(0.05)], window=5)


def new_explorer(strategy=ADAPT, rng=0):
    return db.Explorer(strategy, ARM.motor_space, ARM.sensory_space, rng=rng)


def told(explorer):
    result = explorer.result()
    return result.commands.tolist(), result.effects.tolist(), result.paths.tolist()


def test_telling_twice_is_refused():
    explorer = new_explorer()
    trial = explorer.ask()
    explorer.tell(trial, [0.5, 0.5])
    before = told(explorer)
    with pytest.raises(ValueError, match="trial must be pending"):
        explorer.tell(trial, [0.5, 0.5])
    assert told(explorer) == before


def test_another_explorers_trial_is_refused():
    explorer, other = new_explorer(), new_explorer()
    mine, theirs = explorer.ask(), other.ask()
    assert mine.command.tolist() == theirs.command.tolist()
    with pytest.raises(ValueError, match="trial must be pending"):
        explorer.tell(theirs, [0.5, 0.5])
    assert len(explorer.history) == 0
    explorer.tell(mine, [0.5, 0.5])
    other.tell(theirs, [0.5, 0.5])
    assert told(explorer) == told(other)


@pytest.mark.parametrize("s", [1, 2, 3, 7])
def test_the_first_effect_tells_the_dimension(s):
    explorer = db.Explorer(db.MotorBabbling(), ARM.motor_space, rng=0)
    assert explorer.history.effect_dim is None
    explorer.tell(explorer.ask(), [0.5] * s)
    assert explorer.history.effect_dim == s
    with pytest.raises(ValueError, match="effect must have shape"):
        explorer.tell(explorer.ask(), [0.5] * (s + 1))
    assert explorer.result().effects.tolist() == [[0.5] * s]


def test_the_log_is_not_changed_through_a_command():
    explorer = new_explorer()
    trial = explorer.ask()
    with pytest.raises(ValueError, match="read-only"):
        trial.command[0] = 0.0
    original = trial.command.tolist()
    with pytest.raises(AttributeError, match="readonly"):
        trial.command = np.zeros(3)
    effect = np.array([0.5, 0.25])
    explorer.tell(trial, effect)
    effect[:] = 9
    assert told(explorer)[:2] == ([original], [[0.5, 0.25]])
    for array in (explorer.history.commands, explorer.history.effects):
        with pytest.raises(ValueError, match="read-only"):
            array[0, 0] = 1.0


def test_a_strategy_that_changes_its_array_later_does_not_change_the_log():
    class Reusing(db.Strategy):
        command = np.zeros(3)

        def propose(self, history, rng):
            del rng
            self.command[:] = 0.125 * len(history)
            return self.command

    run = db.explore(ARM, Reusing(), n=4, rng=0)
    assert run.commands[:, 0].tolist() == [0, 0.125, 0.25, 0.375]
