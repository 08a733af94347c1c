"""What all tests share: Hypothesis draws the same examples each time, however long they take."""

from hypothesis import settings

settings.register_profile("same", derandomize=True, deadline=None, database=None)
settings.load_profile("same")

# A script for an installed wheel, with no tests to collect.
collect_ignore = ["smoke.py"]
