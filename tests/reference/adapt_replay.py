"""What an Adapt believes at each step, recomputed from the log alone.

The definition, word by word: the gain of an effect is taken over all effects before it, whoever
produced them; a strategy's diversity is the mean of its last `window` gains, with the head start
placed first. Sums are made with fractions, so they are exact and rounded once.
"""

from fractions import Fraction

import divbandit as db


def replay(adapt, effects, paths, prefix=(), measure=None):
    """Return the estimates before each step, and after the last.

    Parameters
    ----------
    adapt : Adapt
        Only its parameters are read.
    effects : (n, s) array
    paths : n tuples of int
        Who chose each command.
    prefix : tuple of int
        Where the Adapt stands: the path of its own proposals.
    measure : running measure, optional
        What gains are taken by; the coverage with the Adapt's tau by default.
    """
    measure = db.Coverage(adapt.tau) if measure is None else measure
    windows = [[measure.largest_gain] * adapt.head_start for _ in adapt.strategies]
    beliefs = [_means(windows)]
    for effect, path in zip(effects, paths, strict=True):
        gain = measure.add(effect)
        depth = len(prefix)
        if tuple(path[:depth]) == prefix:
            child = path[depth]
            windows[child] = [*windows[child], gain][-adapt.window :]
        beliefs.append(_means(windows))
    return beliefs


def beliefs(adapt, run, measure):
    """Return the estimates before each step of a run, by a running measure."""
    return replay(adapt, run.effects, run.paths.tolist(), measure=measure)[:-1]


def _means(windows):
    return tuple(_mean(window) for window in windows)


def _mean(gains):
    return float(sum(map(Fraction, gains))) / len(gains) if gains else 0.0
