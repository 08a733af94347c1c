"""The Gray-Scott reaction, against the equations one cell at a time, and laws of the model."""

import pickle

import numpy as np
import pytest
from scipy.ndimage import convolve

import divbandit as db
from divbandit.benchmarks.gray_scott import GrayScott, effect_of, reacted, seeded

PATTERN = [0.037, 0.06, 8.0, 0.1]
UNIFORM = [0.08, 0.045, 8.0, 0.1]
NOTHING = [0.08, 0.07, 8.0, 0.1]


def commands_of(environment, n, seed=0):
    low, high = environment.motor_space.low, environment.motor_space.high
    return low + (high - low) * np.random.default_rng(seed).random((n, len(low)))


def cell_by_cell(start, feed, kill, steps):
    """Return u and v from Pearson's equations, one cell at a time."""
    (u, v), n = start.copy(), start.shape[-1]
    for _ in range(steps):
        new_u, new_v = np.empty((n, n)), np.empty((n, n))
        for i in range(n):
            for j in range(n):
                around = [(i - 1) % n, j], [(i + 1) % n, j], [i, (j - 1) % n], [i, (j + 1) % n]
                laplacian_u = sum(u[x, y] for x, y in around) - 4 * u[i, j]
                laplacian_v = sum(v[x, y] for x, y in around) - 4 * v[i, j]
                made = u[i, j] * v[i, j] ** 2
                new_u[i, j] = u[i, j] + 0.16 * laplacian_u - made + feed * (1 - u[i, j])
                new_v[i, j] = v[i, j] + 0.08 * laplacian_v + made - (feed + kill) * v[i, j]
        u, v = new_u, new_v
    return np.stack([u, v])


def convolved(start, feed, kill, steps):
    """Return u and v with SciPy's convolution on the torus."""
    u, v = start
    five_points = np.array([[0, 1, 0], [1, -4, 1], [0, 1, 0]])
    for _ in range(steps):
        made = u * v**2
        u, v = (
            u + 0.16 * convolve(u, five_points, mode="wrap") - made + feed * (1 - u),
            v + 0.08 * convolve(v, five_points, mode="wrap") + made - (feed + kill) * v,
        )
    return np.stack([u, v])


@pytest.mark.parametrize(("feed", "kill"), [(0.037, 0.06), (0.01, 0.045), (0.08, 0.07)])
def test_steps_are_those_of_the_equations_one_cell_at_a_time(feed, kill):
    start = np.random.default_rng(1).random((2, 7, 7)) / 2
    found = reacted(start, feed, kill, 12)
    np.testing.assert_allclose(found, cell_by_cell(start, feed, kill, 12), rtol=0, atol=1e-14)


@pytest.mark.parametrize("command", [PATTERN, UNIFORM])
def test_patterns_are_those_of_a_convolution(command):
    feed, kill, side, noise = command
    expected = convolved(seeded(20, side, noise), feed, kill, 500)[1]
    np.testing.assert_allclose(GrayScott(20, 500).pattern(command), expected, rtol=0, atol=1e-9)


def test_v_that_dies_out_is_nothing_to_twelve_digits():
    feed, kill, side, noise = NOTHING
    expected = convolved(seeded(16, side, noise), feed, kill, 500)[1]
    found = GrayScott(16, 500).pattern(NOTHING)
    assert expected.max() < 1e-12
    assert found.tolist() == np.zeros((16, 16)).tolist()


def test_where_there_is_no_v_nothing_happens():
    start = np.stack([np.ones((9, 9)), np.zeros((9, 9))])
    assert np.array_equal(reacted(start, 0.04, 0.06, 100), start)


def test_a_uniform_equilibrium_stays():
    feed, kill = 0.08, 0.045  # v = F (1 - u) / (F + k) and u v = F + k
    v = (feed + np.sqrt(feed**2 - 4 * feed * (feed + kill) ** 2)) / (2 * (feed + kill))
    start = np.stack([np.full((8, 8), (feed + kill) / v), np.full((8, 8), v)])
    np.testing.assert_allclose(reacted(start, feed, kill, 300), start, rtol=0, atol=1e-13)


@pytest.mark.parametrize("shift", [(1, 0), (-3, 5)])
def test_a_start_elsewhere_moves_the_pattern(shift):
    start = seeded(16, 6, 0.2)
    moved = reacted(np.roll(start, shift, (1, 2)), 0.037, 0.06, 300)
    found = np.roll(reacted(start, 0.037, 0.06, 300), shift, (1, 2))
    np.testing.assert_allclose(moved, found, rtol=0, atol=1e-12)


def test_the_start_is_left_as_it_was():
    start = seeded(16, 6, 0.2)
    before = start.copy()
    reacted(start, 0.037, 0.06, 10)
    assert np.array_equal(start, before)


def test_the_square_at_first():
    u, v = seeded(16, 4, 0)
    inner = np.zeros((16, 16), dtype=bool)
    inner[6:10, 6:10] = True
    assert np.array_equal(v, np.where(inner, 0.25, 0))
    assert np.array_equal(u, np.where(inner, 0.5, 1))
    assert seeded(16, 3.5, 0)[1].sum() == pytest.approx(0.25 * 3.5**2, abs=1e-15)
    noisy = seeded(16, 4, 0.2)
    assert np.array_equal(noisy, seeded(16, 4, 0.2))
    assert np.abs(noisy - [u, v])[:, ~inner].max() == 0
    assert 0.1 < np.abs(noisy[0] - u).max() <= 0.2
    assert 0.05 < np.abs(noisy[1] - v).max() <= 0.1


def test_effects_by_hand():
    assert effect_of(np.full((8, 8), 0.3)).tolist() == pytest.approx([0.5, 0], abs=1e-15)
    stripes = np.tile([0.0, 0.0, 0.1, 0.1], (8, 2))  # half of the steps along rows are 0.1
    assert effect_of(stripes).tolist() == pytest.approx([0.05 / 0.6, np.sqrt(0.005) / 0.1])
    assert effect_of(stripes.T).tolist() == pytest.approx(effect_of(stripes).tolist())


def test_known_rates_have_their_known_regimes():
    environment = GrayScott(32, 1500)
    pattern, uniform, nothing = environment([PATTERN, UNIFORM, NOTHING])
    assert pattern[0] > 0.2
    assert pattern[1] > 0.4
    feed, kill = UNIFORM[:2]
    equilibrium = (feed + np.sqrt(feed**2 - 4 * feed * (feed + kill) ** 2)) / (2 * (feed + kill))
    assert uniform.tolist() == pytest.approx([equilibrium / 0.6, 0], abs=1e-6)
    assert nothing.tolist() == [0, 0]


def test_effects_of_random_commands_are_in_the_sensory_space_and_differ():
    environment = GrayScott(16, 500)
    effects = environment(commands_of(environment, 200))
    assert effects.shape == (200, 2)
    assert (effects >= environment.sensory_space.low).all()
    assert (effects <= environment.sensory_space.high).all()
    uniform = effects[:, 1] < 0.01
    assert 0.2 < uniform.mean() < 0.9
    assert (effects[uniform, 0] < 0.01).any()
    assert (effects[uniform, 0] > 0.3).any()


def test_many_at_once_are_the_same_bits_as_one_by_one():
    environment = GrayScott(16, 500)
    commands = commands_of(environment, 3)
    many = environment(commands)
    assert many.tolist() == [environment(command).tolist() for command in commands]
    assert many.tolist() == [effect_of(environment.pattern(each)).tolist() for each in commands]
    assert environment(np.empty((0, 4))).shape == (0, 2)


def test_it_is_an_environment_and_a_value():
    environment = GrayScott(16, 500)
    assert isinstance(environment, db.Environment)
    assert repr(GrayScott()) == "GrayScott()"
    assert repr(environment) == "GrayScott(16, 500)"
    assert pickle.loads(pickle.dumps(environment)) == environment != GrayScott()  # noqa: S301
    assert environment.motor_space.high.tolist() == [0.08, 0.07, 8, 0.2]
    assert len(db.explore(environment, db.MotorBabbling(), 3, rng=0)) == 3


@pytest.mark.parametrize(
    "bad",
    [None, "abcd", [0.04] * 3, [0.04, 0.06, np.nan, 0], [0.09, 0.06, 4, 0], [0.04, 0.06, 9, 0]],
)
def test_bad_commands_are_refused(bad):
    environment = GrayScott(16, 500)
    for refuse in (environment, environment.pattern):
        with pytest.raises((TypeError, ValueError), match="command"):
            refuse(bad)


def test_a_pattern_is_of_one_command():
    with pytest.raises(ValueError, match="command"):
        GrayScott(16, 500).pattern([PATTERN])


@pytest.mark.parametrize(
    ("name", "bad"), [("size", 15), ("size", 64.0), ("size", True), ("steps", 499), ("steps", "1")]
)
def test_bad_arguments_are_refused(name, bad):
    with pytest.raises((TypeError, ValueError), match=name):
        GrayScott(**{name: bad})
