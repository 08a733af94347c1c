"""Entropy: histograms worked out on paper, and computed afresh in many digits."""

import math
from collections import Counter

import mpmath
import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from divbandit.measures import Entropy
from tests.reference import measures as reference


def placed(counts):
    """Return effects of which so many lie in each cell of edge 1, one cell after the other."""
    return [[index + 0.5] for index, count in enumerate(counts) for _ in range(count)]


def entropy_of(counts):
    """Return the entropy of a histogram, by its definition and in 40 digits."""
    with mpmath.workdps(40):
        n = mpmath.mpf(sum(counts))
        return -mpmath.fsum(c / n * mpmath.log(c / n) for c in counts if c)


def rounding(n):
    """Return how much an entropy of n effects may be off: as the logarithms in it are."""
    return 2 * math.ulp(math.log(n))


@pytest.mark.parametrize(
    ("counts", "expected"),
    [
        ([1], 0.0),
        ([1000], 0.0),
        ([1, 1], math.log(2)),
        ([7, 7, 7, 7], math.log(4)),
        ([1, 3], 2 * math.log(2) - 0.75 * math.log(3)),
        ([2, 1, 1], 1.5 * math.log(2)),
    ],
)
def test_by_hand(counts, expected):
    entropy = Entropy(1.0).start(1)
    entropy.extend(placed(counts))
    assert entropy.measure == pytest.approx(expected, rel=1e-15, abs=0)


def test_gains_are_changes_and_may_be_negative():
    entropy = Entropy(1.0).start(1)
    gains = entropy.extend([[0.5], [1.5], [0.5], [1.5]])
    third = math.log(3) - 2 / 3 * math.log(2)
    expected = [0.0, math.log(2), third - math.log(2), math.log(2) - third]
    np.testing.assert_allclose(gains, expected, rtol=1e-14)
    assert gains[2] < 0


@given(st.lists(st.integers(1, 40), min_size=1, max_size=12))
def test_equals_the_definition(counts):
    entropy = Entropy(1.0).start(1)
    entropy.extend(placed(counts))
    assert entropy.measure == reference.entropy(counts)
    assert abs(entropy.measure - entropy_of(counts)) <= rounding(sum(counts))


@given(st.lists(st.integers(-3, 3), min_size=1, max_size=40), st.randoms(use_true_random=False))
def test_the_measure_does_not_depend_on_the_order(places, random):
    one, other = Entropy(1.0).start(1), Entropy(1.0).start(1)
    one.extend([[place] for place in places])
    other.extend([[place] for place in random.sample(places, len(places))])
    assert one.measure == other.measure


@given(st.lists(st.integers(0, 30), min_size=1, max_size=60))
def test_lies_between_zero_and_the_logarithm_of_the_cells(places):
    entropy = Entropy(1.0).start(1)
    for place in places:
        gain = entropy.add([place])
        assert gain <= entropy.largest_gain == math.log(2)
    assert 0.0 <= entropy.measure <= math.log(len(set(places))) + rounding(len(places))
    assert (entropy.measure == 0.0) == (len(set(places)) == 1)


def test_after_many_adds_it_agrees_with_a_fresh_computation():
    """150,000 effects in 10,000 cells of very different counts, without any drift."""
    rng = np.random.default_rng(0)
    effects = (rng.exponential(0.03, (150_000, 2)) * 100 // 1) / 100 + 0.005
    entropy = Entropy(0.01).start(2)
    entropy.extend(effects)
    counts = Counter(map(tuple, np.floor(effects / 0.01).tolist())).values()
    assert entropy.measure == reference.entropy(counts)
    assert abs(entropy.measure - entropy_of(counts)) <= rounding(len(effects))


def test_one_outlier_among_many():
    """log n and the sum cancel to seven digits here; what remains is right to eleven."""
    entropy = Entropy(1.0).start(1)
    entropy.extend(placed([100_000, 1]))
    assert entropy.measure == reference.entropy([100_000, 1])
    assert abs(entropy.measure - entropy_of([100_000, 1])) <= rounding(100_001)


def test_too_many_cells_away():
    entropy = Entropy(1e-10).start(2)
    entropy.extend([[0.0, 0.0], [1.0, 1.0]])
    with pytest.raises(ValueError, match=r"effects\[1, 0\] must be within 1.7e308 cells of 0.0"):
        entropy.extend([[2.0, 2.0], [1e300, 0.0]])
    assert (len(entropy), entropy.measure) == (2, math.log(2))


def test_a_dimension_that_does_not_fit():
    with pytest.raises(ValueError, match=r"^cell must have length 1, got 2$"):
        Entropy([1.0, 2.0]).start(1)


def test_says_what_it_is():
    entropy = Entropy(0.5).start(2)
    entropy.extend([[0, 0], [0, 0]])
    assert repr(entropy) == "<Entropy(0.5) of 2 effects in R^2, measure=0.0>"
