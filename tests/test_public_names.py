"""Every public name is one of its kind, says what it is, and shows an example that runs."""

import dataclasses
import doctest
import inspect
from collections import Counter

import pytest

import divbandit as db
from divbandit import _core

#: The packages one dot away; `strategies` holds what is at the top, and the starter.
KINDS = (*(name for name in db.__all__ if inspect.ismodule(getattr(db, name))), "strategies")

#: What only the library itself calls.
WITHIN = ("strategies.Starter.copy_of", "strategies.Starter.value_or_copy")


def public():
    """Return what is public, by its qualified name: at the top, and one dot away."""
    top = {name: getattr(db, name) for name in db.__all__}
    found = {name: item for name, item in top.items() if not inspect.ismodule(item)}
    for kind in KINDS:
        package = getattr(db, kind)
        for name in package.__all__:
            item = getattr(package, name)
            if not any(item is other for other in top.values()):
                found[f"{kind}.{name}"] = item
    return found


PUBLIC = public()


def members(item):
    """Return the public methods and properties that a class defines or inherits, by name."""
    if not inspect.isclass(item):
        return {}
    inherited = dir(tuple) if issubclass(item, tuple) else ()
    names = (key for key in dir(item) if not key.startswith("_") and key not in inherited)
    return {key: inspect.getattr_static(item, key) for key in names}


def is_described(raw):
    """Say whether it must have a docstring; fields are described in that of the class."""
    return inspect.isroutine(raw) or isinstance(raw, (property, classmethod, staticmethod))


MEMBERS = {
    f"{name}.{key}": (item, key, raw)
    for name, item in PUBLIC.items()
    for key, raw in members(item).items()
    if getattr(raw, "__module__", None) != "gymnasium.core"
}
FIELDS = {
    f"{name}.{field.name}": (item, field.name)
    for name, item in PUBLIC.items()
    if inspect.isclass(item) and dataclasses.is_dataclass(item)
    for field in dataclasses.fields(item)
    if not field.name.startswith("_")
}


def examples_in(item):
    return doctest.DocTestParser().get_examples(inspect.getdoc(item) or "")


def test_the_top_holds_the_names_of_a_first_afternoon():
    assert len(set(db.__all__)) == len(db.__all__)
    assert sum(not inspect.ismodule(getattr(db, name)) for name in db.__all__) <= 24


def test_the_first_screen_says_what_each_name_is_for():
    text = inspect.getdoc(db)
    assert [name for name in db.__all__ if f"`{name}`" not in text] == []
    assert len(text.splitlines()) <= 50


@pytest.mark.parametrize("kind", KINDS)
def test_a_package_lists_what_it_holds(kind):
    names = getattr(db, kind).__all__
    assert names == sorted(names, key=lambda name: (not name.isupper(), name.lower() == name, name))
    assert inspect.getdoc(getattr(db, kind))


def test_no_name_stands_for_two_things():
    """Nor does any differ from another by an s."""
    names = [name.rpartition(".")[2] for name in PUBLIC]
    assert [name for name, count in Counter(names).items() if count > 1] == []
    names += KINDS
    assert [name for name in names if f"{name}s" in names] == []


@pytest.mark.parametrize("name", PUBLIC)
def test_it_has_a_docstring_with_an_example(name):
    assert examples_in(PUBLIC[name])


@pytest.mark.parametrize("name", [name for name, (*_, raw) in MEMBERS.items() if is_described(raw)])
def test_a_member_has_a_docstring(name):
    owner, key, _ = MEMBERS[name]
    assert inspect.getdoc(getattr(owner, key))


@pytest.mark.parametrize("name", FIELDS)
def test_a_field_is_described_in_its_class(name):
    owner, field = FIELDS[name]
    assert field in inspect.getdoc(owner)


def compiled():
    """Return what of the compiled module has examples, by name: no file of Python shows them."""
    found = {}
    for name in dir(_core):
        item = getattr(_core, name)
        found |= {name: item} | {f"{name}.{key}": getattr(item, key) for key in members(item)}
    return {name: item for name, item in found.items() if examples_in(item)}


@pytest.mark.parametrize("name", compiled())
def test_compiled_examples_run(name):
    text = inspect.getdoc(compiled()[name])
    test = doctest.DocTestParser().get_doctest(text, {}, name, None, None)
    report = []
    runner = doctest.DocTestRunner(verbose=False)
    runner.run(test, out=report.append)
    assert runner.summarize(verbose=False).failed == 0, "".join(report)


SHOWN = {key for owner, key, _ in MEMBERS.values() if examples_in(getattr(owner, key))}


def is_shown(name):
    """Say whether an example shows a method: its own, another class's, or that of its class."""
    owner, key, raw = MEMBERS[name]
    if not is_described(raw) or isinstance(raw, property) or key in SHOWN:
        return True
    return any(f"{key}(" in example.source for example in examples_in(owner))


def test_every_method_is_shown_in_an_example():
    assert [name for name in MEMBERS if not is_shown(name)] == list(WITHIN)
