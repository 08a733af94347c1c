"""The adapters without their libraries, and the same bits in every process."""

import os
import subprocess
import sys

import pytest

WITHOUT = """
import sys
sys.modules[{name!r}] = None
from divbandit import adapters
try:
    adapters.{call}
except ModuleNotFoundError as error:
    print(error)
"""

BITS = """
import hashlib
import optuna
import divbandit as db
from divbandit.adapters import OptunaSampler, RibsEmitter
arm = db.PlanarArm(4)
samplers = [optuna.samplers.TPESampler, optuna.samplers.CmaEsSampler]
parts = [RibsEmitter("line"), RibsEmitter("evolution"), *map(OptunaSampler, samplers)]
run = db.explore(arm, db.Adapt(parts, tau=0.05), n=150, rng=0)
print(hashlib.sha256(run.commands.tobytes() + run.effects.tobytes()).hexdigest())
"""


def python(script, **environment):
    """Return what a script prints in another process, with warnings as errors."""
    command = [sys.executable, "-W", "error", "-c", script]
    done = subprocess.run(  # noqa: S603
        command, capture_output=True, text=True, check=True, env={**os.environ, **environment}
    )
    assert done.stderr == ""
    return done.stdout


@pytest.mark.parametrize(
    ("name", "call"),
    [
        ("ribs", "RibsEmitter()"),
        ("ribs", "RibsScheduler(None, [], None)"),
        ("optuna", "OptunaSampler()"),
        ("mabwiser", "MabwiserPolicy(None)"),
    ],
)
def test_says_what_to_install(name, call):
    user = call.partition("(")[0]
    expected = f"{user} needs {name}: pip install 'divbandit[{name}]'\n"
    assert python(WITHOUT.format(name=name, call=call)) == expected


def test_imports_no_library_before_it_is_used():
    script = (
        "import sys, divbandit.adapters, divbandit.plot\n"
        "divbandit.adapters.QuasiRandomBabbling()\n"
        "others = {'ribs', 'optuna', 'mabwiser', 'numba', 'distributed', 'gymnasium', 'mujoco',\n"
        "          'scipy', 'matplotlib'}\n"
        "print(sorted(others & set(sys.modules)))"
    )
    assert python(script) == "[]\n"


def test_the_same_bits_in_every_process():
    first, second = (python(BITS, PYTHONHASHSEED=seed) for seed in ("1", "2"))
    assert first == second
    assert len(first) == 65
