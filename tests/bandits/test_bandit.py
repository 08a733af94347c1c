"""A bandit of any credit, memory and rule: it explores, copies, and learns however it is told."""

import copy
import itertools
import math
import pickle

import numpy as np
import pytest

import divbandit as db
from divbandit.bandits import (
    UCB,
    CompetenceProgress,
    CoverageGain,
    Discounted,
    EpsilonGreedy,
    Exp3,
    Exp3S,
    FunctionCredit,
    Gain,
    Proportional,
    RecentWindow,
    RoundRobin,
    Softmax,
    Thompson,
    Uniform,
    WholePast,
    Window,
)

ARM = db.PlanarArm(4)
RMB, RGB = db.MotorBabbling, db.GoalBabbling


def height(effect, history):
    assert history.effects[-1].tolist() == effect.tolist()
    return float(effect[1])


CREDITS = (
    CoverageGain(0.1),
    Gain(db.GridCoverage(0.2)),
    Gain(db.Entropy(0.2)),
    Gain(db.Sparseness(2)),
    CompetenceProgress(),
    FunctionCredit(height, bound=1.0),
    height,
)
MEMORIES = (Window(9), Window(5, head_start=0), RecentWindow(12), Discounted(0.9), WholePast())
RULES = (
    Proportional(0.2),
    Proportional(0.2, power=2),
    EpsilonGreedy(0.2),
    Softmax(0.3),
    UCB(0.5),
    Thompson(),
    Exp3(0.3),
    Exp3S(0.3, 0.01),
    RoundRobin(),
    Uniform(),
)
ALL = list(itertools.product(CREDITS, MEMORIES, RULES))


def made(credit, memory, rule, parts=None):
    parts = parts or [RMB(), RGB(0.05), RGB(0.5)]
    return db.Bandit(parts, credit=credit, memory=memory, rule=rule)


def told(trial, history, bandit):
    """Tell a bandit what came of a trial, as an explorer does."""
    effect = ARM(trial.command)
    history.append(trial.command, effect, path=trial.path)
    trial.place = len(history) - 1
    bandit.observe(trial, effect)


def driven(bandit, seed=0):
    """Make steps with trials that fail, are told late, and in another order than asked."""
    history, rng = db.History(ARM.motor_space, ARM.sensory_space), np.random.default_rng(seed)
    open_, seen = [], []
    for step in range(60):
        open_.append(bandit.propose(history, rng))
        if step % 7 == 3:
            bandit.fail(open_.pop(0), "it fell over")
        elif step % 3:
            told(open_.pop(-1 if step % 2 else 0), history, bandit)
        seen.append(bandit.diversities)
        if step == 30:
            bandit, history, rng, open_ = yield bandit, history, rng, open_
    yield history.commands.tobytes(), seen[31:]


@pytest.mark.parametrize("parts", ALL, ids=lambda parts: " ".join(map(repr, parts))[:90])
def test_every_combination(parts):
    """One seed, the same bits; a copy made half-way goes on alike; the template is not changed."""
    bandit = made(*parts)
    words, ends = repr(bandit), []
    for way in (lambda x: x, copy.deepcopy, lambda x: pickle.loads(pickle.dumps(x))):  # noqa: S301
        run = driven(copy.deepcopy(bandit))
        ends.append(run.send(way(next(run))))
    assert ends[0] == ends[1] == ends[2]
    assert repr(bandit) == words
    assert all(math.isfinite(mean) for means in ends[0][1] for mean in means)
    first, again = (db.explore(ARM, bandit, 40, rng=1) for _ in range(2))
    assert first.commands.tobytes() == again.commands.tobytes()
    assert first.diversities.tobytes() == again.diversities.tobytes()


def nested(credit, memory, rule):
    inner = made(credit, memory, rule, [RGB(0.05), RMB()])
    return made(credit, memory, rule, [inner, RMB(), db.Schedule([(5, RMB()), (None, RGB(0.5))])])


@pytest.mark.parametrize("rule", RULES, ids=repr)
@pytest.mark.parametrize("memory", MEMORIES, ids=repr)
@pytest.mark.parametrize("credit", CREDITS[:5], ids=repr)
def test_many_at_once_is_one_after_the_other(credit, memory, rule):
    """The same state, to the bit, at each level; and the same choices after it."""
    bandit = nested(credit, memory, rule)
    assert bandit.learns_at_once
    many, single = copy.deepcopy(bandit), copy.deepcopy(bandit)
    beliefs = []
    for one, at_once in ((many, True), (single, False)):
        history, rng, seen = (
            db.History(ARM.motor_space, ARM.sensory_space),
            np.random.default_rng(2),
            [],
        )
        for n in (1, 20, 7, 1, 30):
            trials = one.propose_many(history, n, rng)
            trials = [*trials[n // 2 :], *trials[: n // 2]]
            effects = ARM(np.array([trial.command for trial in trials]))
            if at_once:
                for trial, effect in zip(trials, effects, strict=True):
                    history.append(trial.command, effect, path=trial.path)
                    trial.place = len(history) - 1
                one.observe_many(trials, effects)
            else:
                for trial in trials:
                    told(trial, history, one)
            seen.append(
                (one.diversities, one.strategies[0].diversities, one.propose(history, rng).path)
            )
        beliefs.append((seen, history.commands.tobytes()))
    assert beliefs[0] == beliefs[1]


def test_a_function_is_told_one_by_one():
    assert not made(height, Window(), Uniform()).learns_at_once
    assert not made(
        CoverageGain(), Window(), Uniform(), [made(height, Window(), Uniform())]
    ).learns_at_once


def test_choices_carry_their_probability():
    bandit, rng = made(CoverageGain(), Window(), Proportional(0.3)), np.random.default_rng(0)
    history = db.History(ARM.motor_space, ARM.sensory_space)
    assert bandit.propose(history, rng).probability == pytest.approx(1 / 3, rel=1e-15)

    class First(db.Adapt):
        def choose(self, history, rng):
            super().choose(history, rng)
            return 0

    assert {First([RMB()] * 2).propose(history, rng).probability for _ in range(9)} == {None}


def test_a_failure_is_a_credit_of_nothing():
    bandit = db.Bandit(
        [RMB(), RMB()],
        credit=Gain(db.GridCoverage(1.0)),
        memory=Window(4),
        rule=RoundRobin(),
    )
    history, rng = db.History(ARM.motor_space, ARM.sensory_space), np.random.default_rng(0)
    bandit.fail(bandit.propose(history, rng), "no power")
    assert bandit.diversities == (0.5, 1.0)  # the head start and 0


def test_failures_before_the_first_effect_are_kept_when_it_tells_the_dimension():
    box = db.Box([0.0] * 3, [1.0] * 3)
    bandit, history = db.Adapt([RMB()], tau=0.5), db.History(box)
    rng = np.random.default_rng(0)
    bandit.fail(bandit.propose(history, rng), "no power")
    trial = bandit.propose(history, rng)
    history.append(trial.command, trial.command, path=trial.path)
    bandit.observe(trial, trial.command)
    ball = 4 / 3 * math.pi * 0.5**3
    assert bandit.diversities == pytest.approx((2 / 3 * ball,))  # ball, 0, ball


def test_competence_progress_by_hand():
    """Goal (3, 4): 5 from the origin, 3 from (3, 1); then (3, 3) is 1 away."""
    history, credit = db.History(db.Box([0], [1])), CompetenceProgress()
    gained = []
    for effect in ([0.0, 0.0], [3.0, 1.0], [3.0, 3.0], [9.0, 9.0]):
        trial = db.Trial([0.5], goal=[3.0, 4.0])
        history.append([0.5], effect)
        trial.place = len(history) - 1
        gained.append(credit.of(trial, history.effects[-1], history))
    assert gained == [0.0, 2.0, 2.0, 0.0]
    trial = db.Trial([0.5])
    trial.place = 3
    assert credit.of(trial, history.effects[3], history) == 0.0
    earlier = db.Trial([0.5], goal=[3.0, 4.0])
    earlier.place = 1  # told of an earlier one once more
    assert credit.of(earlier, history.effects[1], history) == 2.0


def test_a_gain_of_an_earlier_effect_is_taken_at_its_place():
    history, credit = db.History(db.Box([0], [1])), CoverageGain(1.0)
    for effect in ([0.0, 0.0], [0.0, 0.0], [5.0, 0.0]):
        history.append([0.5], effect)
    gains = []
    for place in (2, 0, 1, 2):
        trial = db.Trial([0.5])
        trial.place = place
        gains.append(credit.of(trial, history.effects[place], history))
    assert gains == [math.pi, math.pi, 0.0, math.pi]


@pytest.mark.parametrize(
    ("value", "message"),
    [
        (math.nan, "credit must be a finite number"),
        (math.inf, "credit must be a finite number"),
        (1e301, "credit must be a finite number"),
        ("1", "credit must be a number, got str"),
        (None, "credit must be a number, got NoneType"),
        (True, "credit must be a number, got bool"),
        ([1.0], "credit must be a number, got list"),
    ],
)
def test_a_bad_credit_is_refused_and_changes_nothing(value, message):
    explorer = db.Explorer(
        made(lambda *_: value, WholePast(), UCB()), ARM.motor_space, ARM.sensory_space, rng=0
    )
    trial = explorer.ask()
    with pytest.raises((TypeError, ValueError), match=message):
        explorer.tell(trial, [0.0, 0.0])
    assert explorer.strategy.diversities == (0.0, 0.0, 0.0)


def test_what_a_credit_raises_is_passed_on():
    def broken(*_):
        raise OSError("no ruler")

    explorer = db.Explorer(
        made(broken, WholePast(), UCB()), ARM.motor_space, ARM.sensory_space, rng=0
    )
    with pytest.raises(OSError, match="no ruler"):
        explorer.tell(explorer.ask(), [0.0, 0.0])


@pytest.mark.parametrize("value", [1, np.int64(1), np.float64(1.0), np.float32(1.0)])
def test_other_numbers_are_credits(value):
    explorer = db.Explorer(
        made(lambda *_: value, WholePast(), RoundRobin()), ARM.motor_space, ARM.sensory_space, rng=0
    )
    explorer.tell(explorer.ask(), [0.0, 0.0])
    assert explorer.strategy.diversities == (1.0, 0.0, 0.0)
    assert type(explorer.strategy.diversities[0]) is float


class Odd:
    """A rule that chooses what it was given."""

    def __init__(self, chosen):
        self.chosen = chosen

    def begin(self, parts, largest):
        assert (parts, largest > 0) == (3, True)

    def choose(self, memory, rng):
        del memory, rng
        return self.chosen


@pytest.mark.parametrize(
    "chosen",
    [3, -1, 1.0, None, "1", True, (0,), (0, 0.5, 1), (3, 0.5), (0, 0.0), (0, 1.5), (0, math.nan)],
)
def test_a_bad_choice_is_refused(chosen):
    explorer = db.Explorer(
        made(CoverageGain(), Window(), Odd(chosen)), ARM.motor_space, ARM.sensory_space, rng=0
    )
    with pytest.raises((TypeError, ValueError), match=r"rule\.choose\(\)"):
        explorer.ask()


@pytest.mark.parametrize(
    "chosen", [1, np.int64(1), (1, None), (1, 0.25), (np.int32(1), np.float64(0.25))]
)
def test_a_good_choice(chosen):
    trial = made(CoverageGain(), Window(), Odd(chosen)).propose(
        db.History(ARM.motor_space, ARM.sensory_space), np.random.default_rng(0)
    )
    assert trial.path == (1,)
    assert trial.probability == (None if not isinstance(chosen, tuple) else chosen[1])


def test_the_papers_parts_run_in_rust():
    for credit in (CoverageGain(0.1), Gain(db.Coverage(0.1))):
        bandit = made(credit, Window(7, head_start=2), Proportional(0.2, power=1.5))
        adapt = db.Adapt(bandit.strategies, tau=0.1, window=7, head_start=2, alpha=0.2, power=1.5)
        runs = [
            db.explore(ARM, each, 500, rng=3, engine=engine)
            for each in (bandit, adapt)
            for engine in ("rust", "python")
        ]
        assert len({run.commands.tobytes() for run in runs}) == 1
        assert len({run.diversities.tobytes() for run in runs}) == 1
    flat = db.explore(ARM, db.Adapt(bandit.strategies, tau=0.1, window=7), 500, rng=3)
    assert flat.commands.tobytes() != runs[0].commands.tobytes()


@pytest.mark.parametrize(
    ("parts", "where"),
    [
        ((height, Window(), Proportional()), "credit, a function"),
        ((Gain(db.Entropy(0.1)), Window(), Proportional()), "credit.measure, a Entropy"),
        ((CoverageGain(), WholePast(), Proportional()), "memory, a WholePast"),
        ((CoverageGain(), Window(), UCB()), "rule, a UCB"),
    ],
)
def test_others_do_not(parts, where):
    with pytest.raises(ValueError, match=f"got strategy.{where}"):
        db.explore(ARM, made(*parts), 5, rng=0, engine="rust")


@pytest.mark.parametrize("earned", [[1.0], (1.0,) * 11, None])
def test_credits_of_many_must_be_as_many(earned):
    class Few:
        def largest(self, dim):
            return float(dim)

        def of(self, trial, effect, history):
            del trial, effect, history
            return 1.0

        def of_many(self, trials, effects, history):
            del trials, effects, history
            return earned

    b = db.bandits
    bandit = db.Bandit(
        [db.MotorBabbling()], credit=Few(), memory=b.WholePast(), rule=b.Proportional()
    )
    explorer = db.Explorer(bandit, db.Box([0], [1]), rng=0)
    trials = explorer.ask(10)
    with pytest.raises((TypeError, ValueError), match=r"credit\.of_many|NoneType"):
        explorer.tell(trials, trials.commands)
    assert explorer.strategy.diversities == (0.0,)


def test_a_memory_must_have_a_mean_for_each_strategy():
    class Short(db.bandits.WholePast):
        def begin(self, parts, largest):
            super().begin(parts - 1, largest)

    b = db.bandits
    with pytest.raises(ValueError, match=r"memory\.means must hold one for each of 2 strategies"):
        db.Bandit([db.MotorBabbling()] * 2, credit=b.CoverageGain(), memory=Short(), rule=b.UCB())
