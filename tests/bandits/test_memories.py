"""The memories against plain lists of all credits, in fractions where these are exact."""

import copy
import pickle
from fractions import Fraction

import pytest
from hypothesis import given
from hypothesis import strategies as st

from divbandit.bandits import Discounted, RecentWindow, WholePast, Window

PARTS = 3
told = st.lists(st.tuples(st.integers(0, PARTS - 1), st.floats(-1e3, 1e3)), max_size=40)


def exact(values):
    return float(sum(map(Fraction, values))) / len(values) if values else 0.0


def after(memory, credits_, largest=0.0):
    memory.begin(PARTS, largest)
    for part, credit in credits_:
        memory.add(part, credit)
    return memory


def own(credits_, part):
    return [credit for owner, credit in credits_ if owner == part]


@given(told, st.integers(1, 10))
def test_recent_window(credits_, size):
    memory, kept = after(RecentWindow(size), credits_), credits_[-size:]
    assert memory.means == [exact(own(kept, part)) for part in range(PARTS)]
    assert memory.counts == [len(own(kept, part)) for part in range(PARTS)]


@given(told, st.integers(1, 10))
def test_window(credits_, size):
    memory = after(Window(size, head_start=0), credits_)
    assert memory.means == [exact(own(credits_, part)[-size:]) for part in range(PARTS)]


@given(told)
def test_whole_past(credits_):
    """To the rounding of the terms, of which the largest is 1000."""
    memory = after(WholePast(), credits_)
    expected = [exact(own(credits_, part)) for part in range(PARTS)]
    assert memory.means == pytest.approx(expected, rel=1e-15, abs=1e-12)
    assert memory.counts == [len(own(credits_, part)) for part in range(PARTS)]


@given(told, st.sampled_from([0.5, 0.9, 1.0]))
def test_discounted(credits_, gamma):
    memory = after(Discounted(gamma), credits_)
    for part in range(PARTS):
        weights = [
            Fraction(gamma) ** (len(credits_) - 1 - place)
            for place, (owner, _) in enumerate(credits_)
            if owner == part
        ]
        terms = zip(weights, own(credits_, part), strict=True)
        mean = sum(w * Fraction(c) for w, c in terms) / sum(weights) if weights else 0
        assert memory.means[part] == pytest.approx(float(mean), rel=1e-12, abs=1e-10)
        assert memory.counts[part] == pytest.approx(float(sum(weights)), rel=1e-12)


def test_a_discounted_mean_outlives_its_weight():
    memory = after(Discounted(0.5), [(0, 3.0)] + [(1, 1.0)] * 2000)
    assert (memory.means[:2], memory.counts[0]) == ([3.0, 1.0], 0.0)
    memory.add(0, 5.0)
    assert memory.means[0] == 5.0


@pytest.mark.parametrize(
    "memory", [Window(5), RecentWindow(5), Discounted(0.9), WholePast()], ids=repr
)
def test_the_largest_credit(memory):
    """Where credits have a bound it is that; else the largest absolute one so far."""
    assert after(memory, [(0, 3.0), (1, -7.0), (0, 2.0)]).largest == 7.0
    assert after(memory, [(0, 3.0), (1, -7.0)], largest=2.0).largest == 2.0
    assert after(memory, []).largest == 0.0
    for way in (copy.deepcopy, lambda x: pickle.loads(pickle.dumps(x))):  # noqa: S301
        one = after(memory, [(0, 3.0), (1, 1.0)] * 4)
        other = way(one)
        for each in (one, other):
            each.add(0, 0.7)
        assert (one.means, one.counts) == (other.means, other.counts)
