"""An explorer with adapters in it is saved and loaded, and goes on to the same bits."""

import pytest

import divbandit as db
from divbandit.adapters import OptunaSampler, RibsEmitter
from tests.compositions import adapted

ARM = db.PlanarArm(3)


def half_way(strategy):
    """Return an explorer with failures behind it, and open trials in the middle of a batch."""
    explorer = db.Explorer(strategy, ARM.motor_space, ARM.sensory_space, rng=0)
    for step in range(50):
        trial = explorer.ask()
        if step % 7 == 3:
            explorer.fail(trial, "no power")
        else:
            explorer.tell(trial, ARM(trial.command))
    trials = explorer.ask(9)
    explorer.tell(trials[2:5], [ARM(trial.command) for trial in trials[2:5]])
    return explorer


def go_on(explorer):
    for trial in explorer.open_trials[::-1]:
        explorer.tell(trial, ARM(trial.command))
    for _ in range(50):
        trial = explorer.ask()
        explorer.tell(trial, ARM(trial.command))
    return explorer.history.commands.tobytes()


@pytest.mark.parametrize("name", adapted())
def test_goes_on_to_the_same_bits(name, tmp_path):
    explorer = half_way(adapted()[name])
    explorer.save(tmp_path / "saved")
    again = db.Explorer.load(tmp_path / "saved", adapted()[name])
    assert go_on(again) == go_on(explorer)


def test_what_has_plain_arguments_is_in_the_file(tmp_path):
    strategy = db.Mixture([RibsEmitter("line", cells=7), OptunaSampler()])
    explorer = half_way(strategy)
    explorer.save(tmp_path / "saved")
    again = db.Explorer.load(tmp_path / "saved")
    assert go_on(again) == go_on(explorer)


@pytest.mark.parametrize(
    "name", ["bandit by a policy of MABWiser", "evolution, of Optuna", "adapt of other libraries"]
)
def test_what_belongs_to_another_library_must_be_given(name, tmp_path):
    half_way(adapted()[name]).save(tmp_path / "saved")
    with pytest.raises(ValueError, match="strategy must be given"):
        db.Explorer.load(tmp_path / "saved")
