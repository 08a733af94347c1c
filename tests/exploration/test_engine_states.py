"""The engine's states: refused, called back while it runs, and what is left without commands."""

import functools
from typing import Any

import numpy as np
import pytest
from numpy.testing import assert_array_equal

import divbandit as db
from divbandit._core import Bounds, Engine, Reward
from divbandit._core import History as Log
from divbandit.bandits import CompetenceProgress, Gain
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
    return Engine(db.MotorBabbling(), log), log


def test_an_environment_cannot_ask_or_tell_the_engine_that_calls_it() -> None:
    rng = np.random.default_rng(0)
    calls = [
        lambda engine, log: engine.ask(log, rng),
        lambda engine, log: engine.tell(0, log, [1.0]),
        lambda engine, _: engine.fail(0),
        lambda engine, log: engine.run(PLANE, log, 1, rng, None),
    ]
    for call in calls:
        engine, log = begun()
        calling = functools.partial(call, engine, log)
        environment = db.FunctionEnvironment(lambda _, c=calling: c(), motor_space=BOX)
        with pytest.raises(RuntimeError, match="must not be asked or told while it runs"):
            engine.run(environment, log, 1, rng, None)
        # The trial is under way, and all goes on.
        assert (engine.asked, len(log)) == (1, 0)
        engine.tell(0, log, [1.0, 2.0])
        engine.run(PLANE, log, 2, rng, None)
        assert (engine.asked, len(log)) == (3, 3)


def test_an_effect_that_is_refused_leaves_its_trial_under_way() -> None:
    log = Log(Bounds([0.0], [1.0]), None)
    measure = GridCoverage((0.1, 0.1))
    bandit = db.bandits.ucb1([db.MotorBabbling()], reward=Gain(measure))
    engine = Engine(bandit, log)
    engine.ask(log, np.random.default_rng(0))
    for wrong in ([1.0], [np.nan, 0.0], []):
        with pytest.raises(ValueError, match=r"cell|finite|empty"):
            engine.tell(0, log, wrong)
        assert len(log) == 0
    engine.tell(0, log, [1.0, 2.0])
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
    _, log = begun()
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
