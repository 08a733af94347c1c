"""An explorer can be copied or pickled at any moment; original and copy go on alike."""

import copy
import pickle

import pytest

import divbandit as db
from tests.compositions import NAMES, compositions

ARM = db.PlanarArm(5)
COPIES = {"deepcopy": copy.deepcopy, "pickle": lambda x: pickle.loads(pickle.dumps(x))}  # noqa: S301


def go_on(explorer, trials, steps):
    """Tell the open trials, make some more steps, and return all that came of it."""
    for trial in trials:
        explorer.tell(trial, ARM(trial.command))
    for _ in range(steps):
        trial = explorer.ask()
        explorer.tell(trial, ARM(trial.command))
    run = explorer.result()
    diversities = None if run.diversities is None else run.diversities.tobytes()
    return run.commands.tobytes(), run.effects.tobytes(), run.paths.tobytes(), diversities


@pytest.mark.parametrize("way", COPIES)
@pytest.mark.parametrize("name", NAMES)
def test_a_copy_goes_on_with_the_same_bits(name, way):
    explorer = db.Explorer(compositions()[name], ARM.motor_space, ARM.sensory_space, rng=0)
    go_on(explorer, [], 60)
    trials = [explorer.ask() for _ in range(3)]
    other, others = COPIES[way]((explorer, trials))
    assert go_on(other, others, 60) == go_on(explorer, trials, 60)


@pytest.mark.parametrize("way", COPIES)
def test_a_copy_knows_its_own_trials_alone(way):
    explorer = db.Explorer(db.MotorBabbling(), ARM.motor_space, rng=0)
    trial = explorer.ask()
    other = COPIES[way](explorer)
    with pytest.raises(ValueError, match="trial must be one that this explorer asked for"):
        other.tell(trial, [0.0, 0.0])
    explorer.tell(trial, [0.0, 0.0])
    for _ in range(2000):
        other.ask()


@pytest.mark.parametrize("way", COPIES)
@pytest.mark.parametrize(
    "value",
    [
        ARM,
        ARM.motor_space,
        ARM.motor_space.bounds,
        db.explore(ARM, db.Adapt([db.MotorBabbling()]), 5, rng=0),
        *compositions().values(),
    ],
    ids=lambda value: type(value).__name__,
)
def test_what_a_task_is_made_of_can_be_copied(value, way):
    assert type(COPIES[way](value)) is type(value)


def test_a_history_written_to_by_hand_is_explored_on():
    explorer = db.Explorer(db.Adapt([db.MotorBabbling()]), ARM.motor_space, rng=0)
    explorer.history.append([0.0] * 5, [1.0, 0.0])
    trial = explorer.ask()
    explorer.tell(trial, [1.0, 0.0])
    diversities = explorer.result().diversities
    assert diversities.shape == (2, 1)
    assert (diversities != diversities).tolist() == [[True], [False]]  # noqa: PLR0124 - NaN


def test_the_dimension_is_checked_after_writing_by_hand():
    explorer = db.Explorer(db.Adapt([db.MotorBabbling()]), ARM.motor_space, rng=0)
    explorer.history.append([0.0] * 5, [1.0] * 33)
    trial = explorer.ask()
    with pytest.raises(ValueError, match="effects must be of a dimension that Adapt takes, got 33"):
        explorer.tell(trial, [1.0] * 33)
    assert len(explorer.history) == 1


def test_a_trial_that_was_changed_is_recorded_as_it_was_asked_for():
    explorer = db.Explorer(db.Mixture([db.MotorBabbling()]), ARM.motor_space, rng=0)
    trial = explorer.ask()
    command = trial.command
    trial.path, trial.command = (), [9.0] * 5
    explorer.tell(trial, [0.0, 0.0])
    assert explorer.history.paths == ((0,),)
    assert explorer.history.commands[0].tolist() == command.tolist()
