"""Many trials at once: what they are, and that telling them is telling each."""

import numpy as np
import pytest

import divbandit as db
from tests.compositions import NAMES, compositions

ARM = db.PlanarArm(4)


def new_explorer(strategy, rng=0):
    return db.Explorer(strategy, ARM.motor_space, ARM.sensory_space, rng=rng)


def everything(explorer):
    run = explorer.result()
    beliefs = None if run.diversities is None else run.diversities.tolist()
    state = explorer.rng.bit_generator.state["state"]
    now = explorer.strategy.diversities
    return run.commands.tolist(), run.effects.tolist(), run.paths.tolist(), beliefs, now, state


@pytest.mark.parametrize("name", NAMES)
def test_telling_a_batch_is_telling_one_after_the_other(name):
    batches, singles = (new_explorer(compositions()[name]) for _ in range(2))
    order = np.random.default_rng(7)
    for size in (1, 30, 2, 17):
        asked = [explorer.ask(size) for explorer in (batches, singles)]
        assert asked[0].commands.tolist() == asked[1].commands.tolist()
        places = order.permutation(size)
        batches.tell([asked[0][i] for i in places], ARM(asked[0].commands[places]))
        for i in places:
            singles.tell(asked[1][i], ARM(asked[1].commands[i]))
        assert everything(batches) == everything(singles)


@pytest.mark.parametrize("name", NAMES)
def test_asking_for_one_in_a_batch_is_asking_for_one(name):
    batches, singles = (new_explorer(compositions()[name]) for _ in range(2))
    for _ in range(40):
        trials, trial = batches.ask(1), singles.ask()
        assert trials[0].path == trial.path
        assert trials[0].number == trial.number
        batches.tell(trials, ARM(trials.commands))
        singles.tell(trial, ARM(trial.command))
    assert everything(batches) == everything(singles)


@pytest.mark.parametrize("leaf", [db.MotorBabbling(), db.GoalBabbling(0.05)], ids=repr)
def test_a_strategy_without_parts_proposes_the_same_in_batches(leaf):
    batches, singles = new_explorer(leaf), new_explorer(leaf)
    for explorer in (batches, singles):
        trial = explorer.ask()
        explorer.tell(trial, ARM(trial.command))
    trials, others = batches.ask(20), [singles.ask() for _ in range(20)]
    assert trials.commands.tolist() == [trial.command.tolist() for trial in others]
    goals = [
        [None if each.goal is None else list(each.goal) for each in t] for t in (trials, others)
    ]
    assert goals[0] == goals[1]
    assert batches.rng.random() == singles.rng.random()


def test_a_composite_chooses_first_and_then_each_part_proposes():
    """The specification, in plain words: choices, then motor babbling's share, then goals'."""
    mixture = db.Mixture([db.MotorBabbling(), db.GoalBabbling(0.05)], weights=[0.3, 0.7])
    explorer = new_explorer(mixture, rng=3)
    explorer.tell(explorer.ask(), [0.5, 0.5])
    rng = np.random.default_rng()
    rng.bit_generator.state = explorer.rng.bit_generator.state
    trials = explorer.ask(12)
    choices = [0 if rng.random() < 0.3 else 1 for _ in range(12)]
    expected = {}
    for part, strategy in enumerate(mixture.strategies):
        for place in (i for i in range(12) if choices[i] == part):
            expected[place] = strategy.propose(explorer.history, rng).command.tolist()
    assert set(choices) == {0, 1}
    assert [trial.path for trial in trials] == [(choice,) for choice in choices]
    assert trials.commands.tolist() == [expected[place] for place in range(12)]


def test_trials_are_a_sequence_with_all_commands():
    trials = new_explorer(db.MotorBabbling()).ask(5)
    assert isinstance(trials, db.Trials)
    assert len(trials) == len(list(trials)) == 5
    assert [trial.number for trial in trials[1:3]] == [1, 2]
    assert trials[1:3].commands.tolist() == trials.commands[1:3].tolist()
    assert trials[-1].command.tolist() == trials.commands[-1].tolist()
    with pytest.raises(ValueError, match="read-only"):
        trials.commands[0, 0] = 0.0
    with pytest.raises(ValueError, match="read-only"):
        trials[0].command[0] = 0.0


def test_each_trial_of_a_batch_can_be_told_by_itself():
    explorer = new_explorer(db.MotorBabbling())
    trials = explorer.ask(4)
    explorer.tell(trials[2], [0.1, 0.2])
    explorer.tell([trials[3], trials[0]], [[0.3, 0.4], [0.5, 0.6]])
    assert explorer.history.commands.tolist() == trials.commands[[2, 3, 0]].tolist()
    assert [trials[i].place for i in (2, 3, 0)] == [0, 1, 2]
    assert explorer.open_trials == (trials[1],)


BAD_BATCHES = {
    "one effect too few": lambda trials: (trials, [[0.0, 0.0]] * 2),
    "a flat effect": lambda trials: (trials, [0.0, 0.0]),
    "an infinite effect": lambda trials: (trials, [[0, 0], [0, np.inf], [0, 0]]),
    "three coordinates": lambda trials: (trials, [[0, 0, 0]] * 3),
    "a trial twice": lambda trials: ([trials[0], trials[0], trials[1]], [[0, 0]] * 3),
    "no trial": lambda trials: ([trials[0], 7, trials[1]], [[0, 0]] * 3),
    "a number": lambda _: (7, [[0, 0]] * 3),
    "one made by hand": lambda trials: ([trials[0], db.Trial([0] * 4)], [[0, 0]] * 2),
}


@pytest.mark.parametrize("bad", BAD_BATCHES.values(), ids=BAD_BATCHES)
@pytest.mark.parametrize("known", [0, 5])
def test_a_refused_batch_leaves_no_trace(bad, known):
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
    explorer.tell(trials, ARM(trials.commands))
    assert len(explorer.history) == known + 3


@pytest.mark.parametrize("n", [0, -1, 1.5, "3", True])
def test_bad_numbers_of_trials(n):
    explorer = new_explorer(db.MotorBabbling())
    with pytest.raises((TypeError, ValueError), match=r"^n must be"):
        explorer.ask(n)
    assert explorer.open_trials == ()


def test_an_empty_batch_is_nothing():
    explorer = new_explorer(db.MotorBabbling())
    explorer.tell([], np.empty((0, 2)))
    assert len(explorer.history) == 0


def test_a_bad_command_in_a_batch_names_who_proposed_it():
    class Outside(db.Strategy):
        def propose(self, history, rng):
            del rng
            return [9.0] * history.motor_space.dim

    explorer = new_explorer(db.Mixture([db.MotorBabbling(), Outside()]))
    with pytest.raises(ValueError, match=r"command\[0\] must be .* path \(1,\)"):
        explorer.ask(30)
    assert explorer.open_trials == ()
    assert len(explorer.history) == 0


def test_a_part_that_occurs_twice_is_told_in_order():
    def twice():
        shared = db.Adapt([db.MotorBabbling(), db.GoalBabbling()], window=3)
        return db.Mixture([shared, db.GoalBabbling(0.5), shared])

    batches, singles = new_explorer(twice()), new_explorer(twice())
    for _ in range(5):
        asked = [explorer.ask(20) for explorer in (batches, singles)]
        batches.tell(asked[0], ARM(asked[0].commands))
        for trial in asked[1]:
            singles.tell(trial, ARM(trial.command))
        inner = [explorer.strategy.strategies[0].diversities for explorer in (batches, singles)]
        assert inner[0] == inner[1]
    assert everything(batches) == everything(singles)


@pytest.mark.parametrize("power", [1, 8, 0.5, 0])
def test_choices_drawn_at_once_are_those_drawn_one_by_one(power):
    chance = np.random.default_rng(5)
    for parts in (1, 2, 3, 17):
        for _ in range(30):
            means = chance.random(parts) * (chance.random(parts) < 0.6) - 0.1
            memory = db.bandits.WholePast()
            memory.begin(parts, 1.0)
            for part, mean in enumerate(means):
                memory.add(part, float(mean))
            rule = db.bandits.Proportional(0.2, power=power)
            streams = [np.random.default_rng(int(1e6 * abs(means.sum()))) for _ in range(2)]
            singly = [rule.choose(memory, streams[0]) for _ in range(50)]
            assert rule.choose_many(memory, 50, streams[1]) == singly
            assert streams[0].random() == streams[1].random()


def test_a_strategy_that_says_anew_how_it_proposes_loses_the_shortcut():
    class Still(db.MotorBabbling):
        def propose(self, history, rng):
            del rng
            return history.motor_space.low

    trials = new_explorer(Still()).ask(3)
    assert trials.commands.tolist() == [ARM.motor_space.low.tolist()] * 3


def test_one_that_observes_sees_the_history_grow_one_by_one():
    class Watching(db.MotorBabbling):
        def __init__(self):
            self.lengths = []

        def propose(self, history, rng):
            self.history = history
            return super().propose(history, rng)

        def observe(self, trial, effect):
            del effect
            self.lengths.append((len(self.history), trial.place))

    explorer = new_explorer(db.Mixture([Watching()]))
    trials = explorer.ask(3)
    explorer.tell(trials, ARM(trials.commands))
    assert explorer.strategy.strategies[0].lengths == [(1, 0), (2, 1), (3, 2)]


BAD_PROPOSALS = {
    "one too few": lambda history, n, rng: [history.motor_space.sample(rng)] * (n - 1),
    "one too many": lambda history, n, rng: [history.motor_space.sample(rng)] * (n + 1),
    "nothing": lambda *_: None,
}


@pytest.mark.parametrize("bad", BAD_PROPOSALS.values(), ids=BAD_PROPOSALS)
@pytest.mark.parametrize("composed", [False, True])
def test_a_bad_batch_of_a_strategy_is_refused_by_name(bad, composed):
    class Own(db.MotorBabbling):
        def propose_many(self, history, n, rng):
            return bad(history, n, rng)

    explorer = new_explorer(db.Mixture([Own()]) if composed else Own())
    with pytest.raises((TypeError, ValueError), match=r"propose_many\(\) of Own\(\) must return"):
        explorer.ask(5)
    assert explorer.open_trials == ()


def test_a_batch_of_plain_commands_is_taken():
    class Plain(db.MotorBabbling):
        def propose_many(self, history, n, rng):
            return (history.motor_space.sample(rng).tolist() for _ in range(n))

    expected = new_explorer(db.MotorBabbling()).ask(4).commands.tolist()
    assert new_explorer(Plain()).ask(4).commands.tolist() == expected
