"""What Adapts believed at each step equals a plain replay of the log, at each level of nesting."""

import numpy as np
import pytest

import divbandit as db
from tests.bandits.script import both_engines
from tests.reference.adapt_replay import replay

ARM = db.PlanarArm(20)
RMB, RGB = db.MotorBabbling, db.GoalBabbling


def nested():
    deep = db.Adapt([RMB(), RGB(0.5)], tau=0.05, window=3, head_start=2)
    return db.Adapt(
        [
            db.Adapt([RMB(), RGB(0.05)], tau=0.1, window=7, alpha=0.2, head_start=0),
            db.Adapt([RGB(0.001), deep], tau=0.02, window=1),
            RMB(),
        ],
        tau=0.03,
        window=20,
    )


FLAT = {
    "the paper's": db.Adapt([RMB(), RGB(0.05)]),
    "no head start": db.Adapt([RMB(), RGB(0.001)], window=10, head_start=0),
    "a full head start": db.Adapt([RMB(), RGB(0.001)], window=4, head_start=4, alpha=0),
    "coarse": db.Adapt([RGB(0.5), RGB(0.05), RMB()], tau=0.3, window=5, alpha=0.5),
    "nested": nested(),
    "in the end": db.Adapt([RMB(), RGB(0.05)], window=10_000),
}


@both_engines
@pytest.mark.parametrize("adapt", FLAT.values(), ids=FLAT)
def test_a_run_equals_its_replay(adapt, engine):
    run = db.explore(ARM, adapt, n=700, rng=0, engine=engine)
    expected = replay(adapt, run.effects, [tuple(path) for path in run.paths])
    assert run.estimates.tolist() == [list(belief) for belief in expected[:-1]]


def levels(adapt, running, prefix=()):
    """Yield each Adapt within, what runs in its place, and where it stands."""
    yield prefix, adapt, running
    for index, part in enumerate(adapt.strategies):
        if isinstance(part, db.Adapt):
            yield from levels(part, running.strategies[index], (*prefix, index))


def driven(adapt, n, seed):
    """Run the loop in plain sight: the history, and each level's beliefs after each step."""
    history, rng = db.History(ARM.motor_space, ARM.sensory_space), np.random.default_rng(seed)
    running = db.strategies.Starter(history)(adapt)
    beliefs = {prefix: [part.estimates] for prefix, _, part in levels(adapt, running)}
    for _ in range(n):
        trial = running.propose(history, rng)
        effect = ARM(trial.command)
        history.append(trial.command, effect, path=trial.path)
        running.observe(trial, effect)
        for prefix, _, part in levels(adapt, running):
            beliefs[prefix].append(part.estimates)
    return history, beliefs


def test_each_level_equals_its_own_replay():
    adapt = nested()
    history, beliefs = driven(adapt, n=700, seed=1)
    assert set(beliefs) == {(), (0,), (1,), (1, 1)}
    for prefix, part, _ in levels(adapt, db.strategies.Starter(history)(adapt)):
        assert beliefs[prefix] == replay(part, history.effects, history.paths, prefix)
    own = [path for path in history.paths if path[:2] == (1, 1)]
    assert len(own) > 20, "the innermost must have been chosen for this to tell anything"


@both_engines
def test_the_loop_in_plain_sight_is_what_explore_does(engine):
    history, beliefs = driven(nested(), n=300, seed=2)
    run = db.explore(ARM, nested(), n=300, rng=2, engine=engine)
    assert run.commands.tolist() == history.commands.tolist()
    assert run.effects.tolist() == history.effects.tolist()
    assert run.estimates.tolist() == [list(belief) for belief in beliefs[()][:-1]]
    trimmed = [tuple(index for index in path if index >= 0) for path in run.paths.tolist()]
    assert trimmed == list(history.paths)


def test_an_adapt_in_a_mixture_sees_what_the_others_covered():
    adapt = db.Adapt([RMB(), RGB(0.05)], tau=0.1, window=5)
    mixture = db.Mixture([adapt, RGB(0.5)])
    explorer = db.Explorer(mixture, ARM.motor_space, ARM.sensory_space, rng=0, engine="python")
    for _ in range(400):
        trial = explorer.ask()
        explorer.tell(trial, ARM(trial.command))
    expected = replay(adapt, explorer.history.effects, explorer.history.paths, (0,))[-1]
    assert explorer.strategy.strategies[0].estimates == expected


@both_engines
def test_answers_out_of_order_reward_the_strategy_that_asked(engine):
    """Effects count in the order told; each is a reward for the strategy of its own trial."""
    adapt = db.Adapt([RMB(), RGB(0.05)], window=5)
    explorer = db.Explorer(adapt, ARM.motor_space, ARM.sensory_space, rng=3, engine=engine)
    order, waiting = np.random.default_rng(0), []
    for _ in range(300):
        waiting.append(explorer.ask())
        while len(waiting) > order.integers(8):
            trial = waiting.pop(order.integers(len(waiting)))
            explorer.tell(trial, ARM(trial.command))
    history = explorer.history
    assert explorer.estimates == replay(adapt, history.effects, history.paths)[-1]
