"""Seeds by place: each exploration has its own seed, whenever and wherever it runs."""

from __future__ import annotations

from typing import TYPE_CHECKING

from numpy.random import Generator, SeedSequence

from divbandit._checks import generator

if TYPE_CHECKING:
    from divbandit._checks import Rng


def root(rng: Rng) -> SeedSequence:
    """Return the sequence that all seeds derive from; a Generator draws one number for it."""
    given = generator(rng)  # raises if `rng` is wrong
    if isinstance(rng, SeedSequence):
        return rng
    if isinstance(rng, Generator):
        return SeedSequence(int(given.random() * 2**53))
    return SeedSequence(None if rng is None else int(rng))


def child(parent: SeedSequence, place: int) -> SeedSequence:
    """Return the child that a new `parent` would spawn at `place`; `parent` is not changed."""
    return SeedSequence(
        parent.entropy, spawn_key=(*parent.spawn_key, place), pool_size=parent.pool_size
    )
