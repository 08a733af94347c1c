"""RibsEmitter does what a loop of pyribs' own does; failures and surplus trials do no harm."""

from functools import partial

import numpy as np
import pytest
from ribs.archives import GridArchive, ProximityArchive
from ribs.emitters import EmitterBase, EvolutionStrategyEmitter, GaussianEmitter

import divbandit as db
from divbandit.adapters import RibsEmitter
from divbandit.strategies.base import Starter

ARM = db.PlanarArm(4)
#: Motor ranges of very different widths, one of them empty.
UNEVEN = db.FunctionEnvironment(
    lambda x: [x[0] / 10 + x[1], x[1] * x[2]],
    db.Box([-10, 0, 5], [10, 0.001, 5]),
    db.Box([-1, 0], [1, 0.005]),
)


def recording(archive, seed, log, *, ends=(0.0, 1.0), sigma0=0.2):
    """Return an evolution strategy that writes down what it learns, six at a time."""
    dim = archive.solution_dim
    emitter = EvolutionStrategyEmitter(
        archive, x0=[0.5] * dim, sigma0=sigma0, bounds=[ends] * dim, batch_size=6, seed=seed
    )
    emitter.__class__ = type("Recording", (EvolutionStrategyEmitter,), {"tell": partial_tell(log)})
    return emitter


def partial_tell(log):
    def tell(self, solution, objective, measures, add_info, **fields):
        told = {key: np.array(value) for key, value in add_info.items()}
        log.append((np.array(solution), np.array(objective), np.array(measures), told))
        EvolutionStrategyEmitter.tell(self, solution, objective, measures, add_info, **fields)

    return tell


class Shared(list):
    """A log that copies share."""

    def __deepcopy__(self, memo):
        return self


def explorer_and_log(environment=ARM, **options):
    log = Shared()
    strategy = RibsEmitter(partial(recording, log=log), **options)
    return db.Explorer(strategy, environment.motor_space, environment.sensory_space, rng=0), log


def by_hand(environment, n, seeds, cells, objective=None):
    """Do what pyribs' scheduler does, adding one by one; return the solutions and the archive."""
    space, goals = environment.motor_space, environment.sensory_space
    ranges = list(zip(goals.low, goals.high, strict=True))
    archive = GridArchive(
        solution_dim=space.dim, dims=[cells] * goals.dim, ranges=ranges, seed=seeds[0]
    )
    emitter = recording(archive, seeds[1], [])
    tried = []
    while len(tried) < n:
        solutions = emitter.ask()
        infos, effects, objectives = [], [], []
        for solution in solutions:
            command = space.low + solution * (space.high - space.low)
            effect = environment(command)
            value = 0.0 if objective is None else objective(effect, command)
            infos.append(archive.add_single(solution, value, effect))
            tried.append(command)
            effects.append(effect)
            objectives.append(value)
        info = {key: np.array([each[key] for each in infos]) for key in infos[0]}
        emitter.tell(solutions, objectives, effects, info)
    return np.array(tried[:n]), archive


@pytest.mark.parametrize("environment", [ARM, UNEVEN], ids=["arm", "uneven"])
@pytest.mark.parametrize("objective", [None, lambda effect, command: effect[0] - abs(command[0])])
def test_equals_a_loop_of_pyribs(environment, objective):
    rng = np.random.default_rng(7)
    seeds = [int(rng.random() * 2**32) for _ in range(2)]
    expected, archive = by_hand(environment, 240, seeds, 30, objective)
    strategy = RibsEmitter(partial(recording, log=[]), cells=30, objective=objective)
    explorer = db.Explorer(strategy, environment.motor_space, environment.sensory_space, rng=7)
    for _ in range(240):
        trial = explorer.ask()
        explorer.tell(trial, environment(trial.command))
    np.testing.assert_allclose(explorer.history.commands, expected, rtol=0, atol=1e-12)
    explorer.ask()  # brings the archive up to date
    kept = explorer.strategy.emitter.archive
    assert len(kept) == len(archive) > 10
    assert kept.stats.qd_score == pytest.approx(archive.stats.qd_score)


def test_is_told_in_the_order_of_its_solutions_whatever_comes_first():
    explorer, log = explorer_and_log()
    trials = [explorer.ask() for _ in range(6)]
    for trial in trials[::-1]:
        explorer.tell(trial, ARM(trial.command))
    assert log == []
    explorer.ask()
    solution, _, measures, told = log[0]
    space = ARM.motor_space
    asked = np.array([trial.command for trial in trials])
    np.testing.assert_allclose(space.low + solution * (space.high - space.low), asked)
    np.testing.assert_allclose(measures, [ARM(command) for command in asked])
    assert told["status"][-1] == 2  # the first that came was new, the last of the batch
    assert set(told["status"]) <= {0, 1, 2}


def test_a_failed_trial_stands_for_the_worst_of_its_batch():
    explorer, log = explorer_and_log(objective=lambda effect, _: float(effect[0]), cells=2)
    trials = [explorer.ask() for _ in range(6)]
    explorer.fail(trials[2], "fell over")
    effects = [[0.9, 0.9], [0.8, 0.9], None, [0.1, 0.9], [-0.5, -0.5], [0.95, 0.9]]
    for trial, effect in zip(trials, effects, strict=True):
        if effect is not None:
            explorer.tell(trial, effect)
    explorer.ask()
    _, objective, measures, told = log[0]
    # Worst are those that did not enter; of them, the one farthest below its cell's elite.
    assert told["status"].tolist() == [2, 0, 0, 0, 2, 1]
    assert objective.tolist() == [0.9, 0.8, 0.1, 0.1, -0.5, 0.95]
    assert measures[2].tolist() == [0.1, 0.9]
    assert told["value"][2] == told["value"][3] == pytest.approx(-0.8)


def test_a_failed_trial_has_not_entered_the_archive_where_all_others_have():
    explorer, log = explorer_and_log()
    trials = [explorer.ask() for _ in range(6)]
    for step, trial in enumerate(trials[:5]):
        explorer.tell(trial, [step / 5, 0.5])
    explorer.fail(trials[5], "no power")
    explorer.ask()
    assert log[0][3]["status"].tolist() == [2, 2, 2, 2, 2, 0]


def test_a_batch_that_failed_as_a_whole_is_forgotten():
    explorer, log = explorer_and_log()
    for _ in range(20):
        explorer.fail(explorer.ask(), "no power")
    trials = [explorer.ask() for _ in range(4)]  # the rest of a batch that began with failures
    for trial in trials:
        explorer.tell(trial, ARM(trial.command))
    explorer.ask()
    assert len(log) == 1
    assert len(log[0][0]) == 6


def test_more_than_a_batch_under_way():
    """Surplus trials are new commands, enter the archive, and leave the batch as it was."""
    explorer, log = explorer_and_log()
    trials = [explorer.ask() for _ in range(20)]
    commands = np.array([trial.command for trial in trials])
    assert len(np.unique(commands, axis=0)) == 20
    for trial in trials:
        explorer.tell(trial, ARM(trial.command))
    explorer.ask()
    assert len(log) == 1
    space = ARM.motor_space
    np.testing.assert_allclose(space.low + log[0][0] * (space.high - space.low), commands[:6])
    whole = GridArchive(solution_dim=4, dims=[20, 20], ranges=[(-1, 1), (-1, 1)])
    whole.add(np.zeros((20, 4)), np.zeros(20), ARM(commands))
    assert len(explorer.strategy.emitter.archive) == len(whole)
    later = np.array([explorer.ask().command for _ in range(5)])
    assert len(np.unique(np.vstack([commands, later]), axis=0)) == 25


class Counting(EmitterBase):
    """Asks for one solution: how many it has asked for, how many elites there are."""

    def __init__(self, archive):
        super().__init__(archive, solution_dim=4, bounds=None, lower_bounds=None, upper_bounds=None)
        self.asked = 0

    def ask(self):
        self.asked += 1
        return np.array([[self.asked / 100, len(self.archive) / 100, 0, 0]])

    def tell(self, solution, objective, measures, add_info, **fields):
        """Say that it learns."""


def test_surplus_trials_go_on_where_the_batch_ended_and_see_the_archive():
    strategy = RibsEmitter(lambda archive, _: Counting(archive))
    unit = db.Box([0] * 4, [1] * 4)
    explorer = db.Explorer(strategy, unit, db.Box([0, 0], [1, 1]), rng=0)

    def ask():
        trial = explorer.ask()
        return trial, (trial.command[:2] * 100).round().astype(int).tolist()

    first, seen = ask()
    assert seen == [1, 0]
    second, seen = ask()
    assert seen == [2, 0]
    explorer.tell(second, [0.1, 0.1])
    third, seen = ask()
    assert seen == [3, 1]
    explorer.tell(first, [0.9, 0.9])
    explorer.tell(third, [0.1, 0.9])
    assert ask()[1] == [4, 3]


def test_a_steady_number_under_way():
    """As with an executor: the emitter goes on learning."""
    explorer, log = explorer_and_log()
    open_trials = [explorer.ask() for _ in range(4)]
    for step in range(300):
        trial = open_trials.pop(step % 4)
        explorer.tell(trial, ARM(trial.command))
        open_trials.append(explorer.ask())
    assert len(log) > 20
    assert all(len(solution) == 6 for solution, *_ in log)


def test_the_archive_holds_what_others_found():
    mixture = db.Mixture([RibsEmitter("evolution", cells=10), db.MotorBabbling()])
    explorer = db.Explorer(mixture, ARM.motor_space, ARM.sensory_space, rng=1)
    for _ in range(100):
        trial = explorer.ask()
        explorer.tell(trial, ARM(trial.command))
    emitter = explorer.strategy.strategies[0]
    emitter.propose(explorer.history, explorer.rng)
    whole = GridArchive(solution_dim=4, dims=[10, 10], ranges=[(-1, 1), (-1, 1)])
    whole.add(explorer.history.commands, np.zeros(100), explorer.history.effects)
    kept = emitter.emitter.archive
    assert len(kept) == len(whole)
    space = ARM.motor_space
    commands = space.low + kept.data("solution") * (space.high - space.low)
    np.testing.assert_allclose(ARM(commands), kept.data("measures"), atol=1e-9)


def test_another_archive_and_another_emitter():
    def archive(dim, seed):
        return ProximityArchive(
            solution_dim=dim, measure_dim=2, k_neighbors=3, novelty_threshold=0.02, seed=seed
        )

    def emitter(archive, seed):
        return EvolutionStrategyEmitter(
            archive, x0=[0.5] * 4, sigma0=0.3, ranker="nov", batch_size=8, seed=seed
        )

    strategy = RibsEmitter(emitter, archive=archive)
    run = db.explore(db.FunctionEnvironment(ARM, ARM.motor_space), strategy, n=100, rng=0)
    assert run.effects.shape == (100, 2)


def test_what_leaves_the_motor_space_is_clipped():
    wild = RibsEmitter(
        lambda archive, seed: GaussianEmitter(archive, sigma=5.0, x0=[0.5] * 4, seed=seed)
    )
    explorer = db.Explorer(wild, ARM.motor_space, ARM.sensory_space, rng=0)
    for _ in range(70):
        trial = explorer.ask()
        explorer.tell(trial, ARM(trial.command))
    ends = np.isin(explorer.history.commands, [ARM.motor_space.low[0], ARM.motor_space.high[0]])
    assert ends.mean() > 0.5


def test_what_is_told_is_clipped_as_well():
    log = Shared()

    wild = partial(recording, log=log, ends=(-9.0, 9.0), sigma0=5.0)
    db.explore(ARM, RibsEmitter(wild), n=13, rng=0)
    assert all(0 <= solution.min() < solution.max() <= 1 for solution, *_ in log)
    assert len(log) == 2


def test_an_emitter_that_asks_for_nothing():
    nothing = RibsEmitter(
        lambda archive, _: EmitterBase(
            archive, solution_dim=4, bounds=None, lower_bounds=None, upper_bounds=None
        )
    )
    with pytest.raises(ValueError, match="emitter must ask for at least one solution, got none"):
        db.explore(ARM, nothing, n=1, rng=0)


def test_trials_of_others_are_passed_over():
    history = db.History(ARM.motor_space, ARM.sensory_space)
    running, other = (Starter(history)(RibsEmitter("evolution")) for _ in "ab")
    rng = np.random.default_rng(3)
    trials = [each.propose(history, rng) for each in (running, other)]
    history.append(trials[1].command, [0.0, 0.0])
    running.observe(trials[1], np.zeros(2))
    running.fail(trials[1], "late")
    assert len(running.emitter.archive) == 0
    running.propose(history, rng)
    assert len(running.emitter.archive) == 1


def test_two_draws_and_no_more():
    rng, other = np.random.default_rng(5), np.random.default_rng(5)
    history = db.History(ARM.motor_space, ARM.sensory_space)
    running = Starter(history)(RibsEmitter())
    for _ in range(40):
        running.propose(history, rng)
    other.random(2)
    assert rng.random() == other.random()


@pytest.mark.parametrize(
    ("arguments", "error", "words"),
    [
        ({"emitter": "lines"}, ValueError, "emitter must be one of 'evolution', 'line', got"),
        ({"emitter": 3}, TypeError, "emitter must be a name, or a function of an .*, got int"),
        (
            {"emitter": GaussianEmitter},
            TypeError,
            r"one, got the class GaussianEmitter: write lambda archive, seed: Gauss.*, seed=seed\)",
        ),
        ({"archive": GridArchive}, TypeError, "write lambda dim, seed: GridArchive"),
        ({"cells": 0}, ValueError, "cells must be at least 1, got 0"),
        ({"box": 3}, TypeError, "box must be a Box or have .low and .high, got int"),
        ({"archive": 3}, TypeError, "archive must be callable, got int"),
        ({"objective": 3}, TypeError, "objective must be callable, got int"),
        ({"archive": len, "cells": 3}, ValueError, "archive must not be given together with"),
    ],
)
def test_refuses(arguments, error, words):
    with pytest.raises(error, match=words):
        RibsEmitter(**arguments)


def test_takes_a_class_that_is_made_of_archive_and_seed():
    class Gaussian(GaussianEmitter):
        def __init__(self, archive, seed):
            super().__init__(archive, sigma=0.1, x0=[0.5] * 4, seed=seed)

    assert len(db.explore(ARM, RibsEmitter(Gaussian), n=3, rng=0)) == 3


def test_refuses_environments():
    with pytest.raises(ValueError, match="box must be given to RibsEmitter: there is no sensory"):
        db.Explorer(RibsEmitter(), ARM.motor_space)
    with pytest.raises(ValueError, match="box must have the dimension of the effects, 2, got 1"):
        db.explore(ARM, RibsEmitter(box=db.Box([0], [1])), n=1)


def test_refuses_an_objective_that_is_no_number():
    strategy = RibsEmitter(objective=lambda *_: float("nan"))
    with pytest.raises(ValueError, match=r"objective\(\) must be a finite number"):
        db.explore(ARM, strategy, n=2, rng=0)
