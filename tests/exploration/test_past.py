"""Evaluations that were made before: added through the explorer, seen by all, rewarded to none."""

import numpy as np
import pytest

import divbandit as db
from tests.exploration.sameness import everything

ARM = db.PlanarArm(4)
ADAPT = db.Adapt([db.MotorBabbling(), db.GoalBabbling()], tau=0.1)
EARLIER = db.explore(ARM, db.MotorBabbling(), n=30, rng=9)
ENGINES = ("rust", "python")


def new_explorer(strategy=ADAPT, goals=ARM.sensory_space, **options):
    return db.Explorer(strategy, ARM.motor_space, goals, rng=0, **options)


def go_on(explorer, steps=20):
    for _ in range(steps):
        trial = explorer.ask()
        explorer.tell(trial, ARM(trial.command))
    return explorer


@pytest.mark.parametrize("engine", ENGINES)
def test_an_earlier_run_comes_first(engine):
    explorer = new_explorer(past=EARLIER, engine=engine)
    run = explorer.result()
    assert run.commands.tobytes() == EARLIER.commands.tobytes()
    assert run.effects.tobytes() == EARLIER.effects.tobytes()
    assert run.paths.shape == (30, 0)
    assert np.isnan(run.estimates).all()
    added = new_explorer(engine=engine)
    added.add_past(EARLIER.commands, EARLIER.effects)
    assert everything(go_on(added)) == everything(go_on(explorer))
    assert explorer.result().paths.shape == (50, 1)
    assert not np.isnan(explorer.result().estimates[30:]).any()


@pytest.mark.parametrize("engine", ENGINES)
def test_strategies_see_it(engine):
    explorer = new_explorer(db.GoalBabbling(0.0), past=EARLIER, engine=engine)
    trial = explorer.ask()
    _, index = explorer.history.nearest(trial.goal)
    assert trial.command.tolist() == EARLIER.commands[index].tolist()


@pytest.mark.parametrize("engine", ENGINES)
def test_no_strategy_is_rewarded_for_it_and_no_effect_is_new_twice(engine):
    explorer = new_explorer(past=EARLIER, engine=engine)
    assert explorer.estimates == new_explorer(engine=engine).estimates
    trial = explorer.ask()
    explorer.tell(trial, EARLIER.effects[3])  # covered already
    disc = max(new_explorer().estimates)
    assert sorted(explorer.estimates) == pytest.approx([disc / 2, disc])


@pytest.mark.parametrize("engine", ENGINES)
def test_it_tells_the_dimension(engine):
    explorer = new_explorer(db.Adapt([db.MotorBabbling()]), None, engine=engine)
    explorer.add_past([[0.0] * 4], [[1.0, 2.0, 3.0]])
    assert explorer.history.effect_dim == 3
    with pytest.raises(ValueError, match="effect must have shape"):
        explorer.tell(explorer.ask(), [1.0, 2.0])
    explorer.tell(explorer.open_trials[0], [1.0, 2.0, 3.0])
    assert explorer.result().estimates.shape == (2, 1)


def test_one_that_the_strategy_cannot_use_is_refused():
    explorer = new_explorer(db.Adapt([db.MotorBabbling()]), None)
    with pytest.raises(ValueError, match="effects must be of a dimension that Adapt takes, got 33"):
        explorer.add_past([[0.0] * 4], [[1.0] * 33])
    assert len(explorer.history) == 0
    assert explorer.history.effect_dim is None


@pytest.mark.parametrize("engine", ENGINES)
def test_saved_and_loaded(engine, tmp_path):
    """Added at the beginning, on the way, with trials under way, and at the end."""
    explorer = go_on(new_explorer(past=EARLIER, engine=engine), 3)
    trials = explorer.ask(3)
    explorer.tell(trials[1], [0.5, 0.5])
    explorer.add_past(EARLIER.commands[:7], EARLIER.effects[:7])
    explorer.fail(trials[2], "fell over")
    go_on(explorer, 5)
    explorer.add_past(EARLIER.commands[7:8], EARLIER.effects[7:8])
    explorer.add_past(np.empty((0, 4)), np.empty((0, 2)))
    explorer.save(tmp_path / "run")
    again = db.Explorer.load(tmp_path / "run")
    assert everything(again) == everything(explorer)
    assert everything(go_on(again)) == everything(go_on(explorer))


BAD = {
    "one command too few": ([[0.0] * 4], [[0.0, 0.0]] * 2),
    "no row": ([0.0] * 4, [0.0, 0.0]),
    "outside": ([[0.0] * 4, [9.0] * 4], [[0.0, 0.0]] * 2),
    "not finite": ([[0.0] * 4] * 2, [[0.0, 0.0], [0.0, np.nan]]),
    "three coordinates": ([[0.0] * 4], [[0.0] * 3]),
    "a short command": ([[0.0] * 3], [[0.0] * 2]),
    "text": ("ab", "cd"),
    "nothing": (None, None),
}


@pytest.mark.parametrize("bad", BAD.values(), ids=BAD)
@pytest.mark.parametrize("engine", ENGINES)
def test_what_is_refused_leaves_no_trace(bad, engine):
    explorer = go_on(new_explorer(engine=engine), 5)
    before = everything(explorer)
    with pytest.raises((TypeError, ValueError), match=r"^(row 1 of )?(commands?|effects?)"):
        explorer.add_past(*bad)
    assert everything(explorer) == before


@pytest.mark.parametrize("past", [7, EARLIER.effects, db.MotorBabbling()], ids=type)
def test_no_earlier_run(past):
    with pytest.raises(TypeError, match="past must be an Exploration or a tuple"):
        new_explorer(past=past)


def test_an_earlier_run_needs_its_commands():
    earlier = db.explore(ARM, db.MotorBabbling(), n=5, rng=0, keep_commands=False)
    with pytest.raises(AttributeError, match="commands were not kept"):
        new_explorer(past=earlier)


@pytest.mark.parametrize("engine", ENGINES)
def test_the_history_is_written_by_its_explorer(engine):
    explorer = go_on(new_explorer(engine=engine), 2)
    with pytest.raises(ValueError, match=r"explorer\.add_past"):
        explorer.history.append([0.0] * 4, [1.0, 0.0])
    assert len(explorer.history) == 2


def test_nothing_added_is_nothing(tmp_path):
    """It does not tell a dimension either."""
    explorer = new_explorer(db.MotorBabbling(), None)
    explorer.add_past(np.empty((0, 4)), np.empty((0, 3)))
    explorer.save(tmp_path / "run")
    assert db.Explorer.load(tmp_path / "run").history.effect_dim is None
    explorer.tell(explorer.ask(), [1.0, 2.0])
    assert explorer.history.effect_dim == 2
