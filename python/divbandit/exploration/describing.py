"""describing: an exploration in a few lines."""

from __future__ import annotations

from collections import Counter
from typing import TYPE_CHECKING

import numpy as np

if TYPE_CHECKING:
    from collections.abc import Sequence

    from divbandit.exploration.result import Exploration
    from divbandit.measures import Measure

#: How many reasons of failures are shown, the most frequent first.
_REASONS = 5


def described(run: Exploration, measure: Measure | None, names: Sequence[str] | None) -> str:
    """Return what happened in an exploration, and what each top-level strategy did."""
    failed = [failure.path[0] if failure.path else 0 for failure in run.failures]
    added = (run.paths == -1).all(axis=1) if run.paths.shape[1] else np.zeros(len(run), dtype=bool)
    told = run.choices[~added]
    tried = np.concatenate([told, np.array(failed, dtype=np.int64)])
    parts = max(len(run.names), int(tried.max(initial=0)) + 1)
    labels = _labels(run, parts, names)

    distinct = len(np.unique(run.effects, axis=0)) if len(run) else 0
    words = [f"{len(tried)} evaluations", f"{distinct} distinct effects"]
    if failed:
        words.insert(1, f"{len(failed)} of them failed")
    if added.any():
        words.append(f"{added.sum()} earlier ones")
    lines = [", ".join(words)]

    use = np.bincount(tried, minlength=parts) / max(len(tried), 1)
    columns = [["strategy", *labels], ["use", *(f"{100 * share:.1f} %" for share in use)]]
    if failed:
        columns.append(["failed", *map(str, np.bincount(failed, minlength=parts))])
    if measure is not None and len(run):
        gains = np.diff(run.diversity(measure), prepend=0.0)
        each = np.bincount(told, weights=gains[~added], minlength=parts)
        columns.append(["gain", *(f"{gain:.4g}" for gain in each)])
    lines += _table(columns)
    if measure is not None and len(run):
        lines.append(f"gain of {measure!r}: {gains.sum():.4g} in all")
    reasons = Counter(failure.reason for failure in run.failures).most_common(_REASONS)
    lines += [f"failed {count} x: {reason}" for reason, count in reasons]
    return "\n".join(lines)


def _labels(run: Exploration, parts: int, names: Sequence[str] | None) -> list[str]:
    """Return what to call each strategy; those of one class are numbered."""
    if names is not None:
        if isinstance(names, str) or len(names) != parts:
            raise ValueError(f"names must be {parts} words, one for each strategy, got {names!r}")
        return [str(name) for name in names]
    known = run.names or tuple(f"strategy {index}" for index in range(parts))
    return [
        name if known.count(name) == 1 else f"{name} {index}" for index, name in enumerate(known)
    ]


def _table(columns: list[list[str]]) -> list[str]:
    """Return the rows of columns, the first of which is words."""
    widths = [max(map(len, column)) for column in columns]
    rows = zip(*columns, strict=True)
    return [
        "  ".join(
            word.ljust(width) if place == 0 else word.rjust(width)
            for place, (word, width) in enumerate(zip(row, widths, strict=True))
        ).rstrip()
        for row in rows
    ]
