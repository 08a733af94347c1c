"""The estimators against plain lists of all rewards, in fractions where these are exact."""

import math
from fractions import Fraction

import pytest
from hypothesis import given
from hypothesis import strategies as st

from divbandit import _core
from divbandit.bandits import Discounted, Estimates, RecentWindow, WholePast, Window

PARTS = 3
ESTIMATORS = [Window(5), RecentWindow(5), Discounted(0.9), WholePast()]
told = st.lists(st.tuples(st.integers(0, PARTS - 1), st.floats(-1e3, 1e3)), max_size=40)


def after(estimator, rewards, largest=0.0):
    estimates = estimator.start(PARTS, largest)
    for part, reward in rewards:
        estimates.add(part, reward)
    return estimates


def own(rewards, part):
    return [reward for owner, reward in rewards if owner == part]


def test_a_window_never_drifts():
    """Large rewards leave no rounding behind when they leave."""
    window = Window(2, head_start=1).start(1, 1.0)
    for reward in [1e16, 0.1, 1e16, 0.1, 0.1, 0.1]:
        window.add(0, reward)
    assert window.means == pytest.approx([0.1], rel=1e-16)


def test_a_head_start_of_discounted_is_told_first():
    """Two parts, largest reward 4, gamma 1/2: part 0 gets weight 1/2, part 1 weight 1."""
    estimates = Discounted(0.5, head_start=1).start(2, 4.0)
    assert (estimates.means, estimates.counts) == ([4.0, 4.0], [0.5, 1.0])
    estimates.add(1, 1.0)  # (4 / 2 + 1) / (1 / 2 + 1)
    assert (estimates.means, estimates.counts) == ([4.0, 2.0], [0.25, 1.5])


@given(told, st.sampled_from([0.5, 0.9, 1.0]))
def test_discounted(rewards, gamma):
    estimates = after(Discounted(gamma), rewards)
    for part in range(PARTS):
        weights = [
            Fraction(gamma) ** (len(rewards) - 1 - place)
            for place, (owner, _) in enumerate(rewards)
            if owner == part
        ]
        terms = zip(weights, own(rewards, part), strict=True)
        mean = sum(w * Fraction(c) for w, c in terms) / sum(weights) if weights else 0
        assert estimates.means[part] == pytest.approx(float(mean), rel=1e-12, abs=1e-10)
        assert estimates.counts[part] == pytest.approx(float(sum(weights)), rel=1e-12)


def test_a_discounted_mean_outlives_its_weight():
    estimates = after(Discounted(0.5), [(0, 3.0)] + [(1, 1.0)] * 2000)
    assert (estimates.means[:2], estimates.counts[0]) == ([3.0, 1.0], 0.0)
    estimates.add(0, 5.0)
    assert estimates.means[0] == 5.0


@pytest.mark.parametrize("estimator", ESTIMATORS, ids=repr)
def test_the_largest_reward(estimator):
    """Where rewards have a bound it is that; else the largest absolute one so far."""
    assert after(estimator, [(0, 3.0), (1, -7.0), (0, 2.0)]).largest == 7.0
    assert after(estimator, [(0, 3.0), (1, -7.0)], largest=2.0).largest == 2.0
    assert after(estimator, []).largest == 0.0


@pytest.mark.parametrize("estimator", ESTIMATORS, ids=repr)
def test_what_starts_is_apart_from_the_value(estimator):
    """Two that the same value has started share nothing."""
    first, rewards = after(estimator, [(0, 3.0)]), [(0, 3.0), (1, 1.0)] * 4
    after(estimator, rewards)
    assert first.means == after(estimator, [(0, 3.0)]).means


@pytest.mark.parametrize("estimator", ESTIMATORS, ids=repr)
def test_what_starts_are_estimates(estimator):
    estimates = after(estimator, [(0, 3.0)], largest=3.0)
    assert isinstance(estimates, Estimates)
    estimates.means[0] = 7.0  # a list of the caller's
    assert estimates.means[0] == 3.0


@pytest.mark.parametrize(
    ("call", "error", "message"),
    [
        ((3, 1.0), ValueError, "part must be from 0 to 2, got 3"),
        ((-1, 1.0), ValueError, "part must be at least 0"),
        ((0.0, 1.0), TypeError, "part must be a whole number, got float"),
        ((0, math.nan), ValueError, "reward must be finite, got NaN"),
        ((0, math.inf), ValueError, "reward must be finite, got inf"),
        ((0, "1"), TypeError, "reward must be a number, got str"),
    ],
)
def test_refuses_what_it_cannot_add(call, error, message):
    estimates = after(WholePast(), [(0, 3.0)])
    with pytest.raises(error, match=message):
        estimates.add(*call)
    assert (estimates.means, estimates.counts) == ([3.0, 0.0, 0.0], [1.0, 0.0, 0.0])


@pytest.mark.parametrize(
    ("call", "error", "message"),
    [
        ((0, 1.0), ValueError, "parts must be at least 1, got 0"),
        ((2, -1.0), ValueError, "largest must be finite and not negative, got -1.0"),
        ((2, math.nan), ValueError, "largest must be finite and not negative, got NaN"),
        ((2, None), TypeError, "largest must be a number, got NoneType"),
    ],
)
def test_refuses_to_start(call, error, message):
    with pytest.raises(error, match=message):
        Window(5).start(*call)


class Mine(Window):
    """A class that derives from one of the library's."""


@pytest.mark.parametrize("value", [object(), Mine(5)])
def test_only_the_library_has_its_estimators_in_rust(value):
    with pytest.raises(TypeError, match=f"estimator of the library, got {type(value).__name__}"):
        _core.Estimator(value, 2, 1.0)
