"""What holds for every strategy, alone or composed."""

import numpy as np
import pytest

import divbandit as db
from divbandit.goals import UntriedGoals
from divbandit.strategies import Starter
from tests.compositions import NAMES, compositions
from tests.generators import state, twins

ARM = db.PlanarArm(5)
N = 150


@pytest.fixture(params=NAMES)
def strategy(request):
    return compositions()[request.param]


def bits(run):
    """Return all of a run that could differ, comparable with ==."""
    estimates = None if run.estimates is None else run.estimates.tobytes()
    return run.commands.tobytes(), run.effects.tobytes(), run.paths.tobytes(), estimates


def test_proposals_lie_in_the_motor_space(strategy):
    run = db.explore(ARM, strategy, n=N, rng=0)
    assert all(ARM.motor_space.contains(command) for command in run.commands)
    assert run.effects.tolist() == ARM(run.commands).tolist()


def test_same_seed_same_bits(strategy):
    runs = {bits(db.explore(ARM, strategy, n=N, rng=3)) for _ in range(2)}
    assert len(runs) == 1
    assert bits(db.explore(ARM, strategy, n=N, rng=4)) not in runs


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


def draws_in_the_sensory_space(strategy):
    """Say whether one of its parts draws goals there: it has no box, and needs one."""
    if isinstance(strategy, db.GoalBabbling):
        own = getattr(strategy.sampler, "box", None)
        return own is None and not isinstance(strategy.sampler, UntriedGoals)
    return any(map(draws_in_the_sensory_space, getattr(strategy, "strategies", ())))


def test_needs_goals_where_the_environment_has_none(strategy):
    """It says so before the first step, or can do without."""
    environment = db.FunctionEnvironment(ARM, ARM.motor_space)
    if draws_in_the_sensory_space(strategy):
        with pytest.raises(ValueError, match="there must be a sensory space"):
            db.explore(environment, strategy, n=1, rng=0)
    else:
        assert db.explore(environment, strategy, n=N, rng=0).effects.shape == (N, 2)


@pytest.mark.parametrize("kind", [db.Mixture, db.Adapt])
def test_it_can_be_a_part(strategy, kind):
    whole = kind([strategy, db.MotorBabbling()])
    run = db.explore(ARM, whole, N, rng=0)
    assert all(ARM.motor_space.contains(command) for command in run.commands)
    assert set(run.choices.tolist()) == {0, 1}
    assert bits(db.explore(ARM, whole, N, rng=0)) == bits(run)


def babble_with_failures(strategy):
    """Return all commands of an exploration of which the first trials and every third one fail."""
    explorer = db.Explorer(strategy, ARM.motor_space, ARM.sensory_space, rng=0)
    commands = []
    for i in range(90):
        trial = explorer.ask()
        commands.append(trial.command.tolist())
        if i < 5 or i % 3 == 0:
            explorer.fail(trial, "the motor is too hot")
        else:
            explorer.tell(trial, ARM(trial.command))
    return commands


def test_it_goes_on_after_failures(strategy):
    commands = babble_with_failures(strategy)
    assert all(ARM.motor_space.contains(command) for command in commands)
    assert babble_with_failures(strategy) == commands


def test_a_value_proposes_as_right_after_the_start(strategy):
    """Asked by itself, outside of an exploration."""
    history, rngs = db.History(ARM.motor_space, ARM.sensory_space), twins(np.random.PCG64)
    running = Starter(history)(strategy)
    trial, expected = strategy.propose(history, rngs[0]), running.propose(history, rngs[1])
    expected = db.Trial.of(expected)
    assert (list(trial.command), trial.path) == (list(expected.command), expected.path)
    assert state(rngs[0]) == state(rngs[1])
