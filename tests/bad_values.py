"""What users pass by mistake, by the kind of argument that it was meant for.

Each kind has all that its validator must refuse, for one argument of the kind; `some` of it is
enough for the others.
"""

import math
from fractions import Fraction
from types import SimpleNamespace

import numpy as np

import divbandit as db

RMB = db.MotorBabbling()


def some(values, *names):
    """Return some of the values."""
    return {name: values[name] for name in names}


def points(n):
    """Return what is no finite point of R^n inside [-1, 1]^n, nor an array of such."""
    return {
        "text": "ab",
        "texts": ["a"] * n,
        "bytes": b"ab",
        "complex": [1j] * n,
        "bools": [True] * n,
        "an array of bools": np.ones(n, dtype=bool),
        "objects": [object()] * n,
        "masked": np.ma.masked_array(np.zeros(n), mask=[True] * n),
        "None": None,
        "Nones": [None] * n,
        "dates": np.zeros(n, dtype="M8[s]"),
        "fractions": [Fraction(1, 2)] * n,
        "a dict": {},
        "a set": {0.0},
        "nan": [math.nan] + [0.0] * (n - 1),
        "inf": [0.0] * (n - 1) + [math.inf],
        "-inf": [0.0] * (n - 1) + [-math.inf],
        "too large a number": [10**400] + [0] * (n - 1),
        "empty": [],
        "a scalar": 0.0,
        "too short": [0.0] * (n - 1),
        "too long": [0.0] * (n + 1),
        "ragged": [[0.0] * n, [0.0] * (n + 1)],
        "rows too long": [[0.0] * (n + 1)],
        "too deep": [[[0.0] * n]],
    }


def rows(n):
    """Return what is no array of finite points of R^n."""
    good = [0.0] * n
    bad = {
        name: [value, value] if isinstance(value, list) else value
        for name, value in points(n).items()
    }
    shapes = {"one point": good, "too deep": [[good]], "empty": [], "a scalar": 0.0}
    return bad | shapes | {"a bad second row": [good, [math.inf] * n]}


NUMBERS = {
    "text": "0.5",
    "bytes": b"1",
    "complex": 1j,
    "NumPy's complex": np.complex128(1),
    "bool": True,
    "NumPy's bool": np.True_,
    "object": object(),
    "None": None,
    "a list": [0.5],
    "an array": np.array([0.5, 0.5]),
    "an array of one": np.array([0.5]),
    "an array of bool": np.array(True),  # noqa: FBT003
    "a date": np.datetime64("2020-01-01"),
    "nan": math.nan,
    "inf": math.inf,
    "-inf": -math.inf,
    "too large": 10**400,
    "too small": -(10**400),
}

COUNTS = {
    "negative": -1,
    "very negative": -(10**30),
    "a float": 2.0,
    "NumPy's float": np.float64(2),
    "bool": True,
    "NumPy's bool": np.True_,
    "text": "3",
    "nan": math.nan,
    "a list": [1],
    "an array": np.array([1, 2]),
    "an array of one": np.array([1]),
    "complex": 1j,
    "object": object(),
}

FLAGS = {"1": 1, "0.0": 0.0, "None": None, "text": "yes", "a list": [True], "object": object()}

WRONG_SPACES = {
    "a number": 5,
    "text": "ab",
    "a pair": ([0], [1]),
    "an array": np.zeros((2, 2)),
    "a low alone": SimpleNamespace(low=[0, 0]),
    "low above high": SimpleNamespace(low=[0, 1], high=[1, 0]),
    "corners of two lengths": SimpleNamespace(low=[0, 0], high=[1, 1, 1]),
    "nan": SimpleNamespace(low=[0, math.nan], high=[1, 1]),
    "endless": SimpleNamespace(low=[0, 0], high=[1, math.inf]),
    "no coordinate": SimpleNamespace(low=[], high=[]),
    "bools": SimpleNamespace(low=[False], high=[True]),
    "scalars": SimpleNamespace(low=0, high=1),
}

NOT_STRATEGIES = {
    "None": None,
    "nothing": [],
    "a single one": RMB,
    "a class": [db.MotorBabbling],
    "text": "ab",
    "a number": 5,
    "one is None": [RMB, None],
    "one is an object": [RMB, object()],
}

NOT_MEASURES = {
    "text": "ab",
    "a number": 0.02,
    "a class": db.measures.GridCoverage,
    "a tree": db.NearestNeighbors(2),
    "a function": db.coverage,
    "an object": object(),
    "one under way": db.Coverage(0.02),
    "one that starts nothing": SimpleNamespace(start=lambda _: None),
}

NOT_PHASES = {
    "None": None,
    "nothing": [],
    "a single strategy": RMB,
    "strategies": [RMB, RMB],
    "a single number": [(1,)],
    "triples": [(1, RMB, 1)],
    "no strategy": [(1, object())],
    "endless before the last": [(None, RMB), (None, RMB)],
    "zero steps": [(0, RMB)],
    "negative steps": [(-1, RMB)],
    "a float of steps": [(1.0, RMB)],
    "a bool of steps": [(True, RMB)],
    "text for steps": [("1", RMB)],
}

NOT_WEIGHTS = {name: bad for name, bad in points(2).items() if name != "None"} | {
    "negative": [0.5, -0.1],
    "all zero": [0, 0],
    "an endless sum": [1e308, 1e308],
}

NOT_SEEDS = {
    "text": "seed",
    "a float": 1.5,
    "negative": -1,
    "bool": True,
    "NumPy's bool": np.True_,
    "nan": math.nan,
    "complex": 1j,
    "object": object(),
    "floats": [0.5],
    "the module": np.random,
    "an old generator": np.random.RandomState(0),
}

NOT_GENERATORS = NOT_SEEDS | {
    "None": None,
    "a seed": 0,
    "a sequence of seeds": np.random.SeedSequence(0),
    "a bit generator": np.random.PCG64(0),
}
