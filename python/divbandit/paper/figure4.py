"""Figure 4: the diversity that each fixed mixture reaches, and ADAPT beside them."""

from __future__ import annotations

import csv
from dataclasses import dataclass
from importlib import resources
from itertools import product
from typing import TYPE_CHECKING

import numpy as np

from divbandit._files import write_csv
from divbandit.experiments import Task, explore_many
from divbandit.measures import coverage
from divbandit.paper import setting
from divbandit.plot import mixtures, style

if TYPE_CHECKING:
    from collections.abc import Iterable, Sequence
    from pathlib import Path

    from matplotlib.figure import Figure

    from divbandit.experiments.explore_many import Progress
    from divbandit.exploration import Exploration
    from divbandit.strategies import Strategy


@dataclass(frozen=True)
class Point:
    """A strategy's final diversity: mean and population standard deviation, in square metres."""

    d: float
    motor_ratio: float | None  #: of the mixture; None for ADAPT
    mean: float
    std: float

    @property
    def key(self) -> tuple[float, float | None]:
        """What tells the points apart."""
        return self.d, self.motor_ratio

    @property
    def strategy(self) -> str:
        """What kind of strategy it is."""
        return "adapt" if self.motor_ratio is None else "mixture"


_STRATEGIES: tuple[float | None, ...] = (None, *setting.RATIOS)


def run(
    seed: int,
    *,
    n: int = 10000,
    repetitions: int = 25,
    jobs: int | None = None,
    progress: Progress | None = None,
) -> list[Point]:
    """Explore the arm with ADAPT and with each of the 21 mixtures, for each d."""
    tasks = (
        Task(setting.arm(), _strategy(d, ratio), n, rng=setting.seed_of(seed, 4, i, j, repetition))
        for i, d in enumerate(setting.PERTURBATIONS)
        for j, ratio in enumerate(_STRATEGIES)
        for repetition in range(repetitions)
    )
    final = np.empty(explorations(repetitions))
    for place, reached in explore_many(tasks, keep=_diversity, jobs=jobs, progress=progress):
        final[place] = reached
    keys = product(setting.PERTURBATIONS, _STRATEGIES)
    return [
        Point(*key, float(of_point.mean()), float(of_point.std()))
        for key, of_point in zip(keys, final.reshape(-1, repetitions), strict=True)
    ]


def explorations(repetitions: int) -> int:
    """Return how many explorations `run` makes."""
    return len(setting.PERTURBATIONS) * len(_STRATEGIES) * repetitions


def _strategy(d: float, ratio: float | None) -> Strategy:
    return setting.adapt(d) if ratio is None else setting.mixture(d, ratio)


def _diversity(exploration: Exploration) -> float:
    return coverage(exploration.effects, setting.TAU)


def draw(points: Sequence[Point]) -> Figure:
    """Draw, for each d, the mixtures against their ratio and ADAPT as a dotted line."""
    import matplotlib.pyplot as plt  # noqa: PLC0415

    archived = archive()
    figure, row = plt.subplots(1, 3, figsize=(style.PAGE, 2.5))
    for letter, ax, d in zip("abc", row, setting.PERTURBATIONS, strict=True):
        of_d = [point for point in points if point.d == d]
        adapt = next(point for point in of_d if point.motor_ratio is None)
        mixtures(
            [(p.motor_ratio, p.mean, p.std) for p in of_d if p.motor_ratio is not None],
            adapt=(adapt.mean, adapt.std),
            archive=[
                (p.motor_ratio, p.mean) for p in archived if p.d == d and p.motor_ratio is not None
            ],
            unit="m²",
            ax=ax,
        )
        before = next(p.mean for p in archived if p.key == (d, None))
        ax.axhline(before, color="black", linestyle="--", linewidth=0.5, label="archived ADAPT")
        ax.set_title(f"({letter}) d = {d}")
    for ax in row[1:]:
        ax.set_ylabel("")
    row[0].legend(frameon=False, loc="lower right")
    return figure


def archive() -> list[Point]:
    """Return the paper's archived results (25 repetitions, discs drawn as 64-gons)."""
    file = resources.files("divbandit.paper") / "archived_figure4.csv"
    return [
        Point(
            float(row["d"]),
            float(row["motor_ratio"]) if row["motor_ratio"] else None,
            float(row["mean"]),
            float(row["std"]),
        )
        for row in csv.DictReader(file.read_text(encoding="utf-8").splitlines())
    ]


def save(points: Iterable[Point], path: Path) -> None:
    """Write points as CSV: d, strategy, motor_ratio, mean, std."""
    columns = ("d", "strategy", "motor_ratio", "mean", "std")
    write_csv(
        path, columns, ([p.d, p.strategy, p.motor_ratio, repr(p.mean), repr(p.std)] for p in points)
    )
