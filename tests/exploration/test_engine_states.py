"""The engine's states: refused, called back while it runs, and what is left without commands."""

import functools
import math
from typing import Any

import numpy as np
import pytest
from numpy.testing import assert_array_equal

import divbandit as db
from divbandit._core import Bounds, Engine, Journal, Reward
from divbandit._core import History as Log
from divbandit.bandits import CompetenceProgress, Gain
from divbandit.exploration.replay import RUN, events_of
from divbandit.measures import GridCoverage

BOX = db.Box([0.0], [1.0])
PLANE = db.FunctionEnvironment(lambda command: [command[0], 2.0], motor_space=BOX)


@pytest.mark.parametrize("n", [1, 70])
def test_without_commands_and_sensory_space_the_effects_are_kept(n: int) -> None:
    whole = db.explore(PLANE, db.MotorBabbling(), n=n, rng=0)
    run = db.explore(PLANE, db.MotorBabbling(), n=n, rng=0, keep_commands=False)
    assert_array_equal(run.effects, whole.effects, strict=True)


def test_paths_under_way_do_not_widen_those_that_were_told() -> None:
    inner = db.Mixture([db.MotorBabbling(), db.MotorBabbling()])
    strategy = db.Schedule([(1, db.MotorBabbling()), (None, inner)])
    shapes = []
    for engine in ("rust", "python"):
        explorer = db.Explorer(strategy, db.Box([0], [1]), rng=0, engine=engine)
        trial, _, failed = explorer.ask(3)
        explorer.tell(trial, [1.0])
        explorer.fail(failed, "fell over")
        shapes.append(explorer.result().paths.shape)
    assert shapes == [(1, 1), (1, 1)]


def begun() -> tuple[Any, Any]:
    log = Log(Bounds([0.0], [1.0]), None)
    return Engine(db.MotorBabbling(), log), (log, Journal())


def test_an_environment_cannot_ask_or_tell_the_engine_that_calls_it() -> None:
    rng = np.random.default_rng(0)
    calls = [
        lambda engine, _, both: engine.ask(*both, rng),
        lambda engine, trial, both: engine.tell(trial, [1.0], *both),
        lambda engine, trial, both: engine.fail(trial, "", *both),
        lambda engine, _, both: engine.run(PLANE, 1, math.inf, *both, rng),
    ]
    for call in calls:
        engine, (log, journal) = begun()
        other = engine.ask(log, journal, rng)
        calling = functools.partial(call, engine, other, (log, journal))
        environment = db.FunctionEnvironment(lambda _, c=calling: c(), motor_space=BOX)
        with pytest.raises(RuntimeError, match="must not be asked or told while it runs"):
            engine.run(environment, 1, math.inf, log, journal, rng)
        # The trial is under way, and all goes on.
        assert (journal.asked, len(log)) == (2, 0)
        engine.tell(journal.open[1], [1.0, 2.0], log, journal)
        engine.run(PLANE, 2, math.inf, log, journal, rng)
        assert (journal.asked, len(log)) == (4, 3)


def test_an_effect_that_is_refused_leaves_its_trial_under_way() -> None:
    log = Log(Bounds([0.0], [1.0]), None)
    measure = GridCoverage((0.1, 0.1))
    bandit = db.bandits.ucb1([db.MotorBabbling()], reward=Gain(measure))
    engine, journal = Engine(bandit, log), Journal()
    trial = engine.ask(log, journal, np.random.default_rng(0))
    for wrong in ([1.0], [np.nan, 0.0], []):
        with pytest.raises(ValueError, match=r"cell|finite|empty"):
            engine.tell(trial, wrong, log, journal)
        assert len(log) == 0
    engine.tell(trial, [1.0, 2.0], log, journal)
    assert (len(log), engine.estimates) == (1, (1.0,))


@pytest.mark.parametrize("reward", [Gain(GridCoverage(0.1)), CompetenceProgress()], ids=repr)
def test_a_reward_refuses_a_history_that_is_not_its_own(reward: Any) -> None:
    trial = db.Trial([0.5], goal=[0.0, 0.0])
    history = db.History(db.Box([0], [1]), db.Box([0, 0], [1, 1]))
    running = Reward(reward, 2)
    with pytest.raises(ValueError, match="history must not be empty"):
        running.of(trial, [0.0, 0.0], history)
    line = db.History(db.Box([0], [1]))
    line.append([0.5], [0.5])
    with pytest.raises(ValueError, match="effect must have length 2, got 1"):
        running.of(db.Trial([0.5]), [0.5], line)


def test_rows_beyond_the_log_are_none() -> None:
    _, (log, _) = begun()
    log.record([0.5], [1.0, 2.0], (), None)
    for first in (1, 2**62, 2**64 - 1):
        assert log.effects_from(first).shape == (0, 2)
        assert log.paths_from(first) == []


def test_estimates_of_another_number_are_refused() -> None:
    log = Log(Bounds([0.0], [1.0]), None)
    log.begin(keeps_commands=True, width=2)
    with pytest.raises(ValueError, match="estimates must have length 2, got 1"):
        log.record([0.5], [1.0], (0,), [0.5])
    assert len(log) == 0


def test_engines_agree_where_a_nested_bandit_cannot_reward() -> None:
    """Neither bandit learns from the effect, which the inner one could reward."""
    fine = Gain(GridCoverage(1e-3))
    coarse = Gain(GridCoverage(1.0))
    effects = iter([0.0, 1e307] * 2)
    environment = db.FunctionEnvironment(
        lambda _: [next(effects)], motor_space=BOX, sensory_space=BOX
    )
    for rewards in ((fine, coarse), (coarse, fine)):
        found = []
        for engine in ("rust", "python"):
            effects = iter([0.0, 1e307])
            inner = db.bandits.ucb1([db.MotorBabbling()], reward=rewards[0])
            outer = db.bandits.ucb1([inner], reward=rewards[1])
            with pytest.raises(ValueError, match="effect") as raised:
                db.explore(environment, outer, n=2, rng=0, engine=engine)
            explorer = raised.value.explorer  # type: ignore[attr-defined]
            found.append((len(explorer.history), explorer.estimates))
        assert found == [(2, (1.0,))] * 2


def test_only_an_effect_that_was_recorded_and_not_rewarded_is_refused() -> None:
    """An explorer notes in its journal that the newest effect raised: it must be that one."""
    rng = np.random.default_rng(0)
    # Nothing is recorded: the arm does not take commands of the history's motor space.
    engine, (log, journal) = begun()
    with pytest.raises(ValueError, match="motor_space must have length 3, got 1"):
        engine.run(db.PlanarArm(3), 5, math.inf, log, journal, rng)
    assert (len(log), journal.size) == (0, 0)
    # The first effect is recorded, and lies too many cells away to be rewarded.
    arm = db.PlanarArm(3)
    log = Log(arm.motor_space.bounds, None)
    far = db.bandits.Gain(db.measures.GridCoverage(1e-9, origin=1e300))
    engine, journal = Engine(db.bandits.ucb1([db.MotorBabbling()], reward=far), log), Journal()
    log.begin(keeps_commands=True, width=1)
    with pytest.raises(ValueError, match=r"within 1\.7e308 cells"):
        engine.run(arm, 5, math.inf, log, journal, rng)
    assert (len(log), list(events_of(journal.events(0)))) == (1, [(RUN, 1, "raised")])
    # Again nothing is recorded.
    with pytest.raises(ValueError, match="motor_space must have length 2, got 3"):
        engine.run(db.PlanarArm(2), 5, math.inf, log, journal, rng)
    assert (len(log), journal.size) == (1, 1)
