"""Empty measures: the templates of those that a bandit or an evaluation works with."""

from __future__ import annotations

import copy
from typing import cast

from divbandit._checks import real, whole
from divbandit._core import Coverage
from divbandit.measures.protocol import Measure

#: Up to here Coverage is asked which dimensions it takes.
_ASKED = 64


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
    if isinstance(value, type) or not isinstance(value, (Measure, Coverage)):
        kind = f"the class {value.__name__}" if isinstance(value, type) else type(value).__name__
        raise TypeError(f"{name} must be a Measure, such as Coverage(0.02), got {kind}")
    measure = cast("Measure", value)
    if len(measure) > 0:
        raise ValueError(f"{name} must be empty, got one that holds {len(measure)} effects")
    whole(f"{name}.dim", measure.dim, low=1)
    real(f"{name}.largest_gain", largest_gain(measure), low=0.0)
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
        return cast("Measure", Coverage(tau, dim=dim))
    except ValueError as error:
        dims = [dim for dim in range(1, _ASKED + 1) if _takes(tau, dim)]
        must_be = f"{dims[0]}" if len(dims) == 1 else f"from {dims[0]} to {dims[-1]}"
        raise ValueError(
            f"effects must have dimension {must_be} for {name}, got {dim}: {error}"
        ) from None


def largest_gain(measure: Measure) -> float:
    """Return what no gain of an empty measure exceeds.

    Examples
    --------
    >>> largest_gain(covering("Adapt", 0.5, 2))
    0.7853981633974483
    """
    if hasattr(measure, "largest_gain"):
        return measure.largest_gain
    # A Coverage that does not say so itself: what the first effect of all gains, a ball.
    return float(measure.gain([0.0] * measure.dim))


def _takes(tau: float, dim: int) -> bool:
    try:
        Coverage(tau, dim=dim)
    except ValueError:
        return False
    return True
