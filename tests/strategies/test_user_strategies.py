"""A user's strategy needs one method, and is told of its own trials alone."""

import numpy as np
import pytest

import divbandit as db

ARM = db.PlanarArm(2)


class Zero(db.Strategy):
    """Proposes a bare list."""

    def __init__(self):
        self.told = []

    def propose(self, history, rng):
        del rng
        return [0.0] * history.motor_space.dim

    def observe(self, trial, effect):
        self.told.append((trial, effect))


class Remembering(db.Strategy):
    """Proposes trials with goals, and remembers all that happens to it."""

    def __init__(self, angle):
        self.angle, self.proposed, self.told = angle, [], []

    def __deepcopy__(self, memo):
        del memo
        return self  # so that the test sees the one that explores

    def propose(self, history, rng):
        del history, rng
        trial = db.Trial([self.angle, 0.0], goal=[self.angle, len(self.proposed)])
        self.proposed.append(trial)
        return trial

    def observe(self, trial, effect):
        self.told.append((trial, effect))


def test_a_bare_list_is_enough():
    run = db.explore(ARM, Zero(), n=3, rng=0)
    assert run.commands.tolist() == [[0, 0]] * 3
    assert run.paths.shape == (3, 0)
    assert run.choices.tolist() == [0, 0, 0]


def test_a_bare_list_is_observed_as_a_trial():
    strategy = Zero()
    explorer = db.Explorer(db.Mixture([strategy]), ARM.motor_space, rng=0)
    explorer.tell(explorer.ask(), [1.0, 0.0])
    assert strategy.told == []  # a copy explores
    ((told, effect),) = explorer.strategy.strategies[0].told
    assert isinstance(told, db.Trial)
    assert (told.command, told.path, effect.tolist()) == ([0.0, 0.0], (), [1.0, 0.0])


@pytest.mark.parametrize(
    "compose",
    [
        lambda a, b: db.Mixture([a, b]),
        lambda a, b: db.Adapt([a, b]),
        lambda a, b: db.Schedule([(17, a), (None, b)]),
        lambda a, b: db.Adapt([db.Mixture([a]), db.Adapt([db.Mixture([b])])]),
    ],
)
def test_each_observes_exactly_the_trials_that_it_proposed(compose):
    a, b = Remembering(0.25), Remembering(1.0)
    run = db.explore(ARM, compose(a, b), n=60, rng=0)
    assert len(a.told) + len(b.told) == 60
    for strategy in (a, b):
        assert len(strategy.told) == len(strategy.proposed) > 0
        effect = ARM([strategy.angle, 0.0]).tolist()
        for proposed, (told, got) in zip(strategy.proposed, strategy.told, strict=True):
            assert told is proposed
            assert got.tolist() == effect
    assert (run.commands[:, 0] == a.angle).tolist() == (run.choices == 0).tolist()


def test_alone_it_observes_the_very_trial_too():
    strategy = Remembering(0.5)
    explorer = db.Explorer(strategy, ARM.motor_space, rng=0)
    trial = explorer.ask()
    assert trial.inner is strategy.proposed[0]
    explorer.tell(trial, [1.0, 0.0])
    assert strategy.told[0][0] is trial.inner


def test_the_goal_of_a_part_reaches_the_asker():
    explorer = db.Explorer(db.Mixture([Remembering(0.5)]), ARM.motor_space, rng=0)
    trial = explorer.ask()
    assert (trial.goal, trial.path) == ([0.5, 0], (0,))


def test_the_history_holds_the_effect_when_it_is_observed():
    lengths = []

    class Counting(Zero):
        def propose(self, history, rng):
            self.history = history
            return super().propose(history, rng)

        def observe(self, trial, effect):
            del trial
            lengths.append((len(self.history), self.history.effects[-1].tolist(), effect.tolist()))

    db.explore(ARM, Counting(), n=3, rng=0)
    assert lengths == [(n, [1.0, 0.0], [1.0, 0.0]) for n in (1, 2, 3)]


@pytest.mark.parametrize("proposal", [[0.0], [9.0, 0.0], "ab", None, [np.nan, 0.0], [[0.0, 0.0]]])
def test_a_proposal_that_is_no_command_is_refused(proposal):
    class Wrong(db.Strategy):
        def propose(self, history, rng):
            del history, rng
            return proposal

    explorer = db.Explorer(Wrong(), ARM.motor_space, rng=0)
    with pytest.raises((TypeError, ValueError), match="command"):
        explorer.ask()
    assert len(explorer.history) == 0


@pytest.mark.parametrize("choice", [2, -1, 0.0, None, "0"])
def test_a_choice_that_is_no_index_is_refused(choice):
    class Wrong(db.Composite):
        def choose(self, history, rng):
            del history, rng
            return choice

    explorer = db.Explorer(Wrong([Zero(), Zero()]), ARM.motor_space, rng=0)
    with pytest.raises((TypeError, ValueError), match=r"choose|choice|index|indices"):
        explorer.ask()


@pytest.mark.parametrize("base", [db.GoalBabbling, db.Mixture, db.Schedule, db.Adapt, db.Bandit])
def test_a_class_cannot_change_how_a_value_of_the_library_proposes(base):
    with pytest.raises(TypeError, match=r"Mine must derive from Strategy .* its propose would not"):
        type("Mine", (base,), {"propose": lambda *_: [0.5], "__module__": "mine"})


def test_a_class_derived_from_motor_babbling_is_copied():
    class Counting(db.MotorBabbling):
        asked = 0

        def propose(self, history, rng):
            self.asked += 1
            return super().propose(history, rng)

    counting = Counting()
    explorer = db.Explorer(counting, db.Box([0], [1]), rng=0)
    explorer.ask(3)
    assert (counting.asked, explorer.strategy.asked) == (0, 3)
