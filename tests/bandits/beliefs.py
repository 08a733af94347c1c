"""What an Adapt believes at each step of a run, recomputed with any measure."""

from fractions import Fraction


def replay(adapt, run, measure):
    """Return the beliefs before each step by a running measure: the definition, in fractions."""
    windows = [[measure.largest_gain] * adapt.head_start for _ in adapt.strategies]
    beliefs = []
    for effect, choice in zip(run.effects, run.choices, strict=True):
        beliefs.append([float(sum(map(Fraction, w)) / len(w)) if w else 0.0 for w in windows])
        windows[choice] = [*windows[choice], measure.add(effect)][-adapt.window :]
    return beliefs
