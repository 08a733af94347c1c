"""Starting a measure: the library's as it is, a copy of a user's."""

from __future__ import annotations

import copy

from divbandit._checks import real
from divbandit._value import Value
from divbandit.measures.protocol import Measure, RunningMeasure


def check_measure(name: str, value: object) -> Measure:
    """Return a measure, or say what is wrong with it.

    Examples
    --------
    >>> from divbandit.measures import Coverage
    >>> check_measure("measure", Coverage(0.02))
    Traceback (most recent call last):
        ...
    TypeError: measure must be a Measure, such as BallCoverage(0.02), got Coverage
    """
    # `isinstance` with a Protocol also accepts classes.
    if isinstance(value, type) or not isinstance(value, Measure):
        kind = f"the class {value.__name__}" if isinstance(value, type) else type(value).__name__
        raise TypeError(f"{name} must be a Measure, such as BallCoverage(0.02), got {kind}")
    return value


def start_measure(name: str, measure: Measure, dim: int) -> RunningMeasure:
    """Return the measure of no effects of dimension `dim`; an error calls the measure `name`.

    A user's measure is copied first, and stays as it is.

    Examples
    --------
    >>> from divbandit.measures import GridCoverage
    >>> start_measure("measure", GridCoverage(0.5), 2).add([0, 0])
    1.0
    """
    measure = check_measure(name, measure)
    mine = measure if isinstance(measure, Value) else copy.deepcopy(measure)
    running: object = mine.start(dim)
    if isinstance(running, type) or not isinstance(running, RunningMeasure):
        kind = "a class" if isinstance(running, type) else type(running).__name__
        raise TypeError(f"{name}.start must return a RunningMeasure, got {kind}")
    if len(running) > 0:
        raise ValueError(f"{name}.start must return an empty one, got {len(running)} effects")
    if running.dim != dim:
        raise ValueError(f"{name}.start must return one of dim {dim}, got {running.dim}")
    real(f"{name}.largest_gain", running.largest_gain, low=0.0)
    return running
