"""Every public name says what it is, and every callable shows an example that runs."""

import dataclasses
import doctest
import inspect
from collections.abc import Sequence

import pytest

import divbandit as db
from divbandit import _core

CORE = (
    "Bounds",
    "Coverage",
    "Engine",
    "Estimator",
    "NearestNeighbors",
    "Obstacle",
    "ObstructedArm",
    "PlanarArm",
    "Policy",
    "PushArm",
    "as_point",
    "babble",
    "exp",
    "frontier_goal",
    "inverse",
    "k_nearest",
    "local_jacobian",
    "local_regression",
    "log",
    "normal_quantile",
    "novel_goal",
    "power",
    "powers",
    "proportionally",
    "uncovered_goal",
    "untried_goal",
)


def members(name, item):
    """Yield a class's public methods and properties, each with its qualified name."""
    if inspect.isclass(item):
        inherited = dir(tuple) if issubclass(item, tuple) else ()
        for key in dir(item):
            if not key.startswith("_") and key not in inherited:
                yield f"{name}.{key}", inspect.getattr_static(item, key), getattr(item, key)


def public():
    """Return {qualified name: (as the class holds it, as it is reached)} of all public names."""
    names = {}
    for name in db.__all__:
        item = getattr(db, name)
        if inspect.ismodule(item):
            continue  # its functions are found as doctests of its files
        names[name] = (item, item)
        names |= {key: (raw, reached) for key, raw, reached in members(name, item)}
    return names


def of_bandits():
    """Yield the names of the package of bandits, each with what it is."""
    for name in db.bandits.__all__:
        item = getattr(db.bandits, name)
        yield f"bandits.{name}", item
        for key, _, reached in members(f"bandits.{name}", item):
            if callable(reached):
                yield key, reached


def compiled():
    for name in CORE:
        item = getattr(_core, name)
        yield f"_core.{name}", item
        for key, _, reached in members(f"_core.{name}", item):
            yield key, reached


PUBLIC = public()
DOCUMENTED = {
    **{name: reached for name, (_, reached) in PUBLIC.items()},
    **dict(of_bandits()),
    **dict(compiled()),
}


def is_field(name):
    """Say whether it is a plain attribute, described in the docstring of its class."""
    raw, reached = PUBLIC[name]
    owner, _, key = name.partition(".")
    slot = inspect.ismemberdescriptor(raw) or key in getattr(getattr(db, owner), "_fields", ())
    return slot or not (callable(reached) or hasattr(type(reached), "__get__"))


def examples_in(item):
    return doctest.DocTestParser().get_examples(inspect.getdoc(item) or "")


def test_all_is_sorted_and_complete():
    assert db.__all__ == sorted(db.__all__)
    assert all(hasattr(db, name) for name in db.__all__)
    assert not any(name.startswith("_") for name in db.__all__)


def test_the_compiled_module_holds_what_the_tests_know_of():
    assert {name for name in dir(_core) if not name.startswith("_")} == set(CORE)


@pytest.mark.parametrize("name", [name for name in PUBLIC if not is_field(name)])
def test_has_a_docstring(name):
    assert inspect.getdoc(PUBLIC[name][1])


@pytest.mark.parametrize("name", [name for name in PUBLIC if is_field(name)])
def test_a_field_is_described_in_its_class(name):
    owner, field = name.split(".")
    assert field in inspect.getdoc(getattr(db, owner))


@pytest.mark.parametrize("field", dataclasses.fields(db.Exploration), ids=lambda field: field.name)
def test_a_field_of_an_exploration_is_described(field):
    assert f"{field.name} : " in inspect.getdoc(db.Exploration)


@pytest.mark.parametrize("name", DOCUMENTED)
def test_its_examples_run(name, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    text = inspect.getdoc(DOCUMENTED[name]) or ""
    test = doctest.DocTestParser().get_doctest(text, {}, name, None, None)
    report = []
    runner = doctest.DocTestRunner(verbose=False)
    runner.run(test, out=report.append)
    assert runner.summarize(verbose=False).failed == 0, "".join(report)


@pytest.mark.parametrize("name", dict(of_bandits()))
def test_a_part_of_a_bandit_has_a_docstring(name):
    assert inspect.getdoc(dict(of_bandits())[name])


@pytest.mark.parametrize("name", db.bandits.__all__)
def test_a_part_of_a_bandit_shows_an_example(name):
    assert examples_in(getattr(db.bandits, name))


def lacks_an_example(name):
    """Say whether a callable has no example; one that overrides may leave it to its base."""
    raw, reached = PUBLIC[name]
    if isinstance(raw, property) or not callable(reached) or examples_in(reached):
        return False
    if getattr(reached, "__module__", None) == Sequence.__module__:  # what any sequence has
        return False
    owner, _, method = name.partition(".")
    bases = getattr(db, owner).__mro__[1:] if method else ()
    return not any(examples_in(getattr(base, method, None)) for base in bases)


def test_every_public_callable_shows_an_example():
    assert [name for name in PUBLIC if lacks_an_example(name)] == []
