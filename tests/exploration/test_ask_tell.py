"""An Explorer records what it is told, once, of its own trials, or nothing at all.

Asking for n trials is asking n times, and telling a list is telling each.
"""

import numpy as np
import pytest

import divbandit as db
from tests.compositions import NAMES, compositions
from tests.exploration.sameness import everything

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


@pytest.mark.parametrize("name", NAMES)
def test_many_are_one_after_the_other(name):
    lists, singles = (new_explorer(compositions()[name]) for _ in range(2))
    order = np.random.default_rng(7)
    for size in (1, 12, 2, 7):
        asked = lists.ask(size)
        alone = [singles.ask() for _ in range(size)]
        assert [trial.path for trial in asked] == [trial.path for trial in alone]
        places = order.permutation(size)
        lists.tell([asked[i] for i in places], ARM([asked[i].command for i in places]))
        for i in places:
            singles.tell(alone[i], ARM(alone[i].command))
        assert everything(lists) == everything(singles)


def test_each_trial_of_many_can_be_told_by_itself():
    explorer = new_explorer(db.MotorBabbling())
    trials = explorer.ask(4)
    assert [trial.number for trial in trials] == [0, 1, 2, 3]
    explorer.tell(trials[2], [0.1, 0.2])
    explorer.tell([trials[3], trials[0]], [[0.3, 0.4], [0.5, 0.6]])
    expected = [trials[i].command.tolist() for i in (2, 3, 0)]
    assert explorer.history.commands.tolist() == expected
    assert explorer.open_trials == (trials[1],)


BAD_LISTS = {
    "one effect too few": lambda trials: (trials, [[0.0, 0.0]] * 2),
    "a flat effect": lambda trials: (trials, [0.0, 0.0]),
    "an infinite effect": lambda trials: (trials, [[0, 0], [0, np.inf], [0, 0]]),
    "three coordinates": lambda trials: (trials, [[0, 0, 0]] * 3),
    "no effects": lambda trials: (trials, 7),
    "a trial twice": lambda trials: ([trials[0], trials[0], trials[1]], [[0, 0]] * 3),
    "no trial": lambda trials: ([trials[0], 7, trials[1]], [[0, 0]] * 3),
    "a number": lambda _: (7, [[0, 0]] * 3),
    "one made by hand": lambda trials: ([trials[0], db.Trial([0] * 3)], [[0, 0]] * 2),
}


@pytest.mark.parametrize("bad", BAD_LISTS.values(), ids=BAD_LISTS)
@pytest.mark.parametrize("known", [0, 5])
def test_a_refused_list_leaves_no_trace(bad, known):
    explorer = new_explorer(db.Adapt([db.MotorBabbling(), db.GoalBabbling()]))
    for _ in range(known):
        trial = explorer.ask()
        explorer.tell(trial, ARM(trial.command))
    trials = explorer.ask(3)
    before = everything(explorer)
    with pytest.raises((TypeError, ValueError), match=r"^(effect|trial)"):
        explorer.tell(*bad(trials))
    assert everything(explorer) == before
    assert explorer.open_trials == tuple(trials)
    explorer.tell(trials, ARM([trial.command for trial in trials]))
    assert len(explorer.history) == known + 3


def test_an_empty_list_is_nothing():
    explorer = new_explorer(db.MotorBabbling())
    explorer.tell([], np.empty((0, 2)))
    assert len(explorer.history) == 0


def test_trials_asked_for_before_a_bad_command_are_under_way():
    class Beyond(db.Strategy):
        asked = 0

        def propose(self, history, rng):
            self.asked += 1
            return history.motor_space.sample(rng) * (9 if self.asked == 3 else 1)

    explorer = new_explorer(db.Mixture([Beyond()]))
    with pytest.raises(ValueError, match=r"command\[0\] must be .* path \(0,\)"):
        explorer.ask(30)
    assert [trial.number for trial in explorer.open_trials] == [0, 1]
    assert len(explorer.history) == 0
