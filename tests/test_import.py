"""Importing the package: what a first call needs is ready, and no optional library is imported."""

import sysconfig

import pytest

from tests.scripts import printed

SCRIPT = """
import sys
import numpy as np
import divbandit._core as core
points, called = np.zeros((3, 2)), []
sys.setprofile(lambda frame, event, _: event == "call" and called.append(frame.f_code.co_name))
core.Bounds(points[0], points[1])
core.NearestNeighbors(2).extend(points)
sys.setprofile(None)
print(called)
"""


def test_the_first_array_makes_no_call_of_python():
    """In such a call Ctrl-C could come where nothing may fail."""
    assert printed(SCRIPT) == "[]\n"


@pytest.mark.skipif(not sysconfig.get_config_var("Py_GIL_DISABLED"), reason="has the global lock")
def test_a_free_threaded_python_stays_without_the_global_lock(monkeypatch):
    """It takes the lock, with a warning, for modules that do not say they can do without."""
    script = "import sys, divbandit; print(sys._is_gil_enabled())"
    monkeypatch.delenv("PYTHON_GIL", raising=False)
    assert printed(script) == "False\n"


def test_no_optional_library_is_imported_before_it_is_used():
    script = """
import sys, divbandit.adapters, divbandit.environments.mujoco, divbandit.plot
divbandit.adapters.QuasiRandomBabbling()
others = "ribs optuna mabwiser numba distributed gymnasium mujoco scipy matplotlib".split()
print(set(others) & set(sys.modules))
"""
    assert printed(script) == "set()\n"


#: What is called without a library, and what it says to need.
NEEDS = {
    "explore(PlanarArm(2), adapters.QuasiRandomBabbling(), 1)": "QuasiRandomBabbling scipy qmc",
    "adapters.RibsEmitter()": "RibsEmitter ribs ribs",
    "adapters.RibsScheduler(None, [], None)": "RibsScheduler ribs ribs",
    "adapters.OptunaSampler()": "OptunaSampler optuna optuna",
    "adapters.MabwiserPolicy(None)": "MabwiserPolicy mabwiser mabwiser",
    "adapters.OneStepEnv": "OneStepEnv gymnasium gymnasium",
    "environments.GymnasiumEnvironment('A-v1', None, None, 1, 0)": (
        "GymnasiumEnvironment gymnasium gymnasium"
    ),
    "environments.mujoco.reacher()": "reacher mujoco mujoco",
    "environments.mujoco.pusher()": "pusher mujoco mujoco",
}


def test_without_an_optional_library_it_is_said_what_to_install():
    script = f"""
import sys
import divbandit, divbandit.adapters, divbandit.environments.mujoco
for call, words in {NEEDS}.items():
    library = words.split()[1]
    sys.modules[library] = None
    try:
        eval(call, vars(divbandit))
    except ImportError as error:
        print(error)
    del sys.modules[library]
"""
    expected = [
        f"{user} needs {'SciPy' if library == 'scipy' else library}: "
        f"pip install 'divbandit[{extra}]'"
        for user, library, extra in map(str.split, NEEDS.values())
    ]
    assert printed(script).splitlines() == expected
