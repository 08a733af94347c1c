"""Laws of the gain that hold for any effects, generic or degenerate, in every kind of space.

Where gains are exact they hold but for rounding, where they are estimated within some errors.
"""

import copy
import math
from fractions import Fraction

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

import divbandit as db

every = pytest.mark.parametrize("dim", [1, 2, 3, 5])

# Dyadic coordinates meet in exactly common points; others are generic; both mix.
dyadic = st.integers(-8, 8).map(lambda k: k / 4)
generic = st.floats(-2, 2).filter(lambda x: x == 0 or abs(x) > 1e-12)
# Five coordinates, of which a space takes as many as it has dimensions.
effect = st.tuples(*[dyadic | generic] * 5)
effects = st.lists(effect, min_size=1, max_size=25)
radius = st.sampled_from([0.125, 0.25, 0.5, 1.0, 0.02, 0.3, math.sqrt(0.5), 1.5, 2.0])


def empty(tau, dim):
    return db.Coverage(tau, dim=dim, accuracy=0.05, rng=0)


def covering(points, tau, dim):
    cov = empty(tau, dim)
    for point in points:
        cov.add(point[:dim])
    return cov


def cut(points, dim):
    return np.array(points)[:, :dim]


def slack(*standard_errors, ball):
    """Return how far two numbers with these errors may be apart."""
    return 5 * math.hypot(*standard_errors) + 1e-13 * ball


@every
@given(points=effects, tau=radius)
def test_a_gain_is_at_least_zero_and_at_most_a_ball(dim, points, tau):
    cov = empty(tau, dim)
    gains = cov.extend(cut(points, dim))
    assert np.all(gains >= 0)
    assert np.all(gains <= cov.largest_gain)
    assert gains[0] == cov.largest_gain
    assert gains.tolist() == cov.gains.tolist()
    assert np.array_equal(cov.effects, cut(points, dim))
    assert cov.measure == db.coverage(cut(points, dim), tau, accuracy=0.05, rng=0)
    assert cov.measure == pytest.approx(math.fsum(gains), rel=1e-15)
    assert np.all(cov.standard_errors >= 0)
    assert np.all(np.isfinite(cov.standard_errors))


@every
@given(points=effects, new=effect, tau=radius)
def test_gain_is_what_add_returns_and_changes_nothing(dim, points, new, tau):
    cov, new = covering(points, tau, dim), new[:dim]
    before = (len(cov), cov.measure, cov.standard_error)
    gain, error = cov.gain(new, with_error=True)
    assert cov.gain(new) == gain
    assert (len(cov), cov.measure, cov.standard_error) == before
    assert cov.add(new) == gain
    assert len(cov) == before[0] + 1
    assert (cov.gains[-1], cov.standard_errors[-1]) == (gain, error)


@every
@given(points=effects, tau=radius, random=st.randoms(use_true_random=False))
def test_the_measure_does_not_depend_on_the_order(dim, points, tau, random):
    one = covering(points, tau, dim)
    other = covering(random.sample(points, len(points)), tau, dim)
    off = 5 * math.hypot(one.standard_error, other.standard_error)
    assert one.measure == pytest.approx(other.measure, rel=1e-12, abs=off)


@every
@given(points=effects, more=effect, new=effect, tau=radius)
def test_gains_diminish(dim, points, more, new, tau):
    """An effect gains no more after another than before it."""
    cov = covering(points, tau, dim)
    before, error = cov.gain(new[:dim], with_error=True)
    cov.add(more[:dim])
    after, other = cov.gain(new[:dim], with_error=True)
    assert after <= before + slack(error, other, ball=cov.largest_gain)


@every
@given(points=effects, tau=radius, moved=st.tuples(*[st.integers(-1000, 1000)] * 5))
def test_translation_changes_nothing_but_rounding(dim, points, tau, moved):
    one = covering(points, tau, dim)
    other = covering(np.array(points) + np.array(moved) / 16, tau, dim)
    off = 5 * math.hypot(one.standard_error, other.standard_error)
    assert one.measure == pytest.approx(other.measure, rel=1e-6, abs=off)


@every
@given(
    points=st.lists(st.tuples(*[dyadic] * 5), min_size=1, max_size=25),
    tau=st.sampled_from([0.125, 0.25, 0.5, 1.0, 2.0]),
    moved=st.tuples(*[dyadic] * 5),
)
def test_translation_without_rounding_changes_no_bit(dim, points, tau, moved):
    """By whole cells of the grids that neighbours are looked up in, so that they come in order."""
    there = np.array(points) + 1024 * np.array(moved)
    gains = empty(tau, dim).extend(cut(points, dim))
    assert empty(tau, dim).extend(cut(there, dim)).tolist() == gains.tolist()


@pytest.mark.parametrize("dim", [1, 2, 3])
@given(
    points=st.lists(st.tuples(*[dyadic] * 3), min_size=1, max_size=25),
    tau=radius,
    moved=st.tuples(*[dyadic] * 3),
)
def test_translation_across_cells_changes_a_few_units_in_the_last_place(dim, points, tau, moved):
    there = np.array(points) + 1024 * np.array(moved)
    one, other = covering(points, tau, dim), covering(there, tau, dim)
    assert np.all(abs(one.gains - other.gains) <= 1e-14 * one.largest_gain)


@pytest.mark.parametrize("dim", [2, 3, 5])
def test_rotation_changes_nothing_but_rounding(dim):
    rng = np.random.default_rng(4)
    tau = [None, None, 0.1, 0.3, None, 0.8][dim]
    points = rng.uniform(-1, 1, (200, dim))
    for _ in range(4):
        turned = points @ np.linalg.qr(rng.standard_normal((dim, dim)))[0]
        one, other = covering(points, tau, dim), covering(turned, tau, dim)
        off = np.hypot(one.standard_errors, other.standard_errors)
        assert np.all(abs(one.gains - other.gains) <= 6 * off + 1e-13 * one.largest_gain)


@every
@given(points=effects, tau=radius, data=st.data())
def test_a_repeated_effect_gains_nothing(dim, points, tau, data):
    cov = covering(points, tau, dim)
    repeated = data.draw(st.sampled_from(points))[:dim]
    assert cov.gain(repeated, with_error=True) == (0, 0)
    assert cov.add(repeated) == 0


@every
@given(points=effects, tau=radius, data=st.data())
def test_a_contribution_is_the_difference_of_two_totals(dim, points, tau, data):
    points = cut(points, dim)
    index = data.draw(st.integers(0, len(points) - 1))
    whole, rest = covering(points, tau, dim), empty(tau, dim)
    rest.extend(np.delete(points, index, axis=0))
    before = (len(whole), whole.measure)
    lost, error = whole.contribution(index, with_error=True)
    assert whole.contribution(index) == whole.contribution(index - len(points)) == lost
    assert (len(whole), whole.measure) == before
    assert 0 <= lost <= whole.largest_gain
    errors = error, whole.standard_error, rest.standard_error
    off = 5 * math.hypot(*errors) + 1e-12 * whole.measure
    assert lost == pytest.approx(whole.measure - rest.measure, rel=0, abs=off)


@every
@given(points=effects, queries=effects, tau=radius)
def test_contains_is_being_near_some_effect(dim, points, queries, tau):
    cov, queries = covering(points, tau, dim), cut(queries, dim)
    inside = cov.contains(queries)
    assert inside.dtype == bool
    assert inside.tolist() == [cov.contains(query) for query in queries]
    for query, got in zip(queries.tolist(), inside, strict=True):
        squared = min(
            sum((Fraction(a) - Fraction(b)) ** 2 for a, b in zip(query, point, strict=False))
            for point in points
        )
        # On the border itself only exact roots decide; all else is more than rounding away.
        if squared == Fraction(tau) ** 2 or abs(float(squared) / tau**2 - 1) > 1e-14:
            assert got == (squared <= Fraction(tau) ** 2)
    assert cov.contains(cut(points, dim)).all()


@every
@pytest.mark.parametrize("duplicate", [copy.copy, copy.deepcopy])
def test_a_copy_goes_its_own_way(duplicate, dim):
    cov = covering([(0, 0, 0, 0, 0), (0.5, 0, 0, 0, 0)], 1.0, dim)
    other = duplicate(cov)
    measure = cov.measure
    assert (other.tau, other.dim, len(other), other.measure) == (1.0, dim, 2, measure)
    assert (other.accuracy, other.exact) == (cov.accuracy, cov.exact)
    gain = other.add([0.75] * dim)
    assert (len(cov), cov.measure) == (2, measure)
    assert cov.add([0.75] * dim) == gain


@every
@pytest.mark.parametrize("index", [3, -4, 2**63, -(2**63), 10**30, -(10**30)])
def test_no_such_effect_is_an_index_error(dim, index):
    cov = covering([[x] * 5 for x in range(3)], 1.0, dim)
    with pytest.raises(IndexError, match=rf"index must be that of one of 3 effects, got {index}$"):
        cov.contribution(index)
    assert cov.contribution(np.int8(-3)) == cov.contribution(0)
    with pytest.raises(IndexError, match="one of 0 effects"):
        empty(1.0, dim).contribution(0)
