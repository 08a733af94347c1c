"""The window of gains: a plain list cut to its last entries, and a mean that never drifts."""

from fractions import Fraction

import pytest
from hypothesis import given
from hypothesis import strategies as st

from divbandit.bandits.window import GainWindow

gains = st.lists(st.floats(0, 1e3), max_size=30)


@given(gains, st.integers(1, 8), st.data())
def test_equals_a_plain_list(values, size, data):
    count = data.draw(st.integers(0, size))
    window, kept = GainWindow(size, head_start=2.5, count=count), [2.5] * count
    for gain in values:
        window.add(gain)
        kept = [*kept, gain][-size:]
        assert window.mean() == float(sum(map(Fraction, kept))) / len(kept)


def test_an_empty_window_has_mean_zero():
    assert GainWindow(3, head_start=1.0, count=0).mean() == 0


def test_never_drifts():
    """Large gains leave no rounding behind when they leave."""
    window = GainWindow(2, head_start=1.0, count=1)
    for gain in [1e16, 0.1, 1e16, 0.1, 0.1, 0.1]:
        window.add(gain)
    assert window.mean() == pytest.approx(0.1, rel=1e-16)
