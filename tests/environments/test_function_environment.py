"""Any function as a black box: what goes in is a command, what comes out is checked."""

import numpy as np
import pytest

import divbandit as db

SQUARE = db.Box([-1, -1], [1, 1])


def swap(x):
    return x[::-1]


def test_one_command_and_many():
    environment = db.FunctionEnvironment(swap, SQUARE, SQUARE)
    assert environment([0.25, 0.5]).tolist() == [0.5, 0.25]
    many = environment([[0.25, 0.5], [-1, 1], [0, 0]])
    assert many.tolist() == [[0.5, 0.25], [1, -1], [0, 0]]


def test_no_commands_at_all():
    environment = db.FunctionEnvironment(swap, SQUARE, SQUARE)
    assert environment(np.empty((0, 2))).shape == (0, 2)


def test_the_function_sees_a_read_only_array_of_float64():
    seen = []

    def look(x):
        seen.append((type(x), x.dtype, x.shape, x.flags.writeable))
        return [0.0]

    db.FunctionEnvironment(look, SQUARE)([0, 1])
    assert seen == [(np.ndarray, np.float64, (2,), False)]


def test_the_effect_is_a_copy():
    mine = np.zeros(1)
    environment = db.FunctionEnvironment(lambda _: mine, SQUARE)
    effect = environment([0, 0])
    mine[0] = 7
    assert effect.tolist() == [0]


@pytest.mark.parametrize(
    "wrong", [None, "ab", 0.5, [], [np.nan, 0], [np.inf, 0], [1j, 0], [True, False], [[0, 0]], [0]]
)
def test_an_effect_that_is_no_point_is_refused(wrong):
    environment = db.FunctionEnvironment(lambda _: wrong, SQUARE, SQUARE)
    with pytest.raises((TypeError, ValueError), match="effect"):
        environment([0, 0])
    with pytest.raises((TypeError, ValueError), match="effect"):
        db.explore(environment, db.MotorBabbling(), n=1, rng=0)


def test_effects_of_several_lengths_are_refused():
    environment = db.FunctionEnvironment(lambda x: [0.0] * (1 + (x[0] > 0)), SQUARE)
    with pytest.raises(ValueError, match="effect"):
        environment([[-0.5, 0], [0.5, 0]])


def test_a_function_of_scalars_gets_plain_floats():
    seen = []

    def wave(x, y):
        seen.append((type(x), type(y)))
        return x * y

    wave = db.FunctionEnvironment(wave, db.Box([-1, -1], [1, 1]), scalars=True)
    assert wave([[0.5, 0.5], [1, -1]]).tolist() == [[0.25], [-1.0]]
    assert set(seen) == {(float, float)}
    assert repr(wave).endswith("scalars=True)")
    several = db.FunctionEnvironment(lambda x: (x, -x), db.Box([0], [1]), scalars=True)
    assert several([0.5]).tolist() == [0.5, -0.5]


def test_a_single_number_is_an_effect_of_one_dimension():
    total = db.FunctionEnvironment(lambda x: x.sum(), db.Box([0, 0], [1, 1]), db.Box([0], [2]))
    assert total([0.5, 1.0]).tolist() == [1.5]
