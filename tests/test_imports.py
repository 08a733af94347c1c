"""The packages import each other in one direction: what comes first knows nothing of the rest."""

import ast
from graphlib import TopologicalSorter
from pathlib import Path

import pytest

import divbandit as db

#: From the ground up; each imports only what stands before it.
ORDER = (
    "_core",
    "_library",
    "_portable",
    "_workers",
    "_files",
    "_checks",
    "_duration",
    "_value",
    "box",
    "history",
    "controllers",
    "environments",
    "benchmarks",
    "goals",
    "inverse",
    "strategies",
    "measures",
    "bandits",
    "callbacks",
    "_recipe",
    "exploration",
    "experiments",
    "adapters",
    "plot",
    "paper",
    "studies",
    "cli",
)
ROOT = Path(db.__file__).parent


def sources():
    """Return the files of all modules, by name."""
    found = {}
    for path in ROOT.rglob("*.py"):
        parts = [ROOT.name, *path.relative_to(ROOT).with_suffix("").parts]
        found[".".join(parts[:-1] if parts[-1] == "__init__" else parts)] = path
    return found


SOURCES = sources()
NAMES = {*SOURCES, "divbandit._core"}


def imported(node):
    """Yield the modules that are imported when code runs, also when a function is called."""
    for child in ast.iter_child_nodes(node):
        if isinstance(child, ast.If) and "TYPE_CHECKING" in ast.unparse(child.test):
            continue
        if isinstance(child, ast.Import):
            yield from (alias.name for alias in child.names)
        elif isinstance(child, ast.ImportFrom):
            for alias in child.names:
                inner = f"{child.module}.{alias.name}"
                yield inner if inner in NAMES else child.module
        yield from imported(child)


def graph():
    """Return which modules of the library each one imports."""
    return {
        name: NAMES & set(imported(ast.parse(path.read_text(encoding="utf-8"))))
        for name, path in SOURCES.items()
    }


GRAPH = graph()


def package(name):
    return name.split(".")[1]


def test_every_package_has_its_place():
    assert {package(name) for name in NAMES - {"divbandit"}} == set(ORDER)


@pytest.mark.parametrize("name", ORDER[1:])
def test_a_package_imports_only_what_comes_before(name):
    before = ORDER[: ORDER.index(name) + 1]
    for module in SOURCES:
        if module != "divbandit" and package(module) == name:
            beyond = {each for each in GRAPH[module] if each == "divbandit"}
            beyond |= {each for each in GRAPH[module] - beyond if package(each) not in before}
            assert not beyond, f"{module} imports {beyond}"


def test_no_modules_import_each_other_in_a_circle():
    TopologicalSorter(GRAPH).prepare()


def test_circles_and_late_imports_are_seen():
    """Held against a text: in functions as well, and not under TYPE_CHECKING."""
    text = """
from typing import TYPE_CHECKING
from divbandit import _core, box
if TYPE_CHECKING:
    from divbandit.history import History
def late():
    from divbandit.plot.data import usage_of
"""
    found = NAMES & set(imported(ast.parse(text)))
    assert found == {"divbandit._core", "divbandit.box", "divbandit.plot.data"}
