"""Sparseness: distances worked out on paper, and by brute force."""

import math
from fractions import Fraction

import numpy as np
import pytest

from divbandit.measures import Sparseness


def test_gains_by_hand():
    """Right triangles 3-4-5 and 5-12-13, with two neighbours."""
    sparseness = Sparseness(2).start(2)
    assert sparseness.add([0, 0]) == 0.0  # nothing to be far from
    assert sparseness.add([3, 4]) == 5.0  # one is known
    assert sparseness.add([3, 0]) == 3.5  # (3 + 4) / 2
    assert sparseness.add([15, 9]) == (13 + 15) / 2  # to (3, 4) and (3, 0): hypot(12, 9) = 15
    assert sparseness.measure == 22.5
    assert (len(sparseness), sparseness.dim) == (4, 2)


def test_by_default_fifteen_neighbours():
    gains = Sparseness().start(1).extend([[0.0]] * 15 + [[1.0], [1.0]])
    assert gains.tolist() == [0.0] * 15 + [1.0, 14 / 15]


def test_a_repeated_effect_gains_until_it_was_seen_k_times():
    gains = Sparseness(2).start(1).extend([[0.0], [4.0], [4.0], [4.0], [4.0]])
    assert gains.tolist() == [0.0, 4.0, 2.0, 0.0, 0.0]


def test_the_sum_does_not_drift():
    """A plain sum of these gains is off by 2e-11 or more; the exact one is rounded once."""
    effects = np.random.default_rng(0).uniform(size=(20_000, 1)) * 1e-6
    effects[1] = 1e6
    sparseness = Sparseness(1).start(1)
    gains = sparseness.extend(effects).tolist()
    exact = float(sum(map(Fraction, gains)))
    assert sparseness.measure == exact
    plain = 0.0
    for gain in gains:
        plain += gain
    assert abs(plain - exact) > 2e-11


@pytest.mark.parametrize("far", [1e150, -1e150])
def test_far_effects(far):
    sparseness = Sparseness().start(2)
    sparseness.add([-far, -far])
    assert sparseness.add([far, far]) == pytest.approx(math.sqrt(8) * 1e150, rel=1e-14)
    assert math.isfinite(sparseness.measure)


@pytest.mark.parametrize("far", [1.1e150, -1e300])
def test_too_far_effects_are_refused(far):
    sparseness = Sparseness().start(2)
    sparseness.add([1.0, 1.0])
    message = r"must be within 1e150 of 0, got"
    with pytest.raises(ValueError, match=r"effect\[1\] " + message):
        sparseness.add([0.0, far])
    with pytest.raises(ValueError, match=r"effect\[0, 0\] " + message):
        sparseness.gain([[far, 0.0], [0.0, 0.0]])
    with pytest.raises(ValueError, match=r"effects\[1, 1\] " + message):
        sparseness.extend([[0.0, 0.0], [0.0, far]])
    assert (len(sparseness), sparseness.measure) == (1, 0.0)
    assert sparseness.gain([1.0, 2.0]) == 1.0


def test_says_what_it_is():
    sparseness = Sparseness(3).start(2)
    sparseness.extend([[0, 0], [0, 1]])
    assert repr(sparseness) == "<Sparseness(3) of 2 effects in R^2, measure=1.0>"
