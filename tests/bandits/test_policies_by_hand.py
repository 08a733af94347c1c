"""Every policy against numbers worked out on paper, and its draws counted."""

import math

import numpy as np
import pytest
from scipy import stats

from divbandit import _core
from divbandit import bandits as b
from tests.generators import draws_from, scripted

B = 4.0
#: Part 0 earned 1 and 3, part 1 earned 4 once, part 2 earned 0, 0 and 3.
REWARDS = [(0, 1.0), (1, 4.0), (2, 0.0), (0, 3.0), (2, 0.0), (2, 3.0)]


def remembered(estimator, *, parts=3, largest=B, told=REWARDS):
    estimates = estimator.start(parts, largest)
    for part, reward in told:
        estimates.add(part, reward)
    return estimates


def begun(policy, *, parts=3, largest=B):
    return policy.start(parts, largest)


def near(*numbers):
    return pytest.approx(numbers, rel=1e-14)


def test_proportional():
    """Means 2, 4, 1: sevenths 2, 4, 1; with alpha = 0.3 a tenth is added to 0.7 of that."""
    estimates = remembered(b.WholePast())
    policy = begun(b.Proportional(0.3))
    expected = [0.1 + 0.7 * share / 7 for share in (2, 4, 1)]
    for u, index in ((0.0, 0), (0.28, 0), (0.29, 1), (0.85, 1), (0.86, 2)):  # 2/7 = 0.2857
        assert policy.choose(estimates, scripted(0.3, u)) == (index, pytest.approx(expected[index]))
    assert policy.choose(estimates, scripted(0.29, 0.34)) == (1, pytest.approx(expected[1]))


def test_epsilon_greedy():
    """Best is 1: it has 0.7 + 0.1, the others 0.1."""
    estimates, policy = remembered(b.WholePast()), begun(b.EpsilonGreedy(0.3))
    assert policy.choose(estimates, scripted(0.3, 0.99)) == (1, pytest.approx(0.8))
    assert policy.choose(estimates, scripted(0.29, 0.99)) == (2, pytest.approx(0.1))
    tied = remembered(b.WholePast(), told=[(0, 1.0), (2, 1.0)])
    assert policy.choose(tied, scripted(0.3, 0.49)) == (0, pytest.approx(0.1 + 0.35))
    assert policy.choose(tied, scripted(0.3, 0.51)) == (2, pytest.approx(0.1 + 0.35))


def test_softmax():
    """Means 2, 4, 1 of 4, at temperature 0.5: exponents 1, 2, 0.5."""
    estimates = remembered(b.WholePast())
    weights = [math.exp(1), math.exp(2), math.exp(0.5)]
    total = sum(weights)
    for policy in (b.Softmax(0.5), b.Softmax(2.0, scaled=False)):
        for u, index in (
            (weights[0] / total - 1e-9, 0),
            (weights[0] / total + 1e-9, 1),
            (1 - 1e-9, 2),
        ):
            chosen, probability = begun(policy).choose(estimates, scripted(u))
            assert (chosen, probability) == (
                index,
                pytest.approx(weights[index] / total, rel=1e-13),
            )


def assert_turns_at(xi, estimates):
    """Assert that UCB prefers part 0, tried less often, if and only if its xi is more than this."""
    parts = len(estimates.means)
    for factor, part in ((1 - 1e-12, 1), (1 + 1e-12, 0)):
        assert begun(b.UCB(xi * factor), parts=parts).choose(estimates, scripted(0.5)) == (
            part,
            1.0,
        )


def test_ucb_of_the_whole_past():
    """Means 1 and 2 of 1 and 4 rewards: 1 + 4 r = 2 + 2 r for r = sqrt(xi ln 5) = 1/2."""
    estimates = remembered(b.WholePast(), parts=2, told=[(0, 1.0)] + [(1, 2.0)] * 4)
    assert_turns_at(0.25 / math.log(5), estimates)


def test_ucb_of_a_recent_window():
    """The last 5 of 7 rewards: part 0 earned 1, part 1 earned 2, and part 2 earned nothing yet."""
    told = [(0, 4.0), (1, 0.0), (0, 1.0)] + [(1, 2.0)] * 4
    assert_turns_at(0.25 / math.log(5), remembered(b.RecentWindow(5), parts=2, told=told))
    # While fewer rewards than the window are there, it is their number that counts.
    assert_turns_at(0.25 / math.log(5), remembered(b.RecentWindow(50), parts=2, told=told[2:]))
    never = remembered(b.RecentWindow(5), told=told)
    assert begun(b.UCB(0.0)).choose(never, scripted(0.99)) == (2, 1.0)


def test_ucb_of_discounted_rewards():
    """Weights 1/4 and 1/2 + 1 of means 1 and 2: 1 + 8 r = 2 + 4 sqrt(2/3) r."""
    estimates = remembered(b.Discounted(0.5), parts=2, told=[(0, 1.0), (1, 2.0), (1, 2.0)])
    assert estimates.counts == [0.25, 1.5]
    r = 1 / (8 - 4 * math.sqrt(2 / 3))
    assert_turns_at(r * r / math.log(1.75), estimates)


@pytest.mark.parametrize(
    "estimator", [b.WholePast(), b.RecentWindow(50), b.Discounted(0.9)], ids=repr
)
def test_ucb_tries_each_once_before_any_is_told(estimator):
    estimates = estimator.start(4, B)
    policy, rng = begun(b.UCB(2.0), parts=4), np.random.default_rng(0)
    for _ in range(3):
        assert sorted(policy.choose(estimates, rng)[0] for _ in range(4)) == [0, 1, 2, 3]


def test_ucb_counts_what_was_asked_and_not_told():
    """Asked, part 0 counts as tried twice: then 1 is next; told, the two are tried as often."""
    estimates = remembered(b.WholePast(), parts=2, told=[(0, 1.5), (1, 1.0)])
    policy = begun(b.UCB(2.0), parts=2)
    assert policy.choose(estimates, scripted(0.5)) == (0, 1.0)
    # 1.5 + 4 sqrt(2 ln 3 / 2) = 5.69 is less than 1 + 4 sqrt(2 ln 3) = 6.93.
    assert policy.choose(estimates, scripted(0.5)) == (1, 1.0)
    estimates.add(0, 1.5)
    policy.learn(0, 1.5, 1.0)
    # Each counts 2. If part 0 still counted 3, 1.5 + 4 sqrt(2 ln 5 / 3) = 5.64 would be less than
    # 1 + 4 sqrt(2 ln 5 / 2) = 6.07.
    assert policy.choose(estimates, scripted(0.5)) == (0, 1.0)


def test_thompson():
    """Means 2, 4, 1 and 4 / sqrt(3), 4 / sqrt(2), 4 / sqrt(4) times the quantiles."""
    estimates = remembered(b.WholePast())
    # Quantile(0.975) = 1.96: 2 + 4.53 = 6.53 beats 4 + 0, and 1 + 2 * 1.96 = 4.92 alone.
    assert begun(b.Thompson()).choose(estimates, scripted(0.975, 0.5, 0.5)) == (0, None)
    assert begun(b.Thompson()).choose(estimates, scripted(0.5, 0.5, 0.975)) == (2, None)
    assert begun(b.Thompson()).choose(estimates, scripted(0.5, 0.5, 0.93)) == (
        1,
        None,
    )  # 1 + 2 * 1.476 < 4
    assert begun(b.Thompson()).choose(estimates, scripted(0.5, 0.0, 0.0)) == (0, None)


def test_thompson_chooses_each_as_often_as_it_is_the_best():
    """Of two normals the first is larger with probability Phi((2 - 4) / sqrt(16/3 + 16/2))."""
    estimates = remembered(b.WholePast(), parts=2, told=REWARDS[:2] + REWARDS[3:4])
    policy, rng = begun(b.Thompson(), parts=2), np.random.default_rng(0)
    chosen = sum(policy.choose(estimates, rng)[0] == 0 for _ in range(20_000))
    p = stats.norm.cdf(-2 / math.sqrt(16 / 3 + 16 / 2))
    assert stats.binomtest(chosen, 20_000, p).pvalue > 1e-4


def probabilities(policy):
    """Return with which probabilities a policy chooses the two strategies that there are."""
    estimates = b.WholePast().start(2, B)
    chosen = [policy.choose(estimates, scripted(u)) for u in (0.0, 1.0 - 2.0**-53)]
    assert [part for part, _ in chosen] == [0, 1]
    return [probability for _, probability in chosen]


def test_exp3():
    """Gamma 0.4, two parts. Reward 3/4 at p = 0.5: the weight grows by exp(0.4 * 1.5 / 2)."""
    policy = begun(b.Exp3(0.4), parts=2)
    assert probabilities(policy) == [0.5, 0.5]
    policy.learn(1, 3.0, 0.5)
    w = math.exp(0.3)
    p = 0.6 * w / (1 + w) + 0.2
    assert probabilities(policy) == near(0.6 / (1 + w) + 0.2, p)
    policy.learn(0, 4.0, 0.25)  # told late: chosen with 0.25. exp(0.4 * 4 / 2)
    v = math.exp(0.8)
    assert probabilities(policy) == near(0.6 * v / (v + w) + 0.2, 0.6 * w / (v + w) + 0.2)
    policy.learn(0, 9.0, 1.0)  # clipped to 1: exp(0.4 / 2)
    v *= math.exp(0.2)
    assert probabilities(policy) == near(0.6 * v / (v + w) + 0.2, 0.6 * w / (v + w) + 0.2)
    policy.learn(1, -1.0, 0.5)  # clipped to 0
    assert probabilities(policy) == near(0.6 * v / (v + w) + 0.2, 0.6 * w / (v + w) + 0.2)
    policy.learn(1, 4.0, None)  # not known: with its probability now
    w *= math.exp(0.2 / (0.6 * w / (v + w) + 0.2))
    assert probabilities(policy) == near(0.6 * v / (v + w) + 0.2, 0.6 * w / (v + w) + 0.2)


def test_exp3_does_not_overflow_and_comes_back():
    policy = begun(b.Exp3(0.5), parts=2)
    for _ in range(100_000):
        policy.learn(0, B, 0.75)
    assert probabilities(policy) == near(0.75, 0.25)
    for _ in range(100_000 // 3 + 200):
        policy.learn(1, B, 0.25)
    assert probabilities(policy)[1] > 0.74


def test_exp3s():
    """Gamma 0.4, alpha 0.1, two parts: w = exp(0.3), and both gain e 0.1 / 2 of the old sum 2."""
    policy = begun(b.Exp3S(0.4, 0.1), parts=2)
    policy.learn(1, 3.0, 0.5)
    share = math.e * 0.1 / 2 * 2
    weights = [1 + share, math.exp(0.3) + share]
    total = sum(weights)
    assert probabilities(policy) == near(*(0.6 * w / total + 0.2 for w in weights))
    for _ in range(10_000):
        policy.learn(0, B, 0.8)
    # In the end the share f of the other stays: f (f + (1 - f) exp(0.25) + 0.1 e) = f + 0.05 e.
    g, s = math.exp(0.25), 0.05 * math.e
    f = (g + 2 * s - 1 - math.sqrt((g + 2 * s - 1) ** 2 - 4 * (g - 1) * s)) / (2 * (g - 1))
    assert probabilities(policy)[1] == pytest.approx(0.6 * f + 0.2, rel=1e-12)
    assert sum(probabilities(policy)) == pytest.approx(1, rel=1e-14)


def test_round_robin_and_uniform():
    estimates, turns = remembered(b.WholePast()), begun(b.RoundRobin())
    chosen = [turns.choose(estimates, scripted()) for _ in range(4)]
    assert chosen == [(0, 1.0), (1, 1.0), (2, 1.0), (0, 1.0)]
    assert begun(b.Uniform()).choose(estimates, scripted(0.34)) == (1, 1 / 3)


@pytest.mark.parametrize(
    ("policy", "draws"),
    [
        (b.Proportional(), 2),
        (b.EpsilonGreedy(0.5), 2),
        (b.Softmax(0.5), 1),
        (b.UCB(), 1),
        (b.Thompson(), 3),
        (b.Exp3(), 1),
        (b.Exp3S(), 1),
        (b.RoundRobin(), 0),
        (b.Uniform(), 1),
    ],
    ids=str,
)
@pytest.mark.parametrize("told", [[], REWARDS], ids=["nothing", "something"])
def test_a_choice_is_always_as_many_draws(policy, draws, told):
    estimates = remembered(b.Window(5), told=told)
    running = begun(policy)
    for _ in range(20):
        rng = scripted(*np.random.default_rng(0).random(10))
        running.choose(estimates, rng)
        assert draws_from(rng) == draws


@pytest.mark.parametrize(
    "policy",
    [
        b.Proportional(0.2),
        b.EpsilonGreedy(0.3),
        b.Softmax(0.5),
        b.Exp3(0.3),
        b.Exp3S(0.3, 0.01),
        b.Uniform(),
    ],
    ids=str,
)
def test_frequencies_are_the_probabilities(policy):
    """By chi-square at level 1e-4; the probabilities of all sum to 1."""
    estimates, n = remembered(b.WholePast()), 20_000
    running = begun(policy)
    for part, reward in REWARDS:
        running.learn(part, reward, 1 / 3)
    rng, said, counts = np.random.default_rng(0), {}, np.zeros(3)
    for _ in range(n):
        index, probability = running.choose(estimates, rng)
        assert said.setdefault(index, probability) == probability
        counts[index] += 1
    assert sum(said.values()) == pytest.approx(1, rel=1e-14)
    assert stats.chisquare(counts, [n * said[index] for index in range(3)]).pvalue > 1e-4


class Best:
    """A user's estimator, which holds what it is given."""

    def __init__(self, means, counts=(1, 1), largest=B):
        self.means, self.counts, self.largest = means, counts, largest


@pytest.mark.parametrize("means", [(1, 3), [1.0, 3.0], np.array([1.0, 3.0])], ids=type)
def test_estimates_may_be_a_users(means):
    policy = begun(b.Proportional(0.0), parts=2)
    assert isinstance(policy, b.RunningPolicy)
    assert policy.choose(Best(means), scripted(0.5, 0.3)) == (1, 0.75)


@pytest.mark.parametrize(
    ("estimates", "error", "message"),
    [
        (Best([1.0]), ValueError, r"estimates.means must have shape \(2,\), got \(1,\)"),
        (Best([1.0, 2.0], [1]), ValueError, r"estimates.counts must have shape \(2,\)"),
        (Best([1.0, math.nan]), ValueError, r"estimates.means\[1\] must be finite, got NaN"),
        (Best([1.0, 2.0], [1, math.inf]), ValueError, r"estimates.counts\[1\] must be finite"),
        (Best([1.0, 2.0], largest=math.inf), ValueError, "estimates.largest must be finite"),
        (Best([1.0, 2.0], largest=None), TypeError, "estimates.largest must be a number"),
        (Best("ab"), TypeError, "estimates.means must be an array of real numbers"),
        (b.WholePast().start(3, B), ValueError, "estimates.means must have length 2, got 3"),
        (None, AttributeError, "means"),
    ],
)
def test_refuses_estimates(estimates, error, message):
    policy, rng = begun(b.RoundRobin(), parts=2), scripted()
    with pytest.raises(error, match=message):
        policy.choose(estimates, rng)
    assert policy.choose(Best([0.0, 0.0]), rng) == (0, 1.0)


def test_refuses_what_is_no_generator():
    with pytest.raises(TypeError, match=r"rng must be a numpy.random.Generator, got NoneType"):
        begun(b.RoundRobin()).choose(remembered(b.WholePast()), None)


@pytest.mark.parametrize(
    ("call", "message"),
    [
        ((2, 1.0, 0.5), "part must be from 0 to 1, got 2"),
        ((0, math.inf, 0.5), "reward must be finite, got inf"),
        ((0, 1.0, 0.0), r"probability must be in \(0, 1\], got 0.0"),
        ((0, 1.0, 1.5), r"probability must be in \(0, 1\], got 1.5"),
        ((0, 1.0, math.nan), r"probability must be in \(0, 1\], got NaN"),
    ],
)
def test_refuses_what_it_cannot_learn(call, message):
    policy = begun(b.Exp3(), parts=2)
    with pytest.raises(ValueError, match=message):
        policy.learn(*call)
    assert probabilities(policy) == [0.5, 0.5]


def test_refuses_to_start():
    with pytest.raises(ValueError, match="parts must be at least 1, got 0"):
        b.Uniform().start(0, B)
    with pytest.raises(TypeError, match="policy of the library, got Best"):
        _core.Policy(Best([0.0]), 2, B)


@pytest.mark.parametrize(
    ("weights", "u", "message"),
    [
        ([], 0.5, "weights must not be empty"),
        ([1.0], 1.0, r"u must be in \[0, 1\), got 1.0"),
        ([1.0], math.nan, r"u must be in \[0, 1\), got NaN"),
    ],
)
def test_proportionally_refuses(weights, u, message):
    with pytest.raises(ValueError, match=message):
        _core.proportionally(weights, u)


def test_powers_refuses():
    with pytest.raises(ValueError, match=r"power must be finite and not negative, got -1.0"):
        _core.powers([1.0], -1.0)
