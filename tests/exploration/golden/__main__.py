"""Write the golden traces anew: ``python -m tests.exploration.golden``, in the project's folder.

That is right only where trajectories were meant to change - a kernel that rounds otherwise, a
strategy that draws otherwise - and then the changelog says so: nobody's explorations come out as
before. The traces are those of the Python loop, which says what an exploration is. With
``--check`` nothing is written, and it is said what differs, with either engine; that needs NumPy
and nothing else.
"""

import sys

from tests.exploration.golden.configurations import CONFIGURATIONS
from tests.exploration.golden.digest import digest
from tests.exploration.golden.traces import read, write


def differing(engine):
    """Return the names of those that do not come out as they were kept."""
    kept = read()
    made = {name: digest(*each.explore(engine)) for name, each in CONFIGURATIONS.items()}
    return sorted(name for name in kept | made if kept.get(name) != made.get(name))


if __name__ == "__main__":
    if sys.argv[1:] == ["--check"]:
        found = {engine: differing(engine) for engine in ("python", "rust")}
        sys.exit(f"These differ: {found}" if any(found.values()) else None)
    write({name: digest(*each.explore("python")) for name, each in CONFIGURATIONS.items()})
