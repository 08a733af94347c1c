"""Every rule against numbers worked out on paper, and its draws counted."""

import math

import numpy as np
import pytest
from scipy import stats

from divbandit.bandits import (
    UCB,
    Discounted,
    EpsilonGreedy,
    Exp3,
    Exp3S,
    Proportional,
    RecentWindow,
    RoundRobin,
    Softmax,
    Thompson,
    Uniform,
    WholePast,
    Window,
    discounted_ucb,
    sliding_window_ucb,
    ucb1,
)
from tests.bandits.script import Always, Scripted

B = 4.0
#: Part 0 earned 1 and 3, part 1 earned 4 once, part 2 earned 0, 0 and 3.
CREDITS = [(0, 1.0), (1, 4.0), (2, 0.0), (0, 3.0), (2, 0.0), (2, 3.0)]


def remembered(memory, *, parts=3, largest=B, told=CREDITS):
    memory.begin(parts, largest)
    for part, credit in told:
        memory.add(part, credit)
    return memory


def begun(rule, *, parts=3, largest=B):
    rule.begin(parts, largest)
    return rule


def near(*numbers):
    return pytest.approx(numbers, rel=1e-14)


def test_proportional():
    """Means 2, 4, 1: sevenths 2, 4, 1; with alpha = 0.3 a tenth is added to 0.7 of that."""
    memory = remembered(WholePast())
    rule = begun(Proportional(0.3))
    expected = [0.1 + 0.7 * share / 7 for share in (2, 4, 1)]
    for u, index in ((0.0, 0), (0.28, 0), (0.29, 1), (0.85, 1), (0.86, 2)):  # 2/7 = 0.2857
        assert rule.choose(memory, Scripted(0.3, u)) == (index, pytest.approx(expected[index]))
    assert rule.choose(memory, Scripted(0.29, 0.34)) == (1, pytest.approx(expected[1]))


def test_proportional_to_a_power():
    """Squares 4, 16, 1 of 21; roots sqrt 2, 2, 1."""
    memory = remembered(WholePast())
    for power, weights in ((2.0, (4, 16, 1)), (0.5, (math.sqrt(2), 2, 1)), (0.0, (1, 1, 1))):
        rule, u = begun(Proportional(0.0, power=power)), (weights[0] + 0.5) / sum(weights)
        assert rule.choose(memory, Scripted(0.5, u)) == (
            1,
            pytest.approx(weights[1] / sum(weights), rel=1e-14),
        )
    tiny = remembered(WholePast(), told=[(0, 1e-200), (1, 3e-200)])
    _, probability = begun(Proportional(0.0, power=3.0)).choose(tiny, Scripted(0.5, 0.5))
    assert probability == pytest.approx(27 / 28, rel=1e-12)


@pytest.mark.parametrize("means", [[0.0, 0.0], [-1.0, 0.0], [-1.0, -2.0]])
@pytest.mark.parametrize("power", [1.0, 2.0])
def test_proportional_is_uniform_where_none_is_positive(means, power):
    memory = remembered(WholePast(), parts=2, told=list(enumerate(means)))
    rule = begun(Proportional(0.0, power=power), parts=2)
    assert rule.choose(memory, Scripted(0.9, 0.49)) == (0, 0.5)
    assert rule.choose(memory, Scripted(0.9, 0.5)) == (1, 0.5)


def test_proportional_counts_negative_means_as_zero():
    memory = remembered(WholePast(), told=[(0, -5.0), (1, 1.0), (2, 3.0)])
    for u, index, probability in ((0.0, 1, 0.25), (0.24, 1, 0.25), (0.26, 2, 0.75)):
        assert begun(Proportional(0.0)).choose(memory, Scripted(0.5, u)) == (index, probability)


def test_epsilon_greedy():
    """Best is 1: it has 0.7 + 0.1, the others 0.1."""
    memory, rule = remembered(WholePast()), begun(EpsilonGreedy(0.3))
    assert rule.choose(memory, Scripted(0.3, 0.99)) == (1, pytest.approx(0.8))
    assert rule.choose(memory, Scripted(0.29, 0.99)) == (2, pytest.approx(0.1))
    tied = remembered(WholePast(), told=[(0, 1.0), (2, 1.0)])
    assert rule.choose(tied, Scripted(0.3, 0.49)) == (0, pytest.approx(0.1 + 0.35))
    assert rule.choose(tied, Scripted(0.3, 0.51)) == (2, pytest.approx(0.1 + 0.35))


def test_softmax():
    """Means 2, 4, 1 of 4, at temperature 0.5: exponents 1, 2, 0.5."""
    memory = remembered(WholePast())
    weights = [math.exp(1), math.exp(2), math.exp(0.5)]
    total = sum(weights)
    for rule in (Softmax(0.5), Softmax(2.0, scaled=False)):
        for u, index in (
            (weights[0] / total - 1e-9, 0),
            (weights[0] / total + 1e-9, 1),
            (1 - 1e-9, 2),
        ):
            chosen, probability = begun(rule).choose(memory, Scripted(u))
            assert (chosen, probability) == (
                index,
                pytest.approx(weights[index] / total, rel=1e-13),
            )


def test_softmax_knows_no_unit_before_the_first_credit():
    memory = remembered(WholePast(), largest=0.0, told=[])
    assert begun(Softmax(0.1), largest=0.0).choose(memory, Scripted(0.5)) == (1, 1 / 3)


def test_softmax_with_a_tiny_temperature_is_greedy():
    memory = remembered(WholePast())
    assert begun(Softmax(1e-300)).choose(memory, Scripted(0.999)) == (1, 1.0)


def test_ucb1():
    """Of 6 credits 2, 1, 3: means 2, 4, 1 plus 4 sqrt(2 ln 6 / n)."""
    bandit = ucb1([Always()] * 3)
    memory, rule = remembered(bandit.memory), begun(bandit.rule)
    log6 = 1.791759469228055
    assert rule.bounds(memory) == near(
        2 + 4 * math.sqrt(2 * log6 / 2),  # 7.3543
        4 + 4 * math.sqrt(2 * log6 / 1),  # 11.5721
        1 + 4 * math.sqrt(2 * log6 / 3),  # 5.3718
    )
    assert rule.choose(memory, Scripted(0.99)) == (1, 1.0)


def test_sliding_window_ucb():
    """The last 4 of 6 credits: part 0 earned 3, part 2 earned 0, 0, 3, part 1 nothing."""
    bandit = sliding_window_ucb([Always()] * 3, window=4, xi=0.7)
    memory, rule = remembered(bandit.memory), begun(bandit.rule)
    log4 = 1.3862943611198906
    assert rule.bounds(memory) == near(
        3 + 4 * math.sqrt(0.7 * log4 / 1), math.inf, 1 + 4 * math.sqrt(0.7 * log4 / 3)
    )
    # While fewer credits than the window are there, it is their number t that counts: here 2.
    early = remembered(RecentWindow(4), parts=2, told=CREDITS[:2])
    log2 = 0.6931471805599453
    assert begun(bandit.rule, parts=2).bounds(early) == near(
        1 + 4 * math.sqrt(0.7 * log2), 4 + 4 * math.sqrt(0.7 * log2)
    )


def test_discounted_ucb():
    """Three credits, weights 1/4, 1/2, 1: part 0 has 1 and 3 of weights 1/4 and 1, part 1 has 4."""
    bandit = discounted_ucb([Always()] * 2, gamma=0.5, xi=0.7)
    told = [(0, 1.0), (1, 4.0), (0, 3.0)]
    memory, rule = remembered(bandit.memory, parts=2, told=told), begun(bandit.rule, parts=2)
    assert memory.counts == [1.25, 0.5]
    known = 0.5596157879354227  # ln 1.75
    assert rule.bounds(memory) == near(
        (0.25 * 1 + 1 * 3) / 1.25 + 2 * 4 * math.sqrt(0.7 * known / 1.25),
        4 + 2 * 4 * math.sqrt(0.7 * known / 0.5),
    )


def test_ucb_without_a_bound_uses_the_largest_credit_so_far():
    memory = remembered(WholePast(), parts=2, largest=0.0, told=[(0, 1.0), (1, -3.0)])
    rule = begun(UCB(2.0), parts=2, largest=0.0)
    bonus = 3 * math.sqrt(2 * math.log(2))
    assert rule.bounds(memory) == near(1 + bonus, -3 + bonus)


@pytest.mark.parametrize("memory", [WholePast(), RecentWindow(50), Discounted(0.9)])
def test_ucb_tries_each_once_before_any_is_told(memory):
    memory.begin(4, B)
    rule, rng = begun(UCB(2.0), parts=4), np.random.default_rng(0)
    for _ in range(3):
        assert sorted(rule.choose(memory, rng)[0] for _ in range(4)) == [0, 1, 2, 3]


def test_ucb_counts_what_was_asked_and_not_told():
    """Told 1 each, part 0 asked twice more: ln 4 known, counts 3 and 1."""
    memory = remembered(WholePast(), parts=2, told=[(0, 2.0), (1, 1.0)])
    rule = begun(UCB(2.0), parts=2)
    assert rule.choose(memory, Scripted(0.5)) == (0, 1.0)
    bounds = [2 + 4 * math.sqrt(2 * math.log(3) / 2), 1 + 4 * math.sqrt(2 * math.log(3))]
    assert rule.bounds(memory) == near(*bounds)
    assert rule.choose(memory, Scripted(0.5)) == (1, 1.0)
    memory.add(0, 2.0)
    rule.learn(0, 2.0, 1.0)
    assert rule.bounds(memory) == near(
        2 + 4 * math.sqrt(2 * math.log(4) / 2), 1 + 4 * math.sqrt(2 * math.log(4) / 2)
    )


def test_ucb_breaks_ties_by_one_draw():
    memory = remembered(WholePast(), told=[(0, 1.0), (1, 2.0), (2, 2.0)])
    assert begun(UCB(2.0)).choose(memory, Scripted(0.49)) == (1, 0.5)
    assert begun(UCB(2.0)).choose(memory, Scripted(0.5)) == (2, 0.5)


def test_thompson():
    """Means 2, 4, 1 and 4 / sqrt(3), 4 / sqrt(2), 4 / sqrt(4) times the quantiles."""
    memory = remembered(WholePast())
    # Quantile(0.975) = 1.96: 2 + 4.53 = 6.53 beats 4 + 0, and 1 + 2 * 1.96 = 4.92 alone.
    assert begun(Thompson()).choose(memory, Scripted(0.975, 0.5, 0.5)) == 0
    assert begun(Thompson()).choose(memory, Scripted(0.5, 0.5, 0.975)) == 2
    assert begun(Thompson()).choose(memory, Scripted(0.5, 0.5, 0.93)) == 1  # 1 + 2 * 1.476 < 4
    assert begun(Thompson()).choose(memory, Scripted(0.5, 0.0, 0.0)) == 0


def test_thompson_chooses_each_as_often_as_it_is_the_best():
    """Of two normals the first is larger with probability Phi((2 - 4) / sqrt(16/3 + 16/2))."""
    memory = remembered(WholePast(), parts=2, told=CREDITS[:2] + CREDITS[3:4])
    rule, rng = begun(Thompson(), parts=2), np.random.default_rng(0)
    chosen = sum(rule.choose(memory, rng) == 0 for _ in range(20_000))
    p = stats.norm.cdf(-2 / math.sqrt(16 / 3 + 16 / 2))
    assert stats.binomtest(chosen, 20_000, p).pvalue > 1e-4


def test_exp3():
    """Gamma 0.4, two parts. Reward 3/4 at p = 0.5: the weight grows by exp(0.4 * 1.5 / 2)."""
    rule = begun(Exp3(0.4), parts=2)
    assert rule.choose(None, Scripted(0.49)) == (0, 0.5)
    rule.learn(1, 3.0, 0.5)
    w = math.exp(0.3)
    p = 0.6 * w / (1 + w) + 0.2
    assert rule.probabilities() == near(0.6 / (1 + w) + 0.2, p)
    rule.learn(0, 4.0, 0.25)  # told late: chosen with 0.25. exp(0.4 * 4 / 2)
    v = math.exp(0.8)
    assert rule.probabilities() == near(0.6 * v / (v + w) + 0.2, 0.6 * w / (v + w) + 0.2)
    rule.learn(0, 9.0, 1.0)  # clipped to 1: exp(0.4 / 2)
    v *= math.exp(0.2)
    assert rule.probabilities() == near(0.6 * v / (v + w) + 0.2, 0.6 * w / (v + w) + 0.2)
    rule.learn(1, -1.0, 0.5)  # clipped to 0
    assert rule.probabilities() == near(0.6 * v / (v + w) + 0.2, 0.6 * w / (v + w) + 0.2)


def test_exp3_does_not_overflow_and_comes_back():
    rule = begun(Exp3(0.5), parts=2)
    for _ in range(100_000):
        rule.learn(0, B, 0.75)
    assert rule.probabilities() == near(0.75, 0.25)
    for _ in range(100_000 // 3 + 200):
        rule.learn(1, B, 0.25)
    assert rule.probabilities()[1] > 0.74


def test_exp3s():
    """Gamma 0.4, alpha 0.1, two parts: w = exp(0.3), and both gain e 0.1 / 2 of the old sum 2."""
    rule = begun(Exp3S(0.4, 0.1), parts=2)
    rule.learn(1, 3.0, 0.5)
    share = math.e * 0.1 / 2 * 2
    weights = [1 + share, math.exp(0.3) + share]
    total = sum(weights)
    assert rule.probabilities() == near(*(0.6 * w / total + 0.2 for w in weights))
    for _ in range(10_000):
        rule.learn(0, B, 0.8)
    # In the end the share f of the other stays: f (f + (1 - f) exp(0.25) + 0.1 e) = f + 0.05 e.
    g, s = math.exp(0.25), 0.05 * math.e
    f = (g + 2 * s - 1 - math.sqrt((g + 2 * s - 1) ** 2 - 4 * (g - 1) * s)) / (2 * (g - 1))
    assert rule.probabilities()[1] == pytest.approx(0.6 * f + 0.2, rel=1e-12)
    assert sum(rule.probabilities()) == pytest.approx(1, rel=1e-14)


def test_round_robin_and_uniform():
    turns = begun(RoundRobin())
    assert [turns.choose(None, None) for _ in range(4)] == [(0, 1.0), (1, 1.0), (2, 1.0), (0, 1.0)]
    assert begun(Uniform()).choose(None, Scripted(0.34)) == (1, 1 / 3)


@pytest.mark.parametrize(
    ("rule", "draws"),
    [
        (Proportional(), 2),
        (EpsilonGreedy(0.5), 2),
        (Softmax(0.5), 1),
        (UCB(), 1),
        (Thompson(), 3),
        (Exp3(), 1),
        (Exp3S(), 1),
        (RoundRobin(), 0),
        (Uniform(), 1),
    ],
    ids=str,
)
@pytest.mark.parametrize("told", [[], CREDITS], ids=["nothing", "something"])
def test_a_choice_is_always_as_many_draws(rule, draws, told):
    memory = remembered(Window(5), told=told)
    begun(rule)
    for _ in range(20):
        rng = Scripted(*np.random.default_rng(0).random(draws))
        rule.choose(memory, rng)
        assert rng.numbers == []


@pytest.mark.parametrize(
    "rule",
    [Proportional(0.2), EpsilonGreedy(0.3), Softmax(0.5), Exp3(0.3), Exp3S(0.3, 0.01), Uniform()],
    ids=str,
)
def test_frequencies_are_the_probabilities(rule):
    """By chi-square at level 1e-4; the probabilities of all sum to 1."""
    memory, n = remembered(WholePast()), 20_000
    begun(rule)
    if hasattr(rule, "learn"):
        for part, credit in CREDITS:
            rule.learn(part, credit, 1 / 3)
    rng, said, counts = np.random.default_rng(0), {}, np.zeros(3)
    for _ in range(n):
        index, probability = rule.choose(memory, rng)
        assert said.setdefault(index, probability) == probability
        counts[index] += 1
    assert sum(said.values()) == pytest.approx(1, rel=1e-14)
    assert stats.chisquare(counts, [n * said[index] for index in range(3)]).pvalue > 1e-4
