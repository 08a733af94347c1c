"""OptunaSampler does what a loop of Optuna's own does, and keeps quiet about it."""

import logging
from functools import partial

import numpy as np
import optuna
import pytest
from optuna.distributions import FloatDistribution
from optuna.trial import TrialState

import divbandit as db
from divbandit.adapters import OptunaSampler
from divbandit.bandits import Gain
from divbandit.strategies.base import Starter

ARM = db.PlanarArm(3)
TPE = partial(optuna.samplers.TPESampler, n_startup_trials=5)
GAIN = Gain(db.measures.BallCoverage(0.1))


@pytest.fixture
def quiet():
    """Keep the tests' own studies out of the log."""
    before = optuna.logging.get_verbosity()
    optuna.logging.set_verbosity(optuna.logging.WARNING)
    yield
    optuna.logging.set_verbosity(before)


@pytest.mark.parametrize("sampler", [TPE, optuna.samplers.CmaEsSampler])
@pytest.mark.usefixtures("quiet")
def test_equals_a_loop_of_optuna(sampler):
    seed = int(np.random.default_rng(7).random() * 2**32)
    study = optuna.create_study(sampler=sampler(seed=seed), direction="maximize")
    space, cover = ARM.motor_space, db.Coverage(0.1)
    ranges = {f"x{i}": FloatDistribution(space.low[i], space.high[i]) for i in range(3)}
    commands = []
    for _ in range(60):
        trial = study.ask(ranges)
        commands.append([trial.params[name] for name in ranges])
        study.tell(trial, cover.add(ARM(commands[-1])))
    run = db.explore(ARM, OptunaSampler(sampler, reward=GAIN), n=60, rng=7)
    assert run.commands.tolist() == commands


def test_optimises_what_it_is_given():
    """It finds the arm's end to the right, which gains alone would not hold it at."""
    right = OptunaSampler(TPE, reward=lambda effect, _: float(effect[0]))
    run = db.explore(ARM, right, n=120, rng=0)
    assert run.effects[-40:, 0].mean() > 0.75


def test_the_reward_sees_its_effect_as_the_newest():
    seen = []

    def reward(effect, history):
        seen.append((len(history), bool((history.effects[-1] == effect).all())))
        return 0.0

    explorer = db.Explorer(OptunaSampler(reward=reward), ARM.motor_space, rng=0)
    trials = explorer.ask(4)
    explorer.tell(trials, [ARM(trial.command) for trial in trials])
    assert seen == [(1, True), (2, True), (3, True), (4, True)]


def test_gains_count_what_others_covered():
    mixture = db.Mixture([OptunaSampler(TPE, reward=GAIN), db.MotorBabbling()])
    explorer = db.Explorer(mixture, ARM.motor_space, rng=0)
    for _ in range(60):
        trial = explorer.ask()
        explorer.tell(trial, ARM(trial.command))
    gains = db.Coverage(0.1).extend(explorer.history.effects)
    own = [path == (0,) for path in explorer.history.paths]
    told = [trial.value for trial in explorer.strategy.strategies[0].study.trials]
    assert told == gains[own].tolist()


def test_trials_that_fail_or_are_under_way():
    explorer = db.Explorer(OptunaSampler(TPE), ARM.motor_space, rng=0)
    trials = [explorer.ask() for _ in range(3)]
    explorer.fail(trials[1], "no power")
    explorer.tell(trials[2], ARM(trials[2].command))
    states = [trial.state for trial in explorer.strategy.study.trials]
    assert states == [TrialState.RUNNING, TrialState.FAIL, TrialState.COMPLETE]
    for step in range(30):
        trial = explorer.ask()
        if step % 2:
            explorer.fail(trial, "no power")
        else:
            explorer.tell(trial, ARM(trial.command))
    assert len(explorer.history) == 16


def test_says_nothing_and_leaves_the_loudness_alone():
    records = []
    listener = logging.Handler()
    listener.emit = records.append
    logger = logging.getLogger("optuna")
    before = optuna.logging.get_verbosity()
    logger.addHandler(listener)
    optuna.logging.set_verbosity(optuna.logging.INFO)
    try:
        db.explore(ARM, OptunaSampler(), n=3, rng=0)
        assert optuna.logging.get_verbosity() == optuna.logging.INFO
    finally:
        optuna.logging.set_verbosity(before)
        logger.removeHandler(listener)
    assert records == []


def test_a_users_reward_is_copied_for_each_exploration():
    class Counting:
        rewarded = 0

        def largest(self, dim):
            return 0.0 * dim

        def start(self, dim):
            del dim
            return self

        def of(self, trial, effect, history):
            self.rewarded += 1
            assert self.rewarded == len(history)
            assert trial.command
            return float(effect[0])

    reward = Counting()
    for _ in range(2):
        db.explore(ARM, OptunaSampler(reward=reward), n=5, rng=0)
    assert reward.rewarded == 0


def test_one_draw_and_no_more():
    rng, other = np.random.default_rng(5), np.random.default_rng(5)
    history = db.History(ARM.motor_space)
    running = Starter(history)(OptunaSampler())
    for _ in range(10):
        running.propose(history, rng)
    other.random()
    assert rng.random() == other.random()


@pytest.mark.parametrize(
    ("arguments", "error", "words"),
    [
        ({"sampler": "tpe"}, TypeError, "sampler must be callable, got str"),
        ({"reward": 3}, TypeError, "reward must be a Reward, such as Gain.*, got int"),
        ({"reward": Gain}, TypeError, "reward must be .* got the class Gain"),
    ],
)
def test_refuses(arguments, error, words):
    with pytest.raises(error, match=words):
        OptunaSampler(**arguments)


def test_refuses_what_it_cannot_measure():
    with pytest.raises(ValueError, match="40"):
        db.Explorer(OptunaSampler(), db.Box([0], [1]), db.Box([0] * 40, [1] * 40))
    bad = OptunaSampler(reward=lambda *_: float("nan"))
    with pytest.raises(ValueError, match="reward must be a finite number"):
        db.explore(ARM, bad, n=1, rng=0)


def test_refuses_trials_of_others():
    strategy = Starter(db.History(ARM.motor_space))(OptunaSampler())
    with pytest.raises(ValueError, match="trial must be one that this strategy proposed"):
        strategy.observe(db.Trial([0.0] * 3), np.zeros(2))
    with pytest.raises(ValueError, match="trial must be one that this strategy proposed"):
        strategy.fail(db.Trial([0.0] * 3), "no power")
