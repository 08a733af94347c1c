"""Lenia, against the definition with sums over neighbours, and laws of the model."""

import math
import pickle

import numpy as np
import pytest
from scipy.ndimage import convolve

import divbandit as db
from divbandit.benchmarks.lenia import Lenia, effect_of, growth, last_two, patch, ring, transformed

SPOTS = [0.15, 0.03, 10.0, *[0.5] * 16]
NOTHING = [0.35, 0.01, 10.0, *[0.5] * 16]


def commands_of(environment, n, seed=0):
    low, high = environment.motor_space.low, environment.motor_space.high
    return low + (high - low) * np.random.default_rng(seed).random((n, len(low)))


def weights(radius):
    """Return the kernel's weights by offset, from the formula, one at a time."""
    found = {}
    for i in range(-radius, radius + 1):
        for j in range(-radius, radius + 1):
            r = math.hypot(i, j) / radius
            if 0 < r < 1:
                found[i, j] = math.exp(4 - 4 / (4 * r * (1 - r)))
    total = math.fsum(found.values())
    return {offset: weight / total for offset, weight in found.items()}


def convolved(states, radius, center, width, duration, steps):
    """Return the last two states, with SciPy's convolution on the torus."""
    kernel = np.zeros((2 * radius + 1,) * 2)
    for (i, j), weight in weights(radius).items():
        kernel[i + radius, j + radius] = weight
    before = states
    for _ in range(steps):
        before = states
        around = convolve(states, kernel, mode="wrap")
        grown = 2 * np.exp(-((around - center) ** 2) / (2 * width**2)) - 1
        states = np.minimum(np.maximum(states + grown / duration, 0), 1)
    return before, states


@pytest.mark.parametrize(("size", "radius"), [(16, 4), (17, 4), (51, 12), (52, 13), (80, 13)])
def test_the_kernel_is_the_published_ring(size, radius):
    expected = np.zeros((size, size))
    for (i, j), weight in weights(radius).items():
        expected[i % size, j % size] = weight
    np.testing.assert_allclose(ring(size), expected, rtol=1e-12, atol=0)
    assert ring(size).sum() == pytest.approx(1, abs=1e-14)


def test_the_kernel_at_single_points():
    kernel = ring(48) / ring(48)[0, 6]  # R is 12, so that r is 1/2 there: the top of the ring
    assert kernel.max() == 1
    assert kernel[0, 0] == 0
    assert kernel[3, 0] == pytest.approx(math.exp(4 - 16 / 3), rel=1e-12)
    assert kernel[0, -9] == kernel[3, 0]
    assert kernel[0, 12] == 0


def test_growth_at_single_points():
    assert growth(np.array([0.2]), 0.2, 0.03).tolist() == [1]
    at = np.array([0.2 + 0.03, 0.2 - 0.03 * math.sqrt(2 * math.log(2)), 1])
    expected = [2 / math.sqrt(math.e) - 1, 0, -1]
    np.testing.assert_allclose(growth(at, 0.2, 0.03), expected, rtol=0, atol=1e-12)


def test_one_step_one_cell_at_a_time():
    size, center, width = 16, 0.2, 0.05
    states = np.random.default_rng(0).random((size, size)) / 2
    before, found = last_two(states, transformed(ring(size)), center, width, 10, 1)
    assert np.array_equal(before, states)
    for x, y in [(0, 0), (3, 15), (8, 8), (15, 1)]:
        around = math.fsum(
            weight * states[(x + i) % size, (y + j) % size] for (i, j), weight in weights(4).items()
        )
        grown = 2 * math.exp(-((around - center) ** 2) / (2 * width**2)) - 1
        expected = min(max(states[x, y] + grown / 10, 0), 1)
        assert found[x, y] == pytest.approx(expected, abs=1e-14)


@pytest.mark.parametrize("size", [20, 33])
def test_patterns_are_those_of_a_convolution(size):
    radius = size // 4
    blocks = np.random.default_rng(2).random((4, 4))
    for center, width, duration in [(0.15, 0.03, 10.0), (0.25, 0.045, 31.5)]:
        command = [center, width, duration, *blocks.ravel()]
        first = patch(size, blocks)
        before, last = convolved(first, radius, center, width, duration, 50)
        assert last.any()
        environment = Lenia(size, 50)
        np.testing.assert_allclose(environment.pattern(command), last, rtol=0, atol=1e-8)
        effect = [2 * last.mean(), 2 * duration * np.abs(last - before).mean()]
        assert environment(command).tolist() == pytest.approx(effect, abs=1e-7)


def test_the_patch_at_first():
    blocks = np.arange(16).reshape(4, 4) / 16
    states = patch(52, blocks)  # R is 13, so that blocks have 6 cells along a side
    assert states.shape == (52, 52)
    for i in range(4):
        for j in range(4):
            block = states[14 + 6 * i : 20 + 6 * i, 14 + 6 * j : 20 + 6 * j]
            assert (block == blocks[i, j]).all()
    assert states.sum() == 36 * blocks.sum()


@pytest.mark.parametrize("shift", [(1, 0), (-3, 5)])
def test_a_start_elsewhere_moves_the_pattern(shift):
    first = patch(32, np.random.default_rng(4).random((4, 4)))
    rules = transformed(ring(32)), 0.15, 0.03, 10, 60
    _, moved = last_two(np.roll(first, shift, (0, 1)), *rules)
    _, last = last_two(first, *rules)
    np.testing.assert_allclose(moved, np.roll(last, shift, (0, 1)), rtol=0, atol=1e-8)


def test_a_turn_of_the_start_turns_the_pattern():
    blocks = np.random.default_rng(5).random((4, 4))
    rules = transformed(ring(32)), 0.15, 0.03, 10, 60
    _, turned = last_two(patch(32, np.rot90(blocks)), *rules)
    _, last = last_two(patch(32, blocks), *rules)
    # The centre of the patch is between four cells, as is that of the grid.
    np.testing.assert_allclose(turned, np.rot90(last), rtol=0, atol=1e-8)


def test_a_uniform_state_that_grows_to_where_growth_is_0_stays():
    center, width = 0.2, 0.05
    rest = center + width * math.sqrt(2 * math.log(2))  # a zero of the growth
    first = np.full((16, 16), rest)
    _, last = last_two(first, transformed(ring(16)), center, width, 10, 20)
    np.testing.assert_allclose(last, first, rtol=0, atol=1e-12)


def test_nothing_comes_from_nothing():
    environment = Lenia(16, 50)
    low, high = environment.motor_space.low[:3], environment.motor_space.high[:3]
    for rates in (low, high, [low[0], high[1], low[2]]):
        command = [*rates, *[0] * 16]
        assert environment(command).tolist() == [0, 0]
        assert not environment.pattern(command).any()
    # So also without the early stop: growth is negative where there is nothing around.
    assert growth(np.zeros(1), low[0], high[1])[0] < 0


def test_effects_by_hand():
    before, last = np.full((8, 8), 0.2), np.full((8, 8), 0.25)
    assert effect_of(before, last, 4.0).tolist() == pytest.approx([0.5, 0.4], abs=1e-15)
    assert effect_of(last, before, 4.0).tolist() == pytest.approx([0.4, 0.4], abs=1e-15)


def test_known_growth_has_its_known_regimes():
    environment = Lenia(52, 200)
    spots, nothing = environment([SPOTS, NOTHING])
    assert 0.2 < spots[0] < 0.7
    assert spots[1] < 0.1
    assert nothing.tolist() == [0, 0]


def test_effects_of_random_commands_are_in_the_sensory_space_and_differ():
    environment = Lenia(20, 60)
    effects = environment(commands_of(environment, 200))
    assert effects.shape == (200, 2)
    assert (effects >= environment.sensory_space.low).all()
    assert (effects <= environment.sensory_space.high).all()
    empty = effects[:, 0] == 0
    assert 0.1 < empty.mean() < 0.8
    assert (effects[empty, 1] == 0).all()
    assert np.ptp(effects, axis=0).min() > 0.3


def test_states_stay_in_the_unit_interval():
    environment = Lenia(20, 60)
    patterns = [environment.pattern(command) for command in commands_of(environment, 30, seed=1)]
    assert np.min(patterns) == 0
    assert np.max(patterns) == 1


def test_many_at_once_are_the_same_bits_as_one_by_one():
    environment = Lenia(16, 50)
    commands = commands_of(environment, 5)
    many = environment(commands)
    assert many.tolist() == [environment(command).tolist() for command in commands]
    masses = [2 * environment.pattern(command).mean() for command in commands]
    assert many[:, 0].tolist() == masses
    assert environment(np.empty((0, 19))).shape == (0, 2)


def test_it_is_an_environment_and_a_value():
    environment = Lenia(16, 50)
    assert isinstance(environment, db.Environment)
    assert repr(Lenia()) == "Lenia()"
    assert repr(environment) == "Lenia(16, 50)"
    again = pickle.loads(pickle.dumps(environment))  # noqa: S301
    assert again == environment != Lenia()
    assert again(SPOTS).tolist() == environment(SPOTS).tolist()
    assert len(db.explore(environment, db.MotorBabbling(), 3, rng=0)) == 3


@pytest.mark.parametrize(
    "bad",
    [
        None,
        "a" * 19,
        SPOTS[:-1],
        [math.nan, *SPOTS[1:]],
        [0.4, *SPOTS[1:]],
        [0.15, 0.0, *SPOTS[2:]],
        [*SPOTS[:-1], 1.1],
    ],
)
def test_bad_commands_are_refused(bad):
    environment = Lenia(16, 50)
    for refuse in (environment, environment.pattern):
        with pytest.raises((TypeError, ValueError), match="command"):
            refuse(bad)


def test_a_pattern_is_of_one_command():
    with pytest.raises(ValueError, match="command"):
        Lenia(16, 50).pattern([SPOTS])


@pytest.mark.parametrize(
    ("name", "bad"), [("size", 15), ("size", 64.0), ("size", True), ("steps", 49), ("steps", "1")]
)
def test_bad_arguments_are_refused(name, bad):
    with pytest.raises((TypeError, ValueError), match=name):
        Lenia(**{name: bad})
