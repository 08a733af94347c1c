"""MabwiserRule chooses what MABWiser itself would choose."""

import copy
import pickle

import numpy as np
import pytest
from mabwiser.mab import MAB, LearningPolicy, NeighborhoodPolicy

import divbandit as db
from divbandit.adapters import MabwiserRule
from divbandit.bandits import CoverageGain, WholePast

MEANS = (0.2, 0.8, 0.5)


def is_success(arm, credit):
    return credit > 0.5 + 0 * arm


POLICIES = [
    LearningPolicy.EpsilonGreedy(0.2),
    LearningPolicy.UCB1(1.0),
    LearningPolicy.Softmax(0.1),
    LearningPolicy.ThompsonSampling(is_success),
    LearningPolicy.Popularity(),
    LearningPolicy.Random(),
]


@pytest.fixture(params=POLICIES, ids=lambda policy: type(policy).__name__)
def policy(request):
    return request.param


def play(rule, rng, n=100, largest=4.0):
    """Let the rule choose; credits are drawn around each part's mean."""
    rule.begin(3, largest)
    draws, chosen = np.random.default_rng(9), []
    for _ in range(n):
        part = rule.choose(None, rng)
        rule.learn(
            part, largest * min(1.0, max(0.0, MEANS[part] + draws.random() / 2 - 0.25)), None
        )
        chosen.append(part)
    return chosen


def test_equals_a_loop_of_mabwiser(policy):
    seed = int(np.random.default_rng(7).random() * 2**32)
    bandit, draws, expected = MAB([0, 1, 2], policy, seed=seed), np.random.default_rng(9), []
    for step in range(100):
        part = step if step < 3 else bandit.predict()
        credit = min(1.0, max(0.0, MEANS[part] + draws.random() / 2 - 0.25))
        bandit.partial_fit([part], [credit])
        expected.append(part)
    assert play(MabwiserRule(policy), np.random.default_rng(7)) == expected


@pytest.mark.parametrize("policy", POLICIES[:4], ids=lambda policy: type(policy).__name__)
def test_finds_the_best(policy):
    chosen = play(MabwiserRule(policy), np.random.default_rng(0), n=400)
    assert np.bincount(chosen[200:], minlength=3).argmax() == 1


def test_begins_anew(policy):
    rule = MabwiserRule(policy)
    first = play(rule, np.random.default_rng(1))
    assert play(rule, np.random.default_rng(1)) == first
    assert play(MabwiserRule(policy), np.random.default_rng(1)) == first


@pytest.mark.parametrize("way", [copy.deepcopy, lambda x: pickle.loads(pickle.dumps(x))])  # noqa: S301
def test_a_copy_goes_on_alike(policy, way):
    rule, rng = MabwiserRule(policy), np.random.default_rng(2)
    play(rule, rng, n=20)
    other, stream = way((rule, rng))
    chosen = [[], []]
    for each, draws, log in [(rule, rng, chosen[0]), (other, stream, chosen[1])]:
        for step in range(30):
            log.append(each.choose(None, draws))
            each.learn(log[-1], float(step % 3), None)
    assert chosen[0] == chosen[1]


def test_every_part_is_chosen_before_any_credit_is_known():
    rule, rng = MabwiserRule(LearningPolicy.UCB1()), np.random.default_rng(0)
    rule.begin(3, 1.0)
    chosen = [rule.choose(None, rng) for _ in range(60)]
    assert chosen[:3] == [0, 1, 2]
    assert set(chosen[3:]) == {0, 1, 2}


@pytest.mark.parametrize(
    ("credits_", "best"), [((3.0, 20.0), 1), ((-3.0, 20.0), 1), ((2.0, 0.0), 0)]
)
def test_credits_without_a_bound_are_shares_of_the_largest_so_far(credits_, best):
    """A success is what comes to more than half of the largest so far."""
    told = []

    def is_large(arm, share):
        told.append((arm, share))
        return share > 0.5

    rule, rng = MabwiserRule(LearningPolicy.ThompsonSampling(is_large)), np.random.default_rng(0)
    rule.begin(2, 0.0)
    for credit in credits_:
        rule.learn(rule.choose(None, rng), credit, None)
    assert told[best] == (best, 1.0)
    assert all(0.0 <= share <= 1.0 for _, share in told)


def test_begun_again_before_it_has_learned():
    """As a bandit does when the first effect tells how large credits can be."""
    rule, rng = MabwiserRule(LearningPolicy.UCB1()), np.random.default_rng(0)
    rule.begin(2, 1.0)
    part = rule.choose(None, rng)
    rule.begin(2, 4.0)
    rule.learn(part, 2.0, None)
    assert [rule.choose(None, rng) for _ in range(2)] == [0, 1]


@pytest.mark.parametrize("dim", [2, 3])
def test_in_a_bandit(policy, dim):
    """With an effect of another dimension than 2, begun again with the first one."""
    arm = db.PlanarArm(4)
    box = db.FunctionEnvironment(lambda x: [*arm(x), 0.0][:dim], arm.motor_space)
    goals = db.Box([-1] * dim, [1] * dim)
    parts = [
        db.MotorBabbling(),
        db.GoalBabbling(0.01, goals=goals),
        db.GoalBabbling(1, goals=goals),
    ]
    bandit = db.Bandit(
        parts, credit=CoverageGain(0.05), memory=WholePast(), rule=MabwiserRule(policy)
    )
    runs = [db.explore(box, bandit, n=120, rng=0) for _ in range(2)]
    assert runs[0].commands.tobytes() == runs[1].commands.tobytes()
    assert set(runs[0].choices) == {0, 1, 2}


def test_many_under_way_and_failures():
    arm = db.PlanarArm(4)
    bandit = db.Bandit(
        [db.MotorBabbling(), db.GoalBabbling()],
        credit=CoverageGain(0.05),
        memory=WholePast(),
        rule=MabwiserRule(LearningPolicy.UCB1()),
    )
    explorer = db.Explorer(bandit, arm.motor_space, arm.sensory_space, rng=0)
    for _ in range(20):
        trials = explorer.ask(7)
        explorer.fail(trials[3], "no power")
        told = [*trials[:3], *trials[4:]]
        explorer.tell(told, [arm(trial.command) for trial in told])
    assert len(explorer.history) == 120
    assert len(explorer.history.failures) == 20


@pytest.mark.parametrize(
    ("policy", "error", "words"),
    [
        ("ucb", TypeError, "policy must be a LearningPolicy of MABWiser, got str"),
        (LearningPolicy.UCB1, TypeError, "policy must be a LearningPolicy of MABWiser, got type"),
        (LearningPolicy.LinUCB(), ValueError, "policy must need no contexts, got LinUCB"),
        (NeighborhoodPolicy.Clusters(), TypeError, "policy must be a LearningPolicy of MABWiser"),
        (LearningPolicy.ThompsonSampling(), ValueError, "policy must be given a binarizer"),
    ],
)
def test_refuses(policy, error, words):
    with pytest.raises(error, match=words):
        MabwiserRule(policy)


def test_learns_of_its_own_choices_alone():
    with pytest.raises(ValueError, match="part must have been chosen"):
        MabwiserRule(LearningPolicy.Random()).learn(0, 1.0, None)


def test_reads_like_its_constructor():
    assert repr(MabwiserRule(LearningPolicy.UCB1(2.0))) == "MabwiserRule(UCB1(alpha=2.0))"
