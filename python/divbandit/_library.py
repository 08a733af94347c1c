"""Optional libraries: import them, seed them, name their parts."""

from __future__ import annotations

from functools import partial
from importlib import import_module
from typing import TYPE_CHECKING

from divbandit._core import undisturbed

if TYPE_CHECKING:
    from types import ModuleType

    from numpy.random import Generator


def library(name: str, *, user: str, extra: str | None = None) -> ModuleType:
    """Import a library, or say how to install it; its extra has the same name, or that given.

    Examples
    --------
    >>> library("fractions", user="Example").Fraction(1, 2)
    Fraction(1, 2)
    >>> library("not_there", user="Example")
    Traceback (most recent call last):
        ...
    ModuleNotFoundError: Example needs not_there: pip install 'divbandit[not_there]'
    """
    try:  # a library whose import was interrupted cannot be imported again
        return undisturbed(import_module, name)
    except ModuleNotFoundError as error:
        if error.name != name:  # it is there, and lacks something itself
            raise
        raise ModuleNotFoundError(
            f"{user} needs {name}: pip install 'divbandit[{extra or name}]'", name=name
        ) from None


def seed_from(rng: Generator) -> int:
    """Return a seed of 32 bits, which every library takes: one ``rng.random()``.

    Examples
    --------
    >>> import numpy as np
    >>> seed_from(np.random.default_rng(0))
    2735729615
    """
    return int(rng.random() * 2**32)


def named(factory: object) -> str:
    """Return how a class, a function or a partial of one is called, without its address.

    Examples
    --------
    >>> from functools import partial
    >>> from fractions import Fraction
    >>> named(Fraction), named(partial(Fraction, 1, denominator=2)), named("line")
    ('Fraction', 'partial(Fraction, 1, denominator=2)', "'line'")
    """
    if isinstance(factory, partial):
        given = [repr(value) for value in factory.args]
        given += [f"{key}={value!r}" for key, value in factory.keywords.items()]
        return f"partial({', '.join([named(factory.func), *given])})"
    name = getattr(factory, "__qualname__", None)
    return name if isinstance(name, str) else repr(factory)
