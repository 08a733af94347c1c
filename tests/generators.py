"""Generators over each of NumPy's bit generators, and how to see their whole state."""

import math

import numpy as np
from numpy import random

BIT_GENERATORS = (random.PCG64, random.PCG64DXSM, random.MT19937, random.Philox, random.SFC64)


#: Draws that can be given: two 32-bit words each, of the 624 that a Mersenne twister holds.
MOST = 312


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


def scripted(*numbers):
    """Return a generator whose next draws, at most `MOST`, are given; each rounded up to 53 bits.

    MT19937 hands out its state word by word, scrambled in a way that can be undone.
    """
    words = []
    for number in numbers:
        high, low = divmod(math.ceil(number * 2**53), 2**26)
        words += [high << 5, low << 6]
    key = np.zeros(624, np.uint32)
    key[: len(words)] = [_unscrambled(word) for word in words]
    bit_generator = random.MT19937()
    bit_generator.state = {"bit_generator": "MT19937", "state": {"key": key, "pos": 0}}
    return random.Generator(bit_generator)


def draws_from(rng):
    """Return how often a scripted generator was drawn from."""
    return rng.bit_generator.state["state"]["pos"] // 2


def _unscrambled(word):
    """Return the word of the state that MT19937 hands out as this one."""
    word ^= word >> 18
    word ^= word << 15 & 0xEFC60000
    found = word
    for _ in range(4):  # the lowest 7 bits are right, and 7 more after each round
        found = word ^ (found << 7 & 0x9D2C5680)
    word = found
    for _ in range(2):  # the highest 11 bits are right, and 11 more after each round
        found = word ^ found >> 11
    return found
