"""Importing the package gets everything ready that a first call would else have to look up."""

import os
import subprocess
import sys
import sysconfig

import pytest

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
    command = [sys.executable, "-c", SCRIPT]
    assert subprocess.run(command, capture_output=True, text=True, check=True).stdout == "[]\n"  # noqa: S603


@pytest.mark.skipif(not sysconfig.get_config_var("Py_GIL_DISABLED"), reason="has the global lock")
def test_a_free_threaded_python_stays_without_the_global_lock():
    """It takes the lock, with a warning, for modules that do not say they can do without."""
    script = "import sys, divbandit; print(sys._is_gil_enabled())"
    command = [sys.executable, "-W", "error", "-c", script]
    plain = {name: value for name, value in os.environ.items() if name != "PYTHON_GIL"}
    done = subprocess.run(command, capture_output=True, text=True, check=True, env=plain)  # noqa: S603
    assert done.stdout == "False\n"
