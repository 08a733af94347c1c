"""What all tests share: Hypothesis draws the same examples each time, however long they take."""

import os

from hypothesis import settings

settings.register_profile("same", derandomize=True, deadline=None, database=None)
settings.load_profile("same")

# pyribs compiles its evolution strategies in each process: that takes longer than all they do here.
os.environ.setdefault("NUMBA_DISABLE_JIT", "1")

# A script for an installed wheel, with no tests to collect.
collect_ignore = ["smoke.py"]
