"""What holds for every measure, compiled or not."""

import math

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

import divbandit as db
from tests.measures.every import (
    COPIES,
    NAMES,
    clustered,
    fresh,
)

# Multiples of a quarter meet borders of cells and each other; others lie anywhere.
coordinate = st.integers(-8, 8).map(lambda k: k / 4) | st.floats(-2, 2)
# Four coordinates, of which a measure takes as many as it has dimensions.
effects = st.lists(st.tuples(*[coordinate] * 4), min_size=1, max_size=25)


every = pytest.mark.parametrize("name", NAMES)


def of(name, points):
    """Return an empty measure and the effects in its dimension."""
    measure = fresh()[name]
    return measure, np.array(points)[:, : measure.dim]


def filled(name, n=60):
    measure = fresh()[name]
    measure.extend(clustered(measure.dim, n))
    return measure


def seen(measure):
    """Return what there is to see of a measure."""
    gains = [measure.gain(effect) for effect in clustered(measure.dim, 30, seed=9)]
    return len(measure), measure.measure, gains


@every
def test_is_a_measure(name):
    assert isinstance(fresh()[name], db.Measure)


@pytest.mark.parametrize("other", [db.NearestNeighbors(2), db.Box([0], [1]), [], None])
def test_other_things_are_no_measures(other):
    assert not isinstance(other, db.Measure)


@every
def test_begins_with_nothing(name):
    measure = fresh()[name]
    assert (len(measure), measure.measure) == (0, 0.0)
    assert type(measure.measure) is float


@every
@given(points=effects)
def test_gain_is_what_add_returns_and_changes_nothing(name, points):
    measure, points = of(name, points)
    for count, point in enumerate(points):
        before = (len(measure), measure.measure)
        gain = measure.gain(point)
        assert (len(measure), measure.measure) == before
        added = measure.add(point)
        assert added == gain
        assert type(added) is type(gain) is float
        assert len(measure) == count + 1


@every
@given(points=effects, new=effects)
def test_many_gains_are_each_by_itself(name, points, new):
    measure, points = of(name, points)
    new = np.array(new)[:, : measure.dim]
    measure.extend(points)
    before = (len(measure), measure.measure)
    gains = measure.gain(new)
    assert gains.dtype == np.float64
    assert gains.tolist() == [measure.gain(point) for point in new]
    assert (len(measure), measure.measure) == before


@every
@given(points=effects)
def test_extend_is_repeated_add_bit_for_bit(name, points):
    one, points = of(name, points)
    many, parts = fresh()[name], fresh()[name]
    gains = many.extend(points)
    assert (gains.dtype, gains.shape) == (np.float64, (len(points),))
    assert gains.tolist() == [one.add(point) for point in points]
    middle = len(points) // 2
    halves = [*parts.extend(points[:middle]), *parts.extend(points[middle:])]
    assert halves == gains.tolist()
    assert one.measure == many.measure == parts.measure
    assert len(one) == len(many) == len(parts) == len(points)


@every
@given(points=effects)
def test_the_measure_is_the_sum_of_gains(name, points):
    measure, points = of(name, points)
    gains = measure.extend(points)
    assert np.isfinite(gains).all()
    # Where gains cancel, as an entropy's do, a few units in the last place of the largest remain.
    scale = max(1.0, *np.abs(gains))
    assert measure.measure == pytest.approx(math.fsum(gains), rel=1e-13, abs=1e-14 * scale)


@every
@given(points=effects)
def test_no_gain_is_above_the_largest(name, points):
    measure, points = of(name, points)
    gains, largest = measure.extend(points), measure.largest_gain
    assert math.isfinite(largest)
    assert largest >= 0.0
    if name.startswith("sparseness"):
        assert largest == 0.0  # there is no bound
    else:
        assert gains.max() <= largest


@every
@pytest.mark.parametrize("way", COPIES)
def test_a_copy_goes_its_own_way(name, way):
    measure = filled(name)
    other = COPIES[way](measure)
    before = seen(measure)
    assert type(other) is type(measure)
    assert other.dim == measure.dim
    assert seen(other) == before
    more = clustered(measure.dim, 50, seed=1) * 3
    gains = other.extend(more).tolist()
    assert seen(measure) == before
    assert measure.extend(more).tolist() == gains
    assert seen(measure) == seen(other) != before


@every
@pytest.mark.parametrize("way", COPIES)
def test_an_empty_one_is_copied_too(name, way):
    measure = fresh()[name]
    points = clustered(measure.dim)
    gains = COPIES[way](measure).extend(points).tolist()
    assert len(measure) == 0
    assert measure.extend(points).tolist() == gains


@every
@pytest.mark.parametrize("bad", [math.nan, math.inf, -math.inf])
def test_a_refused_effect_changes_nothing(name, bad):
    measure = filled(name)
    before = seen(measure)
    point = [0.5] * measure.dim
    refused = [*point[:-1], bad]
    where = measure.dim - 1
    with pytest.raises(ValueError, match=rf"effect\[{where}\] must be finite"):
        measure.add(refused)
    with pytest.raises(ValueError, match=rf"effect\[{where}\] must be finite"):
        measure.gain(refused)
    with pytest.raises(ValueError, match=rf"effects\[1, {where}\] must be finite"):
        measure.extend([point, refused, point])
    with pytest.raises(ValueError, match="effects must have shape"):
        measure.extend(point)
    with pytest.raises(ValueError, match="effect must have shape"):
        measure.add([point])
    assert seen(measure) == before


@every
def test_no_effects_are_no_gains(name):
    measure = filled(name)
    before = seen(measure)
    gains = measure.extend(np.empty((0, measure.dim)))
    assert (gains.shape, gains.dtype) == ((0,), np.float64)
    assert seen(measure) == before


@pytest.mark.parametrize(
    "like",
    [
        lambda effects: effects.tolist(),
        lambda effects: effects.astype(np.float32).astype(np.longdouble),
        np.asfortranarray,
        lambda effects: effects[::-1][::-1],
        lambda effects: np.repeat(effects, 2, axis=0)[::2],
    ],
)
@every
def test_arrays_of_any_kind_are_read(name, like):
    measure, other = fresh()[name], fresh()[name]
    points = clustered(measure.dim).astype(np.float32).astype(np.float64)
    assert other.extend(like(points)).tolist() == measure.extend(points).tolist()


@every
def test_effects_are_not_held_on_to(name):
    """Changing an array after it was given changes nothing."""
    measure = fresh()[name]
    points = clustered(measure.dim)
    point = points[0].copy()
    measure.add(point)
    measure.extend(points)
    before = seen(measure)
    point += 1.0
    points += 1.0
    assert seen(measure) == before
