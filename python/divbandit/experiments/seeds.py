"""Seeds by place: each of many explorations has its own, whenever and wherever it runs."""

from __future__ import annotations

from typing import TYPE_CHECKING

from numpy.random import Generator, SeedSequence

from divbandit._checks import generator

if TYPE_CHECKING:
    from divbandit._checks import Rng


def root(rng: Rng) -> SeedSequence:
    """Return what the seeds of all places come from; a Generator gives one number for it.

    Examples
    --------
    >>> root(7).entropy
    7
    """
    given = generator(rng)  # or what is wrong with it
    if isinstance(rng, SeedSequence):
        return rng
    if isinstance(rng, Generator):
        return SeedSequence(int(given.random() * 2**53))
    return SeedSequence(None if rng is None else int(rng))


def child(parent: SeedSequence, place: int) -> SeedSequence:
    """Return the child that a fresh `parent` would spawn at `place`; `parent` stays as it is.

    Examples
    --------
    >>> from numpy.random import SeedSequence
    >>> child(SeedSequence(7), 2).state == SeedSequence(7).spawn(3)[2].state
    True
    """
    return SeedSequence(
        parent.entropy, spawn_key=(*parent.spawn_key, place), pool_size=parent.pool_size
    )
