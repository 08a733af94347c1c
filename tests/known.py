"""What goal samplers and inverse models know in the tests: histories drawn at random."""

import numpy as np
from hypothesis import strategies as st

import divbandit as db

DIMS = st.integers(1, 4)
SEEDS = st.integers(0, 2**32)


def history(m, s, n, seed):
    """Return `n` evaluations from R^m to R^s, among them duplicates, and ones on a line.

    Some motor ranges and some ranges of goals have no width.
    """
    rng = np.random.default_rng(seed)
    low, base = rng.normal(size=m), rng.normal(size=s)
    motor = db.Box(low, low + rng.choice([0, 1e-3, 1, 5], size=m))
    sensory = db.Box(base, base + rng.choice([0, 1, 2], size=s, p=[0.1, 0.5, 0.4]))
    past = db.History(motor, sensory)
    on_a_line = rng.random() < 0.3
    for _ in range(n):
        effect = sensory.sample(rng) + 0.1 * rng.normal(size=s)
        if on_a_line:
            effect = base + rng.random() * np.ones(s)
        if len(past) and rng.random() < 0.2:
            effect = past.effects[rng.integers(len(past))]
        past.append(motor.sample(rng), effect)
    return past


@st.composite
def histories(draw):
    return history(draw(DIMS), draw(DIMS), draw(st.integers(1, 30)), draw(SEEDS))
