"""The window of rewards: a plain list cut to its last entries, and a mean that never drifts."""

from fractions import Fraction

import pytest
from hypothesis import given
from hypothesis import strategies as st

from divbandit.bandits import Window

rewards = st.lists(st.floats(-1e3, 1e3), max_size=30)


@given(rewards, st.integers(1, 8), st.data())
def test_equals_a_plain_list(values, size, data):
    count = data.draw(st.integers(0, size))
    window, kept = Window(size, head_start=count).start(1, 2.5), [2.5] * count
    for reward in values:
        window.add(0, reward)
        kept = [*kept, reward][-size:]
        assert window.means == [float(sum(map(Fraction, kept))) / len(kept)]
        assert window.counts == [len(kept)]


def test_an_empty_window_has_mean_zero():
    window = Window(3, head_start=0).start(2, 1.0)
    assert (window.means, window.counts) == ([0.0, 0.0], [0, 0])


def test_never_drifts():
    """Large rewards leave no rounding behind when they leave."""
    window = Window(2, head_start=1).start(1, 1.0)
    for reward in [1e16, 0.1, 1e16, 0.1, 0.1, 0.1]:
        window.add(0, reward)
    assert window.means == pytest.approx([0.1], rel=1e-16)


def test_each_start_is_a_beginning():
    value = Window(2)
    value.start(2, 1.0).add(0, 5.0)
    window = value.start(3, 2.0)
    assert (window.means, window.counts, window.largest) == ([2.0] * 3, [1] * 3, 2.0)
