"""The length of a union of equal intervals, in exact arithmetic on the very numbers given."""

from bisect import bisect_left, bisect_right
from fractions import Fraction


def union_length(centres, tau):
    """Return the length of the union of [centre - tau, centre + tau], a Fraction."""
    tau, length, reached = Fraction(float(tau)), Fraction(0), None
    for centre in sorted({Fraction(float(centre)) for centre in centres}):
        low, high = centre - tau, centre + tau
        length += high - (low if reached is None else max(low, reached))
        reached = high
    return length


def gains(centres, tau):
    """Yield what each interval adds to those before it: they are merged into separate ones."""
    tau = Fraction(float(tau))
    lows, highs = [], []
    for centre in centres:
        low, high = Fraction(float(centre)) - tau, Fraction(float(centre)) + tau
        first, last = bisect_left(highs, low), bisect_right(lows, high)
        met = [*zip(lows[first:last], highs[first:last], strict=True)]
        yield 2 * tau - sum(min(high, b) - max(low, a) for a, b in met)
        lows[first:last] = [min(low, *(a for a, _ in met))] if met else [low]
        highs[first:last] = [max(high, *(b for _, b in met))] if met else [high]
