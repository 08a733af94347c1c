"""An Explorer asked and told in any order: the same with either engine, also saved and loaded."""

import tempfile
from pathlib import Path

import numpy as np
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

import divbandit as db
from tests.exploration.random_compositions import compositions
from tests.exploration.sameness import everything

SPACE = db.Box([-3, -1, 0.5, 0], [3, 1, 0.5, 2])


def effect_of(command, dim):
    return np.cos(np.outer(np.arange(1, dim + 1), command) @ np.ones(4)).tolist()


def pick(explorer, number):
    """Return one of the open trials, by any number."""
    trials = explorer.open_trials
    return trials[number % len(trials)] if trials else None


def live(explorer, deeds, dim):
    """Do as told: ask for some, tell or fail one of those under way, tell all, add the past."""
    for deed, number in deeds:
        if deed == "ask":
            explorer.ask()
        elif deed == "ask many":
            explorer.ask(1 + number % 5)
        elif deed == "past":
            commands = [SPACE.sample(np.random.default_rng(number)) for _ in range(number % 4)]
            effects = [effect_of(command, dim) for command in commands]
            explorer.add_past(np.reshape(commands, (-1, 4)), np.reshape(effects, (-1, dim)))
        elif deed == "tell all":
            trials = explorer.open_trials
            explorer.tell(trials, [effect_of(trial.command, dim) for trial in trials])
        elif trial := pick(explorer, number):
            if deed == "tell":
                explorer.tell(trial, effect_of(trial.command, dim))
            else:
                explorer.fail(trial, f"reason {number}")


DEEDS = st.lists(
    st.tuples(
        st.sampled_from(["ask", "ask", "ask many", "tell", "tell", "fail", "tell all", "past"]),
        st.integers(0, 99),
    ),
    max_size=40,
)


def reloaded(explorer, folder):
    explorer.save(Path(folder) / "run")
    return db.Explorer.load(Path(folder) / "run")


@given(st.data())
@settings(
    max_examples=200,
    deadline=None,
    derandomize=True,
    suppress_health_check=[HealthCheck.too_slow, HealthCheck.data_too_large],
)
def test_asked_and_told_in_any_order(data):
    dim = data.draw(st.integers(1, 4))
    goals = data.draw(st.sampled_from([None, db.Box([-1] * dim, [1] * dim)]))
    strategy = data.draw(compositions(dim=dim, needs_goals=goals is None))
    explorers = [
        db.Explorer(strategy, SPACE, goals, rng=data.draw(st.just(3)), engine=engine)
        for engine in ("rust", "python")
    ]
    deeds = data.draw(DEEDS)
    with tempfile.TemporaryDirectory() as folder:
        for some in (deeds, data.draw(DEEDS)):
            for explorer in explorers:
                live(explorer, some, dim)
            expected = everything(explorers[1])
            assert everything(explorers[0]) == expected
            explorers[2:] = [reloaded(explorer, folder) for explorer in explorers[:2]]
            assert [everything(each) for each in explorers[2:]] == [expected] * 2
