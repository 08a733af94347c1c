"""Whatever is passed by mistake: an error that names the argument, and nothing has changed."""

import re

import pytest

import divbandit as db
from tests.bad_calls import TABLE
from tests.world import World


def cases():
    for called, argument, values, call in TABLE:
        for name, value in values.items():
            yield pytest.param(argument, call, value, id=f"{called}-{argument}-{name}")


@pytest.mark.parametrize(("argument", "call", "value"), [*cases()])
def test_the_error_names_the_argument_and_nothing_changes(argument, call, value):
    world = World()
    before = world.state()
    with pytest.raises((TypeError, ValueError)) as caught:
        call(world, value)
    assert re.search(rf"\b{argument}s?\b", str(caught.value), re.IGNORECASE), str(caught.value)
    assert world.state() == before
    world.explorer.tell(world.trial, [0.0, 0.0])


def test_effects_of_a_dimension_that_coverage_does_not_take_have_none():
    space = db.Box([0] * 40, [1] * 40)
    run = db.explore(
        db.FunctionEnvironment(lambda x: x, space, space), db.MotorBabbling(), n=3, rng=0
    )
    with pytest.raises(
        ValueError, match="effects must be of a dimension that coverage takes, got 40"
    ):
        run.coverage(0.1)
