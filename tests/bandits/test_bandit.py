"""A bandit of any reward, estimator and policy: it explores, and learns however it is told."""

import itertools
import math
from dataclasses import replace

import numpy as np
import pytest

import divbandit as db
from divbandit import bandits as b
from divbandit.measures import BallCoverage, Entropy, GridCoverage, Sparseness
from tests.bandits.script import both_engines
from tests.generators import state

ARM = db.PlanarArm(4)
RMB, RGB = db.MotorBabbling, db.GoalBabbling
GRID = GridCoverage


def height(effect, history):
    assert history.effects[-1].tolist() == effect.tolist()
    return float(effect[1])


REWARDS = (
    b.Gain(BallCoverage(0.1)),
    b.Gain(GRID(0.2)),
    b.Gain(Entropy(0.2)),
    b.Gain(Sparseness(2)),
    b.CompetenceProgress(),
    b.FunctionReward(height, bound=1.0),
    height,
)
ESTIMATORS = (
    b.Window(9),
    b.Window(5, head_start=0),
    b.RecentWindow(12),
    b.Discounted(0.9),
    b.WholePast(),
)
POLICIES = (
    b.Proportional(0.2),
    b.Proportional(0.2, power=2),
    b.EpsilonGreedy(0.2),
    b.Softmax(0.3),
    b.UCB(0.5),
    b.Thompson(),
    b.Exp3(0.3),
    b.Exp3S(0.3, 0.01),
    b.RoundRobin(),
    b.Uniform(),
)


def named(part):
    """Return what a test calls a part: without the address of a function."""
    return getattr(part, "__name__", repr(part))


ALL = list(itertools.product(REWARDS, ESTIMATORS, POLICIES))


def made(reward, estimator, policy, parts=None):
    parts = parts or [RMB(), RGB(0.05), RGB(0.5)]
    return db.Bandit(parts, reward=reward, estimator=estimator, policy=policy)


def explorer_of(bandit, engine="auto"):
    return db.Explorer(bandit, ARM.motor_space, ARM.sensory_space, rng=0, engine=engine)


def driven(bandit, engine):
    """Make steps with trials that fail, are told late, and in another order than asked."""
    explorer, open_, seen = explorer_of(bandit, engine), [], []
    for step in range(60):
        open_.append(explorer.ask())
        if step % 7 == 3:
            explorer.fail(open_.pop(0), "it fell over")
        elif step % 3:
            trial = open_.pop(-1 if step % 2 else 0)
            explorer.tell(trial, ARM(trial.command))
        seen.append((explorer.estimates, open_[-1].probability if open_ else None))
    return explorer.history.commands.tobytes(), seen, state(explorer.rng)


@pytest.mark.parametrize("parts", ALL, ids=lambda parts: " ".join(map(named, parts)))
def test_every_combination(parts):
    """One seed, the same bits, in Python and in the engine; the bandit is not changed."""
    bandit = made(*parts)
    inner = made(*parts, [RGB(0.05), RMB()])
    nested = made(*parts, [inner, RMB(), db.Schedule([(5, RMB()), (None, RGB(0.5))])])
    for each in (bandit, nested):
        before = repr(each)
        ends = [driven(each, engine) for engine in ("python", "auto")]
        assert ends[0] == ends[1]
        assert repr(each) == before
        assert all(math.isfinite(mean) for means, _ in ends[0][1] for mean in means)


@both_engines
def test_choices_carry_their_probability(engine):
    bandit = made(REWARDS[0], b.Window(), b.Proportional(0.3))
    assert explorer_of(bandit, engine).ask().probability == pytest.approx(1 / 3, rel=1e-15)
    assert explorer_of(db.Adapt([RMB()] * 2), engine).ask().probability is None


@both_engines
def test_failures_before_the_first_effect_are_kept_when_it_tells_the_dimension(engine):
    box = db.Box([0.0] * 3, [1.0] * 3)
    explorer = db.Explorer(db.Adapt([RMB()], tau=0.5), box, rng=0, engine=engine)
    explorer.fail(explorer.ask(), "no power")
    explorer.tell(explorer.ask(), [0.0] * 3)
    ball = 4 / 3 * math.pi * 0.5**3
    assert explorer.estimates == pytest.approx((2 / 3 * ball,))  # ball, 0, ball


def test_competence_progress_by_hand():
    """Goal (3, 4): 5 from the origin, 3 from (3, 1); then (3, 3) is 1 away."""
    history, reward = db.History(db.Box([0], [1])), b.CompetenceProgress().start(2)
    gained = []
    for effect in ([0.0, 0.0], [3.0, 1.0], [3.0, 3.0], [9.0, 9.0]):
        history.append([0.5], effect)
        trial = db.Trial([0.5], goal=[3.0, 4.0])
        gained.append(reward.of(trial, history.effects[-1], history))
    assert gained == [0.0, 2.0, 2.0, 0.0]
    history.append([0.5], [3.0, 4.0])
    assert reward.of(db.Trial([0.5]), history.effects[-1], history) == 0.0


def test_a_gain_counts_the_effects_of_others_before():
    history = db.History(db.Box([0], [1]))
    reward, trial = b.Gain(BallCoverage(1.0)).start(2), db.Trial([0.5])
    gains = []
    for others, effect in ((0, [0.0, 0.0]), (1, [0.0, 0.0]), (2, [5.0, 0.0]), (0, [9.0, 0.0])):
        for _ in range(others):
            history.append([0.5], [5.0, 0.0])
        history.append([0.5], effect)
        gains.append(reward.of(trial, history.effects[-1], history))
    assert gains == [math.pi, 0.0, 0.0, math.pi]


@pytest.mark.parametrize(
    ("value", "message"),
    [
        (math.nan, "reward must be a finite number"),
        (math.inf, "reward must be a finite number"),
        (1e301, "reward must be a finite number"),
        ("1", "reward must be a number, got str"),
        (None, "reward must be a number, got NoneType"),
        (True, "reward must be a number, got bool"),
        ([1.0], "reward must be a number, got list"),
    ],
)
def test_a_bad_reward_is_refused_and_changes_nothing(value, message):
    explorer = explorer_of(made(lambda *_: value, b.WholePast(), b.UCB()))
    trial = explorer.ask()
    with pytest.raises((TypeError, ValueError), match=message):
        explorer.tell(trial, [0.0, 0.0])
    assert explorer.estimates == (0.0, 0.0, 0.0)


def test_what_a_reward_raises_is_passed_on():
    def broken(*_):
        raise OSError("no ruler")

    explorer = explorer_of(made(broken, b.WholePast(), b.UCB()))
    with pytest.raises(OSError, match="no ruler"):
        explorer.tell(explorer.ask(), [0.0, 0.0])


@pytest.mark.parametrize("value", [1, np.int64(1), np.float64(1.0), np.float32(1.0)])
def test_other_numbers_are_rewards(value):
    explorer = explorer_of(made(lambda *_: value, b.WholePast(), b.RoundRobin()))
    explorer.tell(explorer.ask(), [0.0, 0.0])
    assert explorer.estimates == (1.0, 0.0, 0.0)
    assert type(explorer.estimates[0]) is float


class Odd:
    """A user's policy, which chooses what it was given."""

    def __init__(self, chosen):
        self.chosen = chosen

    def start(self, parts, largest):
        assert (parts, largest > 0) == (3, True)
        return self

    def choose(self, estimates, rng):
        del estimates, rng
        return self.chosen


@pytest.mark.parametrize(
    "chosen",
    [3, -1, 1.0, None, "1", True, (0,), (0, 0.5, 1), (3, 0.5), (0, 0.0), (0, 1.5), (0, math.nan)],
)
def test_a_bad_choice_is_refused(chosen):
    explorer = explorer_of(made(REWARDS[0], b.Window(), Odd(chosen)))
    with pytest.raises((TypeError, ValueError), match=r"policy\.choose\(\)"):
        explorer.ask()


@pytest.mark.parametrize(
    "chosen", [1, np.int64(1), (1, None), (1, 0.25), (np.int32(1), np.float64(0.25))]
)
def test_a_good_choice(chosen):
    trial = explorer_of(made(REWARDS[0], b.Window(), Odd(chosen))).ask()
    assert trial.path == (1,)
    assert trial.probability == (None if not isinstance(chosen, tuple) else chosen[1])


def test_the_papers_three_parts_are_adapt():
    bandit = made(REWARDS[0], b.Window(7, head_start=2), b.Proportional(0.2, power=1.5))
    adapt = db.Adapt(bandit.strategies, tau=0.1, window=7, head_start=2, alpha=0.2, power=1.5)
    by_tau = replace(bandit, tau=0.1, reward=None)
    runs = [
        db.explore(ARM, each, 500, rng=3, engine=engine)
        for each in (bandit, by_tau, adapt)
        for engine in ("rust", "python")
    ]
    assert len({run.commands.tobytes() for run in runs}) == 1
    assert len({run.estimates.tobytes() for run in runs}) == 1
    flat = db.explore(ARM, db.Adapt(bandit.strategies, tau=0.1, window=7), 500, rng=3)
    assert flat.commands.tobytes() != runs[0].commands.tobytes()


class Nonsense:
    """A user's part whose `start` returns what was given."""

    def __init__(self, started):
        self.started = started

    def largest(self, dim):
        return float(dim)

    def start(self, *_):
        return self.started


class Listed:
    """Estimates that are not what they must be."""

    largest = 1.0

    def __init__(self, means=(0.0, 0.0), counts=(0.0, 0.0)):
        self.means, self.counts = means, counts

    def add(self, *_):
        raise AssertionError


GOOD = {"reward": REWARDS[0], "estimator": b.Window(), "policy": b.UCB()}


@pytest.mark.parametrize(
    "started", [None, 7, "ab", object(), Listed], ids=["None", "7", "ab", "an object", "a class"]
)
@pytest.mark.parametrize("name", ["reward", "estimator", "policy", "measure"])
@pytest.mark.parametrize("known", [True, False], ids=["known", "unknown"])
def test_a_part_whose_start_returns_nonsense_is_refused(name, started, known):
    part = Nonsense(started)
    parts = {"reward": b.Gain(part)} if name == "measure" else {name: part}
    bandit = db.Bandit([RMB()] * 2, **GOOD | parts)
    sensory_space = ARM.sensory_space if known else None
    with pytest.raises(TypeError, match=rf"{name}\.start(\(\))? must return"):
        db.explore(db.FunctionEnvironment(ARM, ARM.motor_space, sensory_space), bandit, 1, rng=0)


@pytest.mark.parametrize("name", ["means", "counts"])
@pytest.mark.parametrize(
    "numbers", [None, 7.0, [], [0.0], [0.0] * 3, ["a", "b"], [0.0, math.nan]], ids=repr
)
def test_an_estimator_must_have_a_number_for_each_strategy(name, numbers):
    estimator = Nonsense(Listed(**{name: numbers}))
    bandit = db.Bandit([RMB()] * 2, **GOOD | {"estimator": estimator})
    with pytest.raises((TypeError, ValueError), match=rf"estimator\.{name}"):
        explorer_of(bandit)


@pytest.mark.parametrize("largest", [None, "1", -1.0, math.nan, math.inf])
def test_the_largest_reward_must_be_a_number(largest):
    reward = Nonsense(None)
    reward.largest = lambda _: largest
    with pytest.raises((TypeError, ValueError), match=r"reward\.largest\(\)"):
        explorer_of(db.Bandit([RMB()], **GOOD | {"reward": reward}))
