"""Strategies of other libraries: the same bits in every process."""

import optuna

import divbandit as db
from divbandit.adapters import OptunaSampler, RibsEmitter
from tests.scripts import printed


def explored():
    """Return the commands of an exploration by other libraries' strategies, as text."""
    samplers = [optuna.samplers.TPESampler, optuna.samplers.CmaEsSampler]
    parts = [RibsEmitter("line"), RibsEmitter("evolution"), *map(OptunaSampler, samplers)]
    run = db.explore(db.PlanarArm(4), db.Adapt(parts, tau=0.05), n=120, rng=0)
    assert set(run.choices) == {0, 1, 2, 3}
    return run.commands.tobytes().hex()


def test_the_same_bits_in_every_process():
    """Whatever the seed that Python's hashes have: here it is random."""
    script = "from tests.adapters.test_libraries import explored; print(explored())"
    assert printed(script, PYTHONHASHSEED="1") == f"{explored()}\n"
