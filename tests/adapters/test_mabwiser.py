"""MabwiserPolicy chooses what MABWiser itself would choose."""

import numpy as np
import pytest
from mabwiser.mab import MAB, LearningPolicy, NeighborhoodPolicy

import divbandit as db
from divbandit.adapters import MabwiserPolicy
from divbandit.bandits import WholePast

MEANS = (0.2, 0.8, 0.5)


def is_success(arm, share):
    return share > 0.5 + 0 * arm


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


def play(policy, rng, n=100, largest=4.0):
    """Let the policy choose; rewards are drawn around each part's mean."""
    running = MabwiserPolicy(policy).start(3, largest)
    draws, chosen = np.random.default_rng(9), []
    for _ in range(n):
        part = running.choose(None, rng)
        share = min(1.0, max(0.0, MEANS[part] + draws.random() / 2 - 0.25))
        running.learn(part, largest * share, None)
        chosen.append(part)
    return chosen


def test_equals_a_loop_of_mabwiser(policy):
    seed = int(np.random.default_rng(7).random() * 2**32)
    bandit, draws, expected = MAB([0, 1, 2], policy, seed=seed), np.random.default_rng(9), []
    for step in range(100):
        part = step if step < 3 else bandit.predict()
        share = min(1.0, max(0.0, MEANS[part] + draws.random() / 2 - 0.25))
        bandit.partial_fit([part], [share])
        expected.append(part)
    assert play(policy, np.random.default_rng(7)) == expected


@pytest.mark.parametrize("policy", POLICIES[:4], ids=lambda policy: type(policy).__name__)
def test_finds_the_best(policy):
    chosen = play(policy, np.random.default_rng(0), n=400)
    assert np.bincount(chosen[200:], minlength=3).argmax() == 1


def test_each_exploration_starts_another(policy):
    value = MabwiserPolicy(policy)
    first, second = value.start(3, 1.0), value.start(3, 1.0)
    rng = np.random.default_rng(1)
    for part in range(3):
        first.learn(first.choose(None, rng), float(part), None)
    assert second.choose(None, rng) == 0


def test_every_part_is_chosen_before_any_reward_is_known():
    running, rng = MabwiserPolicy(LearningPolicy.UCB1()).start(3, 1.0), np.random.default_rng(0)
    chosen = [running.choose(None, rng) for _ in range(60)]
    assert chosen[:3] == [0, 1, 2]
    assert set(chosen[3:]) == {0, 1, 2}


@pytest.mark.parametrize(
    ("rewards", "best"), [((3.0, 20.0), 1), ((-3.0, 20.0), 1), ((2.0, 0.0), 0)]
)
def test_rewards_without_a_bound_are_shares_of_the_largest_so_far(rewards, best):
    """A success is what comes to more than half of the largest so far."""
    learned = []

    def is_large(arm, share):
        learned.append((arm, share))
        return share > 0.5

    rng = np.random.default_rng(0)
    running = MabwiserPolicy(LearningPolicy.ThompsonSampling(is_large)).start(2, 0.0)
    for reward in rewards:
        running.learn(running.choose(None, rng), reward, None)
    assert learned[best] == (best, 1.0)
    assert all(0.0 <= share <= 1.0 for _, share in learned)


def test_learns_before_it_chooses(policy):
    """As in a bandit that starts its policy again when the first effect tells its dimension."""
    early, late = (MabwiserPolicy(policy).start(2, 4.0) for _ in "ab")
    early.learn(0, 2.0, None)
    one, other = (np.random.default_rng(0) for _ in "ab")
    assert early.choose(None, one) == late.choose(None, other) == 0
    late.learn(0, 2.0, None)
    for _ in range(20):
        assert early.choose(None, one) == late.choose(None, other)


@pytest.mark.parametrize("dim", [2, 3])
def test_in_a_bandit(policy, dim):
    """With effects of another dimension than 2, the policy is started again by the first."""
    arm = db.PlanarArm(4)
    box = db.FunctionEnvironment(lambda x: [*arm(x), 0.0][:dim], arm.motor_space)
    goals = db.Box([-1] * dim, [1] * dim)
    parts = [
        db.MotorBabbling(),
        db.GoalBabbling(0.01, goals=goals),
        db.GoalBabbling(1, goals=goals),
    ]
    bandit = db.Bandit(parts, tau=0.05, estimator=WholePast(), policy=MabwiserPolicy(policy))
    runs = [db.explore(box, bandit, n=120, rng=0) for _ in range(2)]
    assert runs[0].commands.tobytes() == runs[1].commands.tobytes()
    assert set(runs[0].choices) == {0, 1, 2}


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
        MabwiserPolicy(policy)
