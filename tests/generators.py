"""Generators over each of NumPy's bit generators, and how to see their whole state."""

import numpy as np
from numpy import random

BIT_GENERATORS = (
    random.PCG64,
    random.PCG64DXSM,
    random.MT19937,
    random.Philox,
    random.SFC64,
)


def twins(bit_generator, seed=0):
    """Return two generators with the same stream."""
    return random.Generator(bit_generator(seed)), random.Generator(bit_generator(seed))


def state(rng):
    """Return all there is to a generator, comparable with ==."""
    return _plain(rng.bit_generator.state)


def _plain(value):
    if isinstance(value, dict):
        return {key: _plain(item) for key, item in value.items()}
    return value.tolist() if isinstance(value, np.ndarray) else value
