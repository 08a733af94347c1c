"""A generator whose next draws are chosen, so that also the rarest of them are met."""

import numpy as np

#: The largest number that ``rng.random()`` returns.
BELOW_ONE = 1 - 2.0**-53

#: How many draws can be chosen: two 32-bit words each, of the 624 that a Mersenne twister holds.
MOST = 312

_BITS = 2**32 - 1


def stream(draws):
    """Return a generator whose ``random()`` gives `draws`, multiples of 2**-53, and then others."""
    assert len(draws) <= MOST
    twister = np.random.MT19937(0)
    key = np.arange(1, 625, dtype=np.uint32)
    for index, draw in enumerate(draws):
        high, low = divmod(int(draw * 2**53), 2**26)
        key[2 * index : 2 * index + 2] = _untempered(high << 5), _untempered(low << 6)
    twister.state = {"bit_generator": "MT19937", "state": {"key": key, "pos": 0}}
    return np.random.Generator(twister)


def _untempered(word):
    """Return the word of the state that the twister gives out as `word`.

    Each of its four steps is a bijection of 32 bits: repeating the inverse's first guess recovers
    more and more of the bits.
    """
    for shift, mask in ((-18, _BITS), (15, 0xEFC60000), (7, 0x9D2C5680), (-11, _BITS)):
        before = word
        for _ in range(5):
            shifted = before << shift if shift > 0 else before >> -shift
            before = word ^ (shifted & mask)
        word = before
    return word
