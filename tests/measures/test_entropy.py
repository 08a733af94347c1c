"""Entropy: histograms worked out on paper, and computed afresh in many digits."""

import decimal
import math
from collections import Counter

import mpmath
import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

import divbandit as db
from divbandit.measures import logarithm
from divbandit.measures.logarithm import fixed_log


def placed(counts):
    """Return effects of which so many lie in each cell of edge 1, one cell after the other."""
    return [[index + 0.5] for index, count in enumerate(counts) for _ in range(count)]


def entropy_of(counts):
    """Return the entropy of a histogram, by its definition and in 40 digits."""
    with mpmath.workdps(40):
        n = mpmath.mpf(sum(counts))
        return -mpmath.fsum(c / n * mpmath.log(c / n) for c in counts if c)


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
    entropy = db.Entropy(1.0, dim=1)
    entropy.extend(placed(counts))
    assert entropy.measure == pytest.approx(expected, rel=3e-16, abs=0)


def test_gains_are_changes_and_may_be_negative():
    entropy = db.Entropy(1.0, dim=1)
    gains = entropy.extend([[0.5], [1.5], [0.5], [1.5]])
    third = math.log(3) - 2 / 3 * math.log(2)
    expected = [0.0, math.log(2), third - math.log(2), math.log(2) - third]
    np.testing.assert_allclose(gains, expected, rtol=1e-14)
    assert gains[2] < 0


@given(st.lists(st.integers(1, 40), min_size=1, max_size=12))
def test_equals_the_definition(counts):
    entropy = db.Entropy(1.0, dim=1)
    entropy.extend(placed(counts))
    # Rounded once: even a small entropy is right to half a unit in its last place.
    assert entropy.measure == pytest.approx(float(entropy_of(counts)), rel=2.3e-16)


@given(st.lists(st.integers(-3, 3), min_size=1, max_size=40), st.randoms(use_true_random=False))
def test_the_measure_does_not_depend_on_the_order(places, random):
    one, other = db.Entropy(1.0, dim=1), db.Entropy(1.0, dim=1)
    one.extend([[place] for place in places])
    other.extend([[place] for place in random.sample(places, len(places))])
    assert one.measure == other.measure


@given(st.lists(st.integers(0, 30), min_size=1, max_size=60))
def test_lies_between_zero_and_the_logarithm_of_the_cells(places):
    entropy = db.Entropy(1.0, dim=1)
    for place in places:
        gain = entropy.add([place])
        assert gain <= entropy.largest_gain == math.log(2)
    assert 0.0 <= entropy.measure <= math.log(len(set(places))) * (1 + 3e-16)
    assert (entropy.measure == 0.0) == (len(set(places)) == 1)


def test_after_many_adds_it_agrees_with_a_fresh_computation():
    """150,000 effects in 10,000 cells of very different counts, without any drift."""
    rng = np.random.default_rng(0)
    effects = (rng.exponential(0.03, (150_000, 2)) * 100 // 1) / 100 + 0.005
    entropy = db.Entropy(0.01)
    entropy.extend(effects)
    counts = Counter(map(tuple, np.floor(effects / 0.01).tolist()))
    fresh = float(entropy_of(counts.values()))
    assert entropy.measure == pytest.approx(fresh, rel=2.3e-16)


def test_one_outlier_among_many():
    """log n and the sum cancel to seven digits here; the result is right to the last."""
    entropy = db.Entropy(1.0, dim=1)
    entropy.extend(placed([100_000, 1]))
    assert entropy.measure == pytest.approx(float(entropy_of([100_000, 1])), rel=1e-13)


def test_cells_are_those_of_grid_coverage():
    effects = np.random.default_rng(1).normal(size=(300, 3))
    grid = db.GridCoverage([0.5, 1.0, 0.1], dim=3, origin=[0, 0.3, 0])
    entropy = db.Entropy([0.5, 1.0, 0.1], dim=3, origin=[0, 0.3, 0])
    new = grid.extend(effects)
    gains = entropy.extend(effects)
    assert (entropy.cell, entropy.origin) == (grid.cell, grid.origin)
    # Most cells are occupied by one effect: a new one raises the entropy, an old one lowers it.
    assert ((gains > 0) == (new > 0))[1:].all()


def test_too_many_cells_away():
    entropy = db.Entropy(1e-10)
    entropy.extend([[0.0, 0.0], [1.0, 1.0]])
    with pytest.raises(ValueError, match=r"effects\[1, 0\] must be within 1.7e308 cells of 0.0"):
        entropy.extend([[2.0, 2.0], [1e300, 0.0]])
    assert (len(entropy), entropy.measure) == (2, math.log(2))


@pytest.mark.parametrize("first", [1, 250, 65_500, 999_983, 2**40 - 50, 10**15])
def test_logarithms_are_right_to_64_places(first):
    with mpmath.workdps(60):
        for count in range(first, first + 100):
            assert abs(fixed_log(count) - mpmath.log(count) * 2**64) < 1.01


def test_logarithms_of_small_counts_are_rounded_down():
    with mpmath.workdps(60):
        for count in range(1, 256):
            assert fixed_log(count) == int(mpmath.floor(mpmath.log(count) * 2**64))


def test_logarithms_do_not_depend_on_the_users_decimal_context():
    expected = fixed_log(12_345)
    fixed_log.cache_clear()
    logarithm._table.cache_clear()  # noqa: SLF001
    with decimal.localcontext(decimal.Context(prec=3, rounding=decimal.ROUND_UP)):
        assert fixed_log(12_345) == expected


def test_says_what_it_is():
    entropy = db.Entropy(0.5)
    entropy.extend([[0, 0], [0, 0]])
    assert repr(entropy) == "<Entropy of 2 effects, cell=(0.5, 0.5), measure=0.0>"
