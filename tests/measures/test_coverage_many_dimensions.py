"""From dimension 4 on: true values lie within three stated standard errors."""

import math

import numpy as np
import pytest

import divbandit as db
from tests.generators import state
from tests.reference.rows_of_balls import ball, in_direction, overlap, row_measure

CASES = 200
HIGH = [4, 5, 6, 8, 11, 16]
# Of the truth: a standard error is one of sampling, and 0 where nothing was sampled.
ROUNDING = 1e-14


def one(dim, rng):
    return rng.standard_normal((1, dim)), ball(dim, 1.0)


def disjoint(dim, rng):
    """Five balls, of which neighbours touch or are farther apart."""
    places = np.cumsum(rng.choice([2.0, 2.5, 1e3], 5))
    axis = np.zeros((5, dim))
    axis[:, rng.integers(dim)] = places
    return axis, 5 * ball(dim, 1.0)


def row(n):
    """Return a case: overlapping balls in a straight line, in any order."""

    def case(dim, rng):
        places = np.cumsum(rng.uniform(0.02, 2, n))
        return in_direction(rng.permutation(places), dim, rng), row_measure(places, dim, 1.0)

    return case


def bent(dim, rng):
    """Three balls, the first and the last of which are apart."""
    a, b = rng.uniform(1.42, 1.98, 2)
    points = np.zeros((3, dim))
    points[1, 0], points[2, :2] = a, [a, b]
    return points, ball(dim, 1.0) * (3 - overlap(a, dim) - overlap(b, dim))


def round_a_gap(dim, rng):
    """Three balls that overlap each other but have nothing in common."""
    side = rng.uniform(math.sqrt(3), 1.9)
    points = np.zeros((3, dim))
    points[:, :3] = side / math.sqrt(2) * np.eye(3)
    return rng.permutation(points), ball(dim, 1.0) * (3 - 3 * overlap(side, dim))


FORMS = {
    "one": one,
    "disjoint": disjoint,
    "two": row(2),
    "three in a row": row(3),
    "six in a row": row(6),
    "bent": bent,
    "round a gap": round_a_gap,
}


def seeded(name, accuracy):
    """Yield a coverage of a closed form, and the true measure: dimensions 4 to 16 in turn."""
    for seed in range(CASES):
        rng = np.random.default_rng(seed)
        dim = 4 + seed % 13
        points, expected = FORMS[name](dim, rng)
        tau = 10.0 ** rng.uniform(-2, 2)
        cov = db.Coverage(tau, dim=dim, accuracy=accuracy, rng=seed)
        cov.extend(points * tau)
        yield cov, expected * tau**dim


@pytest.mark.parametrize("accuracy", [1e-2, 1e-3])
@pytest.mark.parametrize("name", FORMS)
def test_totals_lie_within_three_errors(name, accuracy):
    errors = [
        (abs(cov.measure / expected - 1), cov.standard_error / expected)
        for cov, expected in seeded(name, accuracy)
    ]
    within = sum(error <= 3 * stated + ROUNDING for error, stated in errors)
    assert within >= 0.98 * CASES
    if name in ("one", "disjoint", "two"):  # no rays are needed
        assert max(stated for _, stated in errors) < 1e-13
        assert within == CASES


@pytest.mark.parametrize("name", FORMS)
def test_accuracy_is_kept_and_errors_add_up(name):
    for cov, _ in seeded(name, 3e-3):
        stated = cov.standard_errors / cov.largest_gain
        assert stated.shape == cov.gains.shape
        assert np.all(stated <= 3e-3 * (1 + 1e-12))
        total = math.sqrt(math.fsum(stated**2)) * cov.largest_gain
        assert cov.standard_error == pytest.approx(total, rel=1e-12)


@pytest.mark.parametrize("dim", HIGH)
def test_gains_lie_within_three_errors_and_are_unbiased(dim):
    """The same effects with 200 seeds: the third has two neighbours that overlap in it."""
    places = np.array([0.0, 0.5, 1.0])
    points = in_direction(places, dim, np.random.default_rng(0))
    expected = 1 - overlap(0.5, dim)
    found = []
    for seed in range(CASES):
        cov = db.Coverage(1.0, dim=dim, accuracy=0.02, rng=seed)
        cov.extend(points[:2])
        found.append(np.divide(cov.gain(points[2], with_error=True), cov.largest_gain))
    shares, errors = np.transpose(found)
    assert np.mean(abs(shares - expected) <= 3 * errors) >= 0.98
    usual = math.sqrt(np.mean(errors**2))
    assert abs(shares.mean() - expected) <= 4 * usual / math.sqrt(CASES)
    # The spread over seeds is what the errors say, not much less or more.
    assert 0.5 * usual < shares.std() < 1.2 * usual


@pytest.mark.parametrize("dim", HIGH)
def test_a_contribution_lies_within_three_errors(dim):
    """That of a ball in a row, between two: what it has in common with neither."""
    far = 0
    for seed in range(50):
        rng = np.random.default_rng(seed)
        a, b = rng.uniform(0.9, 1.0, 2)  # the neighbours overlap in it
        places = np.array([0, a, a + b])
        cov = db.Coverage(1.0, dim=dim, accuracy=0.01, rng=seed)
        cov.extend(in_direction(places, dim, rng))
        expected = row_measure(places, dim, 1.0) - row_measure(places[[0, 2]], dim, 1.0)
        found, error = cov.contribution(1, with_error=True)
        assert 0 < error <= 0.01 * cov.largest_gain
        far += abs(found - expected) > 3 * error
    assert far <= 1


@pytest.mark.parametrize("accuracy", [0.1, 0.01, 1e-3])
@pytest.mark.parametrize("dim", HIGH)
def test_accuracy_is_kept_among_many_neighbours(dim, accuracy):
    rng = np.random.default_rng(dim)
    directions = rng.standard_normal((10, dim))
    directions /= np.linalg.norm(directions, axis=1, keepdims=True)
    cov = db.Coverage(1.0, dim=dim, accuracy=accuracy, rng=0)
    cov.extend(directions * rng.uniform(0.2, 1.5, (10, 1)))
    gain, error = cov.gain(np.zeros(dim), with_error=True)
    assert 0 < error <= accuracy * cov.largest_gain
    finer = db.Coverage(1.0, dim=dim, accuracy=1e-3, rng=1)
    finer.extend(cov.effects)
    other, finer_error = finer.gain(np.zeros(dim), with_error=True)
    assert abs(gain - other) <= 4 * math.hypot(error, finer_error)


@pytest.mark.parametrize("dim", [1, 2, 3, *HIGH, 32])
def test_a_generator_gives_one_number_if_gains_are_estimated(dim):
    rng, twin = np.random.default_rng(0), np.random.default_rng(0)
    cov = db.Coverage(1.0, dim=dim, rng=rng)
    assert cov.exact is (dim <= 3)
    if dim > 3:
        twin.random()
    assert state(rng) == state(twin)
    cov.extend(np.random.default_rng(1).uniform(-0.3, 0.3, (5, dim)))
    cov.gain(np.zeros(dim))
    cov.contribution(0)
    assert state(rng) == state(twin)
    assert (cov.standard_error == 0) is cov.exact
    assert np.all(cov.standard_errors[1:] > 0) != cov.exact


def found(dim, rng):
    cov = db.Coverage(1.0, dim=dim, accuracy=0.03, rng=rng)
    gains = cov.extend(np.random.default_rng(1).uniform(-0.3, 0.3, (20, dim)))
    return gains.tolist()


@pytest.mark.parametrize("dim", [4, 7, 16])
def test_the_same_seed_gives_the_same_bits_and_another_others(dim):
    gains = found(dim, 5)
    assert found(dim, 5) == found(dim, np.random.default_rng(5)) == gains
    assert found(dim, np.random.SeedSequence(5)) == gains
    shared = np.random.default_rng(5)
    assert found(dim, shared) == gains
    for other in (found(dim, shared), found(dim, 6), found(dim, None)):
        assert other != gains
        assert other == pytest.approx(gains, abs=0.3 * ball(dim, 1.0))


def test_batch_coverage_takes_accuracy_and_rng():
    places = np.cumsum(np.full(9, 0.7))
    points = in_direction(places, 6, np.random.default_rng(0))
    total = [db.coverage(points, 1.0, accuracy=0.01, rng=rng) for rng in (1, 1, 2)]
    assert total[0] == total[1] != total[2]
    expected = row_measure(places, 6, 1.0)
    assert total == pytest.approx([expected] * 3, abs=4 * 3 * 0.01 * ball(6, 1.0))


@pytest.mark.parametrize("dim", range(1, 33))
def test_a_ball_and_two(dim):
    cov = db.Coverage(0.7, dim=dim, rng=0)
    assert cov.largest_gain == pytest.approx(ball(dim, 0.7), rel=1e-14)
    gains = [cov.add(np.full(dim, place / math.sqrt(dim))) for place in (0, 0.3, 0.3)]
    apart = [1.0, 1 - overlap(0.3 / 0.7, dim), 0.0]
    assert gains == pytest.approx(np.multiply(apart, ball(dim, 0.7)), rel=1e-12)


def test_rows_are_what_the_plane_and_space_say_too():
    """The closed form where gains are exact."""
    places = np.cumsum([0, *np.random.default_rng(0).uniform(0.02, 2, 8)])
    for dim in (1, 2, 3):
        points = in_direction(places, dim, np.random.default_rng(dim))
        expected = row_measure(places, dim, 1.0)
        assert db.coverage(points, 1.0) == pytest.approx(expected, rel=1e-13)
