"""What holds for every strategy, alone or composed."""

import copy

import numpy as np
import pytest

import divbandit as db
from tests.compositions import NAMES, compositions

ARM = db.PlanarArm(5)
N = 150


@pytest.fixture(params=NAMES)
def strategy(request):
    return compositions()[request.param]


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


def test_a_copy_made_half_way_goes_on_alike(strategy):
    """Driven by hand, a copy and the original make the same of the same stream."""
    history, rng = db.History(ARM.motor_space, ARM.sensory_space), np.random.default_rng(0)
    step(strategy, history, rng, 40)
    other, past = copy.deepcopy((strategy, history))
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
    if "GoalBabbling" in repr(strategy) and "goals=" not in repr(strategy):
        with pytest.raises(ValueError, match="goals must be given"):
            db.explore(environment, strategy, n=1, rng=0)
    else:
        assert db.explore(environment, strategy, n=N, rng=0).effects.shape == (N, 2)
