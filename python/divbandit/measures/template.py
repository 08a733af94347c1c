"""Empty measures: the templates of those that a bandit or an evaluation works with."""

from __future__ import annotations

import copy

from divbandit._checks import real, whole
from divbandit.measures.coverage import Coverage
from divbandit.measures.protocol import Measure


def copy_of(name: str, value: object) -> Measure:
    """Return a copy of an empty measure, or say what is wrong with it.

    Examples
    --------
    >>> import divbandit as db
    >>> template = db.GridCoverage(0.5)
    >>> copy_of("measure", template).add([0, 0]), len(template)
    (1.0, 0)
    """
    # A class has all the names that an instance has.
    if isinstance(value, type) or not isinstance(value, Measure):
        kind = f"the class {value.__name__}" if isinstance(value, type) else type(value).__name__
        raise TypeError(f"{name} must be a Measure, such as Coverage(0.02), got {kind}")
    measure = value
    if len(measure) > 0:
        raise ValueError(f"{name} must be empty, got one that holds {len(measure)} effects")
    whole(f"{name}.dim", measure.dim, low=1)
    real(f"{name}.largest_gain", measure.largest_gain, low=0.0)
    return copy.deepcopy(measure)


def covering(name: str, tau: float, dim: int) -> Measure:
    """Return an empty Coverage for effects of `dim` coordinates; `name` is what asks for it.

    Examples
    --------
    >>> covering("Adapt", 0.5, 2).dim
    2
    """
    Coverage(tau)  # what is wrong with tau is said first
    try:
        # Of a seed of its own: an exploration's draws are the same whatever its measure is.
        return Coverage(tau, dim=dim, rng=0)
    except ValueError as error:
        raise ValueError(
            f"effects must be of a dimension that {name} takes, got {dim}: {error}"
        ) from None
