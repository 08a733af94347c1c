"""What holds for every measure, and for a user's."""

import math
import threading

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

import divbandit as db
from divbandit._core import Measure as Running
from divbandit.measures import (
    BallCoverage,
    Coverage,
    Entropy,
    GridCoverage,
    Measure,
    RunningMeasure,
    Sparseness,
)
from divbandit.measures.start import start_measure
from tests.measures.every import NAMES, VALUES, Furthest, clustered, specified, started

# Multiples of a quarter meet borders of cells and each other; others lie anywhere.
coordinate = st.integers(-8, 8).map(lambda k: k / 4) | st.floats(-2, 2)
# Four coordinates, of which a measure takes as many as it has dimensions.
effects = st.lists(st.tuples(*[coordinate] * 4), min_size=1, max_size=25)


every = pytest.mark.parametrize("name", NAMES)
every_value = pytest.mark.parametrize("name", VALUES)


def of(name, points):
    """Return a measure of no effects and the effects in its dimension."""
    measure = started()[name]
    return measure, np.array(points)[:, : measure.dim]


def filled(name, n=60):
    measure = started()[name]
    measure.extend(clustered(measure.dim, n))
    return measure


def seen(measure):
    """Return what there is to see of a measure."""
    gains = [measure.gain(effect) for effect in clustered(measure.dim, 30, seed=9)]
    return len(measure), measure.measure, gains


@every
def test_is_a_running_measure(name):
    assert isinstance(started()[name], RunningMeasure)


@every_value
def test_is_a_measure(name):
    assert isinstance(VALUES[name][0], Measure)
    assert not isinstance(VALUES[name][0], RunningMeasure)


@pytest.mark.parametrize("other", [db.NearestNeighbors(2), db.Box([0], [1]), [], None])
def test_other_things_are_no_measures(other):
    assert not isinstance(other, (Measure, RunningMeasure))


@every
def test_begins_with_nothing(name):
    measure = started()[name]
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
    many, parts = started()[name], started()[name]
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


@every_value
@given(points=effects)
def test_equals_its_specification(name, points):
    """Each gain, and the measure, to the last bit."""
    value, dim = VALUES[name]
    measure, plain = value.start(dim), specified(value, dim)
    points = np.array(points)[:, :dim]
    assert measure.extend(points).tolist() == [plain.add(point) for point in points]
    if isinstance(value, Sparseness):
        assert measure.measure == plain.of(plain.effects)


@every_value
def test_the_core_measures_as_what_is_started(name):
    """An engine has a measure of balls without their log: with the same numbers."""
    value, dim = VALUES[name]
    running, measure, points = Running(value, dim), value.start(dim), clustered(dim)
    assert (running.dim, running.largest_gain) == (measure.dim, measure.largest_gain)
    assert running.gain(points).tolist() == measure.gain(points).tolist()
    assert running.extend(points).tolist() == measure.extend(points).tolist()
    assert (running.measure, len(running)) == (measure.measure, len(measure))


@pytest.mark.parametrize("kind", [BallCoverage, GridCoverage, Sparseness, Entropy])
def test_a_class_that_derives_starts_what_its_base_would(kind):
    class Mine(kind):
        pass

    points = clustered(2)
    assert Mine(2).start(2).extend(points).tolist() == kind(2).start(2).extend(points).tolist()


@pytest.mark.parametrize("other", [Coverage(0.5), db.MotorBabbling(), 0.5, None])
def test_the_core_takes_measures_of_the_library_alone(other):
    with pytest.raises(TypeError, match=f"^value must be a measure .* got {type(other).__name__}$"):
        Running(other, 2)


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
    measure, other = started()[name], started()[name]
    points = clustered(measure.dim).astype(np.float32).astype(np.float64)
    assert other.extend(like(points)).tolist() == measure.extend(points).tolist()


@every
def test_effects_are_not_held_on_to(name):
    """Changing an array after it was given changes nothing."""
    measure = started()[name]
    points = clustered(measure.dim)
    point = points[0].copy()
    measure.add(point)
    measure.extend(points)
    before = seen(measure)
    point += 1.0
    points += 1.0
    assert seen(measure) == before


def test_other_threads_go_on_while_many_effects_are_added():
    """The interpreter is not held up; the measure itself is used by one call at a time."""
    measure, points = Sparseness(200).start(2), clustered(2, 3000)
    worker = threading.Thread(target=measure.extend, args=[points])
    worker.start()
    ticks = 0
    while worker.is_alive():
        ticks += 1
    worker.join()
    assert ticks > 100
    assert len(measure) == len(points)


def test_a_users_measure_is_copied_before_it_is_started():
    mine = Furthest()
    one, other = start_measure("measure", mine, 2), start_measure("measure", mine, 3)
    assert one.add([3, 4]) == 5.0
    assert (len(one), len(other), one.dim, other.dim) == (1, 0, 2, 3)
    assert not hasattr(mine, "dim")


def test_a_value_is_started_as_it_is():
    assert isinstance(start_measure("measure", BallCoverage(0.5), 3), Coverage)
    assert repr(start_measure("measure", GridCoverage(0.5), 3)).startswith("<GridCoverage(0.5)")


@pytest.mark.parametrize(
    ("measure", "got"),
    [(Coverage(0.02), "Coverage"), (0.02, "float"), (GridCoverage, "the class GridCoverage")],
)
def test_what_is_no_measure_is_refused(measure, got):
    message = rf"^here must be a Measure, such as BallCoverage\(0.02\), got {got}$"
    with pytest.raises(TypeError, match=message):
        start_measure("here", measure, 2)


class Returning(Furthest):
    """One whose start returns what it was given."""

    def __init__(self, running):
        self.running = running

    def start(self, dim):
        del dim
        return self.running


def filled_one():
    """Return a user's running measure that holds an effect already."""
    running = Furthest().start(2)
    running.add([1, 0])
    return running


def bounded_by(largest, dim=2):
    running = Furthest().start(2)
    running.largest_gain, running.dim = largest, dim
    return running


@pytest.mark.parametrize(
    ("running", "error", "message"),
    [
        (None, TypeError, "measure.start must return a RunningMeasure, got NoneType"),
        (Furthest, TypeError, "measure.start must return a RunningMeasure, got a class"),
        (filled_one(), ValueError, "measure.start must return an empty one, got 1 effects"),
        (bounded_by(1.0, 3), ValueError, "measure.start must return one of dim 2, got 3"),
        (bounded_by(1.0, 0), ValueError, "measure.start must return one of dim 2, got 0"),
        (bounded_by(1.0, 2.5), (TypeError, ValueError), "measure.start must return one of dim 2"),
        (bounded_by(-1.0), ValueError, "measure.largest_gain must be a finite number in"),
        (bounded_by(math.inf), ValueError, "measure.largest_gain must be a finite number in"),
        (bounded_by(math.nan), ValueError, "measure.largest_gain must be a finite number in"),
        (bounded_by("1"), TypeError, "measure.largest_gain must be a number, got str"),
        (bounded_by(None), TypeError, "measure.largest_gain must be a number, got NoneType"),
    ],
)
def test_what_is_no_running_measure_is_refused(running, error, message):
    with pytest.raises(error, match=f"^{message}"):
        start_measure("measure", Returning(running), 2)
