"""The window of credits: a plain list cut to its last entries, and a mean that never drifts."""

import copy
import pickle
from fractions import Fraction

import pytest
from hypothesis import given
from hypothesis import strategies as st

from divbandit.bandits import Window

credits_ = st.lists(st.floats(-1e3, 1e3), max_size=30)


@given(credits_, st.integers(1, 8), st.data())
def test_equals_a_plain_list(values, size, data):
    count = data.draw(st.integers(0, size))
    window, kept = Window(size, head_start=count), [2.5] * count
    window.begin(1, 2.5)
    for credit in values:
        window.add(0, credit)
        kept = [*kept, credit][-size:]
        assert window.means == [float(sum(map(Fraction, kept))) / len(kept)]
        assert window.counts == [len(kept)]


def test_an_empty_window_has_mean_zero():
    window = Window(3, head_start=0)
    window.begin(2, 1.0)
    assert (window.means, window.counts) == ([0.0, 0.0], [0, 0])


@pytest.mark.parametrize(
    "way",
    [lambda x: x, copy.deepcopy, lambda x: pickle.loads(pickle.dumps(x))],  # noqa: S301
)
def test_never_drifts(way):
    """Large credits leave no rounding behind when they leave, also in a copy."""
    window = Window(2, head_start=1)
    window.begin(1, 1.0)
    for credit in [1e16, 0.1, 1e16, 0.1, 0.1, 0.1]:
        window.add(0, credit)
        window = way(window)
    assert window.means == pytest.approx([0.1], rel=1e-16)


def test_begins_anew():
    window = Window(2)
    window.begin(2, 1.0)
    window.add(0, 5.0)
    window.begin(3, 2.0)
    assert (window.means, window.counts, window.largest) == ([2.0] * 3, [1] * 3, 2.0)
