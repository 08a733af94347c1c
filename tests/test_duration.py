"""Durations: what is one, in seconds, and what is refused."""

import math

import numpy as np
import pytest

from divbandit._duration import seconds


@pytest.mark.parametrize(
    ("written", "expected"),
    [
        ("30s", 30.0),
        ("10min", 600.0),
        ("2h", 7200.0),
        ("1.5 h", 5400.0),
        ("250ms", 0.25),
        ("1d", 86400.0),
        (" .5  min ", 30.0),
        ("2.s", 2.0),
        (30, 30.0),
        (0.25, 0.25),
        (np.float32(0.5), 0.5),
        (np.int64(3), 3.0),
    ],
)
def test_a_duration_in_seconds(written, expected):
    found = seconds("every", written)
    assert found == expected
    assert type(found) is float


@pytest.mark.parametrize(
    "wrong",
    [
        "",
        "30",
        "s",
        "2 hours",
        "1h30min",
        "-1s",
        "1e3s",
        "1,5h",
        "5m",
        "30S",
        "٣s",
        "nan s",
        "1 . 5h",
    ],
)
def test_other_texts_are_refused(wrong):
    with pytest.raises(ValueError, match="every must be a duration such as") as caught:
        seconds("every", wrong)
    assert str(caught.value).endswith(f"got {wrong!r}")


@pytest.mark.parametrize("wrong", ["0s", "0.0 h", 9 * "9" * 40 + "d", 0, -1, math.nan, math.inf])
def test_durations_that_are_not_positive_and_finite_are_refused(wrong):
    with pytest.raises(ValueError, match="timeout must be"):
        seconds("timeout", wrong)


@pytest.mark.parametrize("wrong", [None, True, [30], 1j, b"30s", np.array([1.0])])
def test_other_things_are_refused(wrong):
    with pytest.raises(TypeError, match="or a number of seconds, got"):
        seconds("every", wrong)
