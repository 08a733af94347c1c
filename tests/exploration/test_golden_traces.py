"""Explorations come out as they always did, with either engine; see `tests.exploration.golden`."""

import numpy as np
import pytest

import divbandit as db
from tests.exploration.golden.configurations import CONFIGURATIONS
from tests.exploration.golden.digest import NAMES, digest
from tests.exploration.golden.traces import read

TRACES = read()


def test_each_configuration_has_a_trace():
    assert list(CONFIGURATIONS) == list(TRACES)


@pytest.mark.parametrize("engine", ["python", "rust"])
@pytest.mark.parametrize("name", CONFIGURATIONS)
def test_same_as_ever(name, engine):
    assert digest(*CONFIGURATIONS[name].explore(engine)) == TRACES[name]


def test_no_two_traces_are_the_same():
    """Each configuration does tell something: what is special in it has an effect."""
    effects = [trace["effects"] for trace in TRACES.values()]
    assert len(set(effects)) == len(effects)


def test_a_digest_depends_on_every_bit_and_on_no_byte_order():
    adapt = db.Adapt([db.MotorBabbling(), db.GoalBabbling(0.05)])
    run = db.explore(db.PlanarArm(2), adapt, 20, rng=0)
    before = digest(run, 0.5)
    for key, name in NAMES.items():
        array = getattr(run, name)
        kept = array.copy()
        object.__setattr__(run, name, array.astype(array.dtype.newbyteorder(">")))
        assert digest(run, 0.5) == before
        object.__setattr__(run, name, array)
        array.view(np.uint64)[-1, 0] ^= 1
        changed = digest(run, 0.5)
        assert {each for each in before if changed[each] != before[each]} == {key}
        array[:] = kept
    assert digest(run, 0.25) != before
