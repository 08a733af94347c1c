"""What the figures show: usage, effects and estimates as plain arrays."""

import numpy as np
import pytest

import divbandit as db
from divbandit.plot.data import effects_of, estimates_of, usage_of


def plain_usage(choices, window, strategies):
    """The same by its definition: a mean over the steps around each that exist."""
    shares = np.zeros((len(choices), strategies))
    for i in range(len(choices)):
        around = choices[max(i - window // 2, 0) : i - window // 2 + window]
        for choice in around:
            shares[i, choice] += 1 / len(around)
    return shares


@pytest.mark.parametrize("window", [1, 2, 5, 100, 1000])
def test_usage_is_the_centred_mean_of_choices(window):
    choices = np.random.default_rng(0).integers(3, size=300)
    np.testing.assert_allclose(
        usage_of(choices, window=window), plain_usage(choices, window, 3), atol=1e-12
    )


def test_usage_sums_to_one_and_knows_strategies_never_chosen():
    shares = usage_of([0, 0, 0], strategies=2)
    np.testing.assert_array_equal(shares, [[1, 0]] * 3)


def test_usage_of_a_bandit_has_all_its_strategies():
    adapt = db.Adapt([db.MotorBabbling(), db.MotorBabbling(), db.MotorBabbling()], tau=0.02)
    assert usage_of(db.explore(db.PlanarArm(3), adapt, 1, rng=0)).shape == (1, 3)


@pytest.mark.parametrize(
    "choices", [[], [[0, 1]], [0.5, 1.0], ["a"], None], ids=["empty", "2-D", "float", "str", "None"]
)
def test_usage_refuses_what_are_no_choices(choices):
    with pytest.raises(ValueError, match="data must hold choices"):
        usage_of(choices)


@pytest.mark.parametrize(("window", "error"), [(0, ValueError), (-3, ValueError), (2.0, TypeError)])
def test_usage_refuses_a_window_that_is_no_count(window, error):
    with pytest.raises(error, match="window"):
        usage_of([0, 1], window=window)


def test_usage_refuses_fewer_strategies_than_were_chosen():
    with pytest.raises(ValueError, match="strategies"):
        usage_of([0, 2], strategies=2)


def test_effects_must_be_in_the_plane():
    with pytest.raises(ValueError, match=r"data must have shape \(n, 2\), got \(5, 3\)"):
        effects_of(np.zeros((5, 3)))


def test_estimates_need_a_bandit():
    run = db.explore(db.PlanarArm(3), db.MotorBabbling(), 5, rng=0)
    with pytest.raises(ValueError, match="data must be the exploration of a bandit"):
        estimates_of(run)
    with pytest.raises(ValueError, match="shape"):
        estimates_of([1.0, 2.0])
