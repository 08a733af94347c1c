"""The arm repertoire is the planar arm with full turns."""

import math

import numpy as np
import pytest

import divbandit as db
from divbandit.benchmarks import ArmRepertoire


def test_effects_are_sums_of_turned_links():
    rng = np.random.default_rng(0)
    for joints in (1, 12, 100):
        arm = ArmRepertoire(joints)
        commands = rng.uniform(-math.pi, math.pi, (50, joints))
        links = np.exp(1j * np.cumsum(commands, axis=1)) / joints
        tips = links.sum(axis=1)
        assert arm(commands) == pytest.approx(np.stack([tips.real, tips.imag], axis=1), abs=1e-12)
        assert (arm.motor_space.low == -math.pi).all()


def test_the_engine_explores_it_as_python_does():
    engine, python = (
        db.explore(ArmRepertoire(5), db.default_strategy(0.05), 200, rng=0, engine=engine)
        for engine in ("rust", "python")
    )
    assert engine.effects.tolist() == python.effects.tolist()


def test_bad_input():
    with pytest.raises(ValueError, match="joints must be"):
        ArmRepertoire(0)
    with pytest.raises(ValueError, match=r"command\[0\]"):
        ArmRepertoire(2)([4.0, 0.0])
