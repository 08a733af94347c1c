"""The engine over an environment in Python: what is raised passes on, and nothing is lost."""

import threading

import numpy as np
import pytest

import divbandit as db
from tests.exploration.sameness import differences, everything
from tests.generators import state, twins

ARM = db.PlanarArm(4)
ENGINES = ("rust", "python")
ADAPT = db.Adapt([db.MotorBabbling(), db.GoalBabbling(0.05)], tau=0.1)


class BrokenError(Exception):
    """The black box broke."""


def breaking(at, error=BrokenError, goals=ARM.sensory_space):
    """Return an environment, the arm, whose call number `at` raises."""
    calls = []

    def black_box(command):
        calls.append(1)
        if len(calls) == at:
            raise error(f"call {at}")
        return ARM(command)

    return db.FunctionEnvironment(black_box, ARM.motor_space, goals)


def broken(engine, at, error=BrokenError, strategy=ADAPT, goals=ARM.sensory_space, **options):
    """Return the explorer that such an environment leaves behind."""
    environment = breaking(at, error, goals)
    # A black box that exits does not end the program in silence.
    raised = RuntimeError if error is SystemExit else error
    with pytest.raises(raised, match=f"call {at}") as caught:
        db.explore(environment, strategy, 60, rng=0, engine=engine, **options)
    return caught.value.explorer


@pytest.mark.parametrize("error", [BrokenError, OSError, KeyboardInterrupt, SystemExit])
@pytest.mark.parametrize("at", [1, 2, 31])
@pytest.mark.parametrize("engine", ENGINES)
def test_all_that_was_observed_is_there_and_the_trial_is_open(engine, at, error):
    explorer = broken(engine, at, error)
    plain = db.explore(ARM, ADAPT, 60, rng=0)
    assert len(explorer.history) == at - 1
    assert explorer.history.effects.tolist() == plain.effects[: at - 1].tolist()
    (trial,) = explorer.open_trials
    assert trial.number == at - 1
    assert trial.command.tolist() == plain.commands[at - 1].tolist()
    assert everything(explorer) == everything(broken("python", at, error))


@pytest.mark.parametrize("goals", [ARM.sensory_space, None], ids=["goals", "no goals"])
@pytest.mark.parametrize("at", [1, 2, 31])
@pytest.mark.parametrize("engine", ENGINES)
def test_it_is_told_saved_and_gone_on_with_as_if_nothing_had_happened(engine, at, goals, tmp_path):
    strategy = db.Adapt([db.MotorBabbling(), db.GoalBabbling(goals=ARM.sensory_space)])
    explorer = broken(engine, at, strategy=strategy, goals=goals)
    explorer.save(tmp_path / "run")
    again = db.Explorer.load(tmp_path / "run")
    assert everything(again) == everything(explorer)
    environment = db.FunctionEnvironment(ARM, ARM.motor_space, goals)
    plain = db.explore(environment, strategy, 60, rng=0)
    for each in (explorer, again):
        (trial,) = each.open_trials
        each.tell(trial, ARM(trial.command))
        for _ in range(60 - at):
            trial = each.ask()
            each.tell(trial, ARM(trial.command))
        assert differences(each.result(), plain) == []


@pytest.mark.parametrize("engine", ENGINES)
def test_the_open_trial_can_have_failed(engine, tmp_path):
    explorer = broken(engine, 5)
    explorer.fail(explorer.open_trials[0], "it broke")
    trial = explorer.ask()
    explorer.tell(trial, ARM(trial.command))
    assert (len(explorer.history), len(explorer.history.failures)) == (5, 1)
    explorer.save(tmp_path / "run")
    assert everything(db.Explorer.load(tmp_path / "run")) == everything(explorer)


@pytest.mark.parametrize("strategy", [ADAPT, db.MotorBabbling()], ids=["adapt", "motor"])
@pytest.mark.parametrize("engine", ENGINES)
def test_without_commands_it_is_gone_on_with(engine, strategy):
    explorer = broken(engine, 31, strategy=strategy, keep_commands=False)
    trial = explorer.open_trials[0]
    explorer.tell(trial, ARM(trial.command))
    plain = db.explore(ARM, strategy, 31, rng=0)
    assert explorer.result().effects.tolist() == plain.effects.tolist()


def test_commands_that_were_not_kept_are_missed_by_name(tmp_path):
    """The engine forgets what no strategy looks at."""
    explorer = broken("rust", 31, strategy=db.MotorBabbling(), keep_commands=False)
    with pytest.raises(AttributeError, match="commands were not kept"):
        _ = explorer.history.commands
    assert not hasattr(explorer.result(), "commands")
    with pytest.raises(ValueError, match="commands must have been kept to be saved"):
        explorer.save(tmp_path / "run")
    assert list(tmp_path.iterdir()) == []


def test_it_may_draw_from_the_same_generator():
    rngs = twins(np.random.PCG64)
    runs = []
    for engine, rng in zip(ENGINES, rngs, strict=True):

        def noisy(command, rng=rng):
            return ARM(command) + 0.01 * rng.normal(size=2)

        environment = db.FunctionEnvironment(noisy, ARM.motor_space, ARM.sensory_space)
        runs.append(db.explore(environment, ADAPT, 200, rng=rng, engine=engine))
    assert differences(*runs) == []
    assert state(rngs[0]) == state(rngs[1])


def test_the_generator_is_free_for_other_threads_meanwhile():
    rng, drawn = np.random.default_rng(0), []

    def black_box(command):
        thread = threading.Thread(target=lambda: drawn.append(rng.random()))
        thread.start()
        thread.join(timeout=10)
        assert not thread.is_alive()
        return ARM(command)

    environment = db.FunctionEnvironment(black_box, ARM.motor_space, ARM.sensory_space)
    db.explore(environment, ADAPT, 20, rng=rng, engine="rust")
    assert len(drawn) == 20


@pytest.mark.parametrize("engine", ENGINES)
def test_it_may_look_at_the_history(engine):
    """All that was told before is there, and what it shows stays."""
    explorer = db.Explorer(ADAPT, ARM.motor_space, ARM.sensory_space, rng=0, engine=engine)
    seen = []

    def looking(command):
        history = explorer.history
        seen.append((len(history), history.effects, history.commands, history.paths))
        if len(history):
            history.nearest([0.5, 0.5])
            assert len(explorer.result()) == len(history)
        return ARM(command)

    environment = db.FunctionEnvironment(looking, ARM.motor_space, ARM.sensory_space)
    explorer.run(environment, 40)
    run = explorer.result()
    assert differences(run, db.explore(ARM, ADAPT, 40, rng=0)) == []
    for known, (length, effects, commands, paths) in enumerate(seen):
        assert length == len(paths) == known
        assert effects.tolist() == run.effects[:known].tolist()
        assert commands.tolist() == run.commands[:known].tolist()


@pytest.mark.parametrize("engine", ENGINES)
def test_it_is_called_once_a_step_with_a_command_that_it_cannot_change(engine):
    commands = []

    def keeping(command):
        with pytest.raises(ValueError, match="read-only"):
            command[0] = 0.0
        commands.append(command)
        return ARM(command)

    environment = db.FunctionEnvironment(keeping, ARM.motor_space, ARM.sensory_space)
    run = db.explore(environment, ADAPT, 30, rng=0, engine=engine)
    assert np.array_equal(commands, run.commands)


@pytest.mark.parametrize("engine", ENGINES)
def test_one_array_for_all_effects_is_read_each_time(engine):
    effect = np.empty(2)

    def black_box(command):
        effect[:] = ARM(command)
        return effect

    environment = db.FunctionEnvironment(black_box, ARM.motor_space, ARM.sensory_space)
    run = db.explore(environment, ADAPT, 30, rng=0, engine=engine)
    assert differences(run, db.explore(ARM, ADAPT, 30, rng=0)) == []


@pytest.mark.parametrize("engine", ENGINES)
def test_it_may_explore_itself(engine):
    def inner(command):
        arm = db.FunctionEnvironment(ARM, ARM.motor_space, ARM.sensory_space)
        run = db.explore(arm, ADAPT, 3, rng=int(1e6 * abs(command[0])), engine=engine)
        return run.effects[-1]

    environment = db.FunctionEnvironment(inner, ARM.motor_space, ARM.sensory_space)
    run = db.explore(environment, ADAPT, 20, rng=0, engine=engine)
    assert run.effects.tolist() == [inner(command).tolist() for command in run.commands]


@pytest.mark.parametrize("goals", [ARM.sensory_space, None], ids=["goals", "no goals"])
@pytest.mark.parametrize("engine", ENGINES)
def test_what_a_callback_raises_ends_it_after_a_step(engine, goals):
    environment = db.FunctionEnvironment(ARM, ARM.motor_space, goals)
    calls = []

    def callback(explorer, trial):
        calls.append(trial.command.tolist())
        assert calls == explorer.history.commands.tolist()
        if len(calls) == 7:
            raise TimeoutError

    with pytest.raises(TimeoutError) as caught:
        db.explore(environment, db.MotorBabbling(), 60, rng=0, engine=engine, callbacks=[callback])
    explorer = caught.value.explorer
    assert (len(explorer.history), explorer.open_trials) == (7, ())
