"""Scripts that are run by an interpreter of their own."""

import os
import subprocess
import sys


def printed(script, **environment):
    """Return what a script prints in another process, with warnings as errors."""
    command = [sys.executable, "-W", "error", "-c", script]
    done = subprocess.run(  # noqa: S603 - our own
        command, capture_output=True, text=True, check=True, env={**os.environ, **environment}
    )
    assert done.stderr == ""
    return done.stdout
