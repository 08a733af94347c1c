"""Laws of the gain that hold for any effects, generic or degenerate."""

import copy
import math

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

import divbandit as db

# Dyadic coordinates meet in exactly common points; others are generic; both mix.
dyadic = st.integers(-8, 8).map(lambda k: k / 4)
generic = st.floats(-2, 2).filter(lambda x: x == 0 or abs(x) > 1e-12)
effect = st.tuples(dyadic | generic, dyadic | generic)
effects = st.lists(effect, min_size=1, max_size=25)
radius = st.sampled_from([0.125, 0.25, 0.5, 1.0, 0.02, 0.3, math.sqrt(0.5)])


def covering(points, tau):
    cov = db.Coverage(tau)
    for point in points:
        cov.add(point)
    return cov


@given(effects, radius)
def test_a_gain_is_at_least_zero_and_at_most_a_ball(points, tau):
    gains = db.Coverage(tau).extend(points)
    assert np.all(gains >= 0)
    assert np.all(gains <= math.pi * tau * tau)
    assert gains[0] == math.pi * tau * tau


@given(effects, effect, radius)
def test_gain_is_what_add_returns_and_changes_nothing(points, new, tau):
    cov = covering(points, tau)
    before = (len(cov), cov.measure)
    gain = cov.gain(new)
    assert (len(cov), cov.measure) == before
    assert cov.add(new) == gain
    assert len(cov) == before[0] + 1


@given(effects, radius)
def test_extend_is_repeated_add_bit_for_bit(points, tau):
    one, many = db.Coverage(tau), db.Coverage(tau)
    gains = many.extend(points)
    assert gains.tolist() == [one.add(point) for point in points]
    assert many.measure == one.measure == db.coverage(points, tau)


@given(effects, radius)
def test_the_measure_is_the_sum_of_gains_and_never_shrinks(points, tau):
    cov, gains, last = db.Coverage(tau), [], 0.0
    for point in points:
        gains.append(cov.add(point))
        assert cov.measure >= last
        last = cov.measure
    assert cov.measure == pytest.approx(math.fsum(gains), rel=1e-15)


@given(effects, radius, st.randoms(use_true_random=False))
def test_the_measure_does_not_depend_on_the_order(points, tau, random):
    shuffled = random.sample(points, len(points))
    assert db.coverage(shuffled, tau) == pytest.approx(db.coverage(points, tau), rel=1e-12)


@given(effects, effect, effect, radius)
def test_gains_diminish(points, more, new, tau):
    """An effect gains no more after another than before it."""
    cov = covering(points, tau)
    before = cov.gain(new)
    cov.add(more)
    assert cov.gain(new) <= before + 1e-13 * tau**2


@given(effects, radius, st.integers(-1000, 1000), st.integers(-1000, 1000))
def test_translation_changes_nothing_but_rounding(points, tau, x, y):
    moved = np.array(points) + np.array([x, y]) / 16
    assert db.coverage(moved, tau) == pytest.approx(db.coverage(points, tau), rel=1e-6)


@given(st.lists(st.tuples(dyadic, dyadic), min_size=1, max_size=25), radius, dyadic, dyadic)
def test_translation_without_rounding_changes_no_bit(points, tau, x, y):
    moved = np.array(points) + 1024 * np.array([x, y])
    assert db.Coverage(tau).extend(moved).tolist() == db.Coverage(tau).extend(points).tolist()


@pytest.mark.parametrize("angle", [0.3, 1.0, math.pi / 2, 4.0])
def test_rotation_changes_nothing_but_rounding(angle):
    points = np.random.default_rng(4).uniform(-1, 1, (200, 2))
    c, s = math.cos(angle), math.sin(angle)
    turned = points @ np.array([[c, s], [-s, c]])
    expected = db.Coverage(0.1).extend(points)
    np.testing.assert_allclose(db.Coverage(0.1).extend(turned), expected, rtol=0, atol=1e-15)


@given(effects, radius, st.data())
def test_a_repeated_effect_gains_nothing(points, tau, data):
    cov = covering(points, tau)
    assert cov.add(data.draw(st.sampled_from(points))) == 0


@pytest.mark.parametrize("duplicate", [copy.copy, copy.deepcopy])
def test_a_copy_goes_its_own_way(duplicate):
    cov = covering([(0, 0), (0.5, 0)], 1.0)
    other = duplicate(cov)
    measure = cov.measure
    assert (other.tau, other.dim, len(other), other.measure) == (1.0, 2, 2, measure)
    gain = other.add([5, 5])
    assert (len(cov), cov.measure) == (2, measure)
    assert cov.add([5, 5]) == gain
