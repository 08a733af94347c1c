"""Measures of diversity: what a set of effects covers, and what one more effect adds."""

from typing import TYPE_CHECKING

from divbandit.measures.balls import BallCoverage
from divbandit.measures.boundary import Loop, to_shapely
from divbandit.measures.cells import CellCoverage
from divbandit.measures.coverage import Coverage, coverage
from divbandit.measures.entropy import Entropy
from divbandit.measures.grid import GridCoverage
from divbandit.measures.protocol import Measure, RunningMeasure
from divbandit.measures.sparseness import Sparseness

__all__ = [
    "BallCoverage",
    "CellCoverage",
    "Coverage",
    "Entropy",
    "GridCoverage",
    "Loop",
    "Measure",
    "RunningMeasure",
    "Sparseness",
    "coverage",
    "to_shapely",
]

if TYPE_CHECKING:  # what mypy is to hold to the protocols
    _MEASURES: tuple[type[Measure], ...] = (
        BallCoverage,
        CellCoverage,
        Entropy,
        GridCoverage,
        Sparseness,
    )
    _RUNNING: type[RunningMeasure] = Coverage
