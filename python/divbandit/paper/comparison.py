"""Comparison: figure 4's 66 points beside the archived ones, in standard errors."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import TYPE_CHECKING

from divbandit._files import write_csv
from divbandit.paper import figure4

if TYPE_CHECKING:
    from collections.abc import Iterable, Sequence
    from pathlib import Path

#: Repetitions behind each archived point.
ARCHIVED_REPETITIONS = 25
#: The archive drew discs as 64-gons, up to this share smaller.
POLYGON_SHARE = 0.002


@dataclass(frozen=True)
class Comparison:
    """One point, the archived one, and how far apart they are.

    Attributes
    ----------
    point, archived : Point
    repetitions : int
        Behind `point`.
    """

    point: figure4.Point
    archived: figure4.Point
    repetitions: int

    @property
    def standard_error(self) -> float:
        """The standard error of the difference: both sides combined."""
        return math.sqrt(
            self.point.std**2 / self.repetitions + self.archived.std**2 / ARCHIVED_REPETITIONS
        )

    @property
    def difference(self) -> float:
        """The difference of the means, in standard errors."""
        return (self.point.mean - self.archived.mean) / self.standard_error

    def beyond(self, errors: float) -> bool:
        """Say whether the means differ by more than so many standard errors and a 64-gon."""
        allowed = errors * self.standard_error + POLYGON_SHARE * self.archived.mean
        return abs(self.point.mean - self.archived.mean) > allowed


def compare(points: Iterable[figure4.Point], repetitions: int) -> list[Comparison]:
    """Put each point beside the archived one.

    Parameters
    ----------
    points : iterable of Point
        From `divbandit.paper.figure4.run`.
    repetitions : int
        How many explorations are behind each.

    Examples
    --------
    >>> from divbandit.paper import compare, figure4
    >>> {c.difference for c in compare(figure4.archive(), repetitions=25)}
    {0.0}
    """
    archived = {point.key: point for point in figure4.archive()}
    return [Comparison(point, archived[point.key], repetitions) for point in points]


def save(comparisons: Iterable[Comparison], path: Path) -> None:
    """Write the comparison as CSV."""
    rows = []
    for c in comparisons:
        numbers = (c.point.mean, c.point.std, c.archived.mean, c.archived.std)
        named = (c.point.d, c.point.strategy, _ratio(c))
        rows.append([*named, *(f"{each:.6f}" for each in numbers), f"{c.difference:+.3f}"])
    names = ("d", "strategy", "motor_ratio")
    numbers_of = ("mean", "std", "archived_mean", "archived_std", "difference_in_standard_errors")
    write_csv(path, (*names, *numbers_of), rows)


def table(comparisons: Sequence[Comparison]) -> str:
    """Return the comparison as text, with last lines that count the outliers."""
    lines = ["    d  strategy        mean     std   archive     std  difference (std. errors)"]
    for c in comparisons:
        mark = " **" if c.beyond(4) else " *" if c.beyond(2) else ""
        lines.append(
            f"{c.point.d:5}  {c.point.strategy:7} {_ratio(c):4}  "
            f"{c.point.mean:8.4f} {c.point.std:7.4f}  "
            f"{c.archived.mean:8.4f} {c.archived.std:7.4f}  {c.difference:+6.2f}{mark}"
        )
    for errors, mark in ((2, "*"), (4, "**")):
        plain = sum(abs(c.difference) > errors for c in comparisons)
        allowed = sum(c.beyond(errors) for c in comparisons)
        lines.append(
            f"beyond {errors} standard errors: {plain} of {len(comparisons)}; with 0.2 % allowed "
            f"for the archive's 64-gons ({mark}): {allowed}"
        )
    return "\n".join(lines)


def _ratio(comparison: Comparison) -> str:
    ratio = comparison.point.motor_ratio
    return "" if ratio is None else f"{ratio:.2f}"
