"""What holds for every strategy, alone or composed."""

import copy
import pickle

import numpy as np
import pytest

import divbandit as db
from tests.compositions import NAMES, compositions

ARM = db.PlanarArm(5)
N = 150
LEAVES = [name for name, each in compositions().items() if not isinstance(each, db.Composite)]


@pytest.fixture(params=NAMES)
def strategy(request):
    return compositions()[request.param]


def pickled(value):
    return pickle.loads(pickle.dumps(value))  # noqa: S301 - our own


def bits(run):
    """Return all of a run that could differ, comparable with ==."""
    diversities = None if run.diversities is None else run.diversities.tobytes()
    return run.commands.tobytes(), run.effects.tobytes(), run.paths.tobytes(), diversities


def test_proposals_lie_in_the_motor_space(strategy):
    run = db.explore(ARM, strategy, n=N, rng=0)
    assert all(ARM.motor_space.contains(command) for command in run.commands)
    assert run.effects.tolist() == ARM(run.commands).tolist()


def test_same_seed_same_bits(strategy):
    runs = {bits(db.explore(ARM, strategy, n=N, rng=3)) for _ in range(3)}
    assert len(runs) == 1
    assert bits(db.explore(ARM, strategy, n=N, rng=4)) not in runs


def test_a_fresh_one_and_a_copy_explore_alike(strategy, request):
    fresh = compositions()[request.node.callspec.params["strategy"]]
    expected = bits(db.explore(ARM, strategy, n=N, rng=1))
    assert bits(db.explore(ARM, fresh, n=N, rng=1)) == expected
    assert bits(db.explore(ARM, copy.deepcopy(strategy), n=N, rng=1)) == expected


def test_exploring_does_not_touch_it(strategy):
    before, words, beliefs = copy.deepcopy(strategy), repr(strategy), strategy.diversities
    first = bits(db.explore(ARM, strategy, n=N, rng=1))
    db.Explorer(strategy, ARM.motor_space, ARM.sensory_space, rng=0).ask()
    assert repr(strategy) == words == repr(before)
    assert strategy.diversities == beliefs
    assert bits(db.explore(ARM, strategy, n=N, rng=1)) == first
    assert bits(db.explore(ARM, before, n=N, rng=1)) == first


def test_proposes_before_the_first_observation(strategy):
    """A strategy may be asked many times before anything is told, also out of order."""
    explorer = db.Explorer(strategy, ARM.motor_space, ARM.sensory_space, rng=0)
    trials = [explorer.ask() for _ in range(20)]
    for trial in trials:
        assert trial.goal is None
        assert ARM.motor_space.contains(trial.command)
    for trial in trials[::-1]:
        explorer.tell(trial, ARM(trial.command))
    assert list(explorer.history.paths) == [trial.path for trial in trials[::-1]]
    expected = [trial.command.tolist() for trial in trials[::-1]]
    assert explorer.history.commands.tolist() == expected


def test_goals_are_drawn_in_the_box_of_goals(strategy):
    explorer = db.Explorer(strategy, ARM.motor_space, ARM.sensory_space, rng=0)
    widest = db.Box([-2, -3], [2, 3])
    for _ in range(60):
        trial = explorer.ask()
        assert trial.goal is None or widest.contains(trial.goal)
        explorer.tell(trial, ARM(trial.command))


@pytest.mark.parametrize("way", [copy.deepcopy, pickled], ids=["deepcopy", "pickle"])
def test_a_copy_made_half_way_goes_on_alike(strategy, way):
    """Driven by hand, a copy and the original make the same of the same stream."""
    history, rng = db.History(ARM.motor_space, ARM.sensory_space), np.random.default_rng(0)
    step(strategy, history, rng, 40)
    other, past = way((strategy, history))
    assert past.commands.tolist() == history.commands.tolist()
    stream = copy.deepcopy(rng)
    step(strategy, history, rng, 40)
    assert len(past) == 40
    step(other, past, stream, 40)
    assert past.commands.tolist() == history.commands.tolist()
    assert past.paths == history.paths
    assert other.diversities == strategy.diversities


def step(strategy, history, rng, n):
    for _ in range(n):
        trial = db.Trial.of(strategy.propose(history, rng))
        effect = ARM(trial.command)
        history.append(trial.command, effect, path=trial.path)
        strategy.observe(trial, effect)


def test_needs_goals_where_the_environment_has_none(strategy):
    """It says so before the first step, or can do without."""
    environment = db.FunctionEnvironment(ARM, ARM.motor_space)
    words = repr(strategy)
    if "GoalBabbling" in words and "=Box(" not in words:
        with pytest.raises(ValueError, match="goals must be given"):
            db.explore(environment, strategy, n=1, rng=0)
    else:
        assert db.explore(environment, strategy, n=N, rng=0).effects.shape == (N, 2)


def fresh_history():
    return db.History(ARM.motor_space, ARM.sensory_space)


def test_others_do_not_matter(strategy, request):
    """Its proposals depend on its own stream, history and trials: two in turn are as two alone."""
    other = compositions()[request.node.callspec.params["strategy"]]
    both = [(strategy, fresh_history(), 1), (other, fresh_history(), 2)]
    alone = []
    for _, _, seed in both:
        past = fresh_history()
        single = compositions()[request.node.callspec.params["strategy"]]
        step(single, past, np.random.default_rng(seed), 60)
        alone.append(past.commands.tobytes())
    streams = [np.random.default_rng(seed) for _, _, seed in both]
    for _ in range(60):
        for (each, past, _), rng in zip(both, streams, strict=True):
            step(each, past, rng, 1)
    assert [past.commands.tobytes() for _, past, _ in both] == alone


@pytest.mark.parametrize("kind", [db.Mixture, db.Adapt])
def test_it_can_be_a_part(strategy, kind):
    whole = kind([strategy, db.MotorBabbling()])
    run = db.explore(ARM, whole, N, rng=0)
    assert all(ARM.motor_space.contains(command) for command in run.commands)
    assert set(run.choices.tolist()) == {0, 1}
    assert bits(db.explore(ARM, whole, N, rng=0)) == bits(run)


def babble_with_failures(strategy):
    """Return all commands of an exploration of which the first trials and every third one fail."""
    history, rng, commands = fresh_history(), np.random.default_rng(0), []
    for i in range(90):
        trial = db.Trial.of(strategy.propose(history, rng))
        commands.append(list(trial.command))
        if i < 5 or i % 3 == 0:
            strategy.fail(trial, "the motor is too hot")
            continue
        effect = ARM(trial.command)
        trial.place = len(history)
        history.append(trial.command, effect, path=trial.path)
        strategy.observe(trial, effect)
    return commands


def test_it_goes_on_after_failures(strategy, request):
    fresh = compositions()[request.node.callspec.params["strategy"]]
    commands = babble_with_failures(strategy)
    assert all(ARM.motor_space.contains(command) for command in commands)
    assert babble_with_failures(fresh) == commands


@pytest.mark.parametrize("known", [0, 1, 30])
@pytest.mark.parametrize("name", LEAVES)
def test_many_proposals_are_as_many_calls(name, known):
    """For strategies that choose nobody else: a composite asks each part for its whole share."""
    strategy, other = compositions()[name], compositions()[name]
    history, rng, plain = fresh_history(), np.random.default_rng(0), np.random.default_rng(0)
    step(db.MotorBabbling(), history, np.random.default_rng(1), known)
    trials = strategy.propose_many(history, 9, rng)
    expected = [db.Trial.of(other.propose(history, plain)) for _ in range(9)]
    assert [list(trial.command) for trial in trials] == [list(each.command) for each in expected]
    for trial, each in zip(trials, expected, strict=True):
        assert (trial.goal is None) == (each.goal is None)
        assert trial.goal is None or list(trial.goal) == list(each.goal)
    assert rng.random() == plain.random()
    assert strategy.propose_many(history, 0, rng) == []


def test_many_proposals_lie_in_the_motor_space(strategy):
    history, rng = fresh_history(), np.random.default_rng(0)
    for n in (1, 7, 0, 40):
        trials = [db.Trial.of(each) for each in strategy.propose_many(history, n, rng)]
        assert len(trials) == n
        for trial in trials:
            assert ARM.motor_space.contains(trial.command)
            trial.place = len(history)
            history.append(trial.command, ARM(trial.command), path=trial.path)
            strategy.observe(trial, history.effects[-1])
