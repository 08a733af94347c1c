"""Figure 1: random motor babbling reaches a small part of what the arm can reach."""

from __future__ import annotations

from typing import TYPE_CHECKING

from divbandit.exploration import Exploration, explore
from divbandit.paper import setting
from divbandit.plot import postures, spread, style
from divbandit.strategies import MotorBabbling

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure


def run(seed: int, *, n: int = 5000) -> Exploration:
    """Explore the arm by motor babbling."""
    return explore(setting.arm(), MotorBabbling(), n, rng=setting.seed_of(seed, 1))


def draw(exploration: Exploration) -> Figure:
    """Draw the effects and the last five postures."""
    import matplotlib.pyplot as plt  # noqa: PLC0415

    figure, ax = plt.subplots(figsize=(style.COLUMN, style.COLUMN))
    panel(ax, exploration)
    ax.set_title("motor babbling")
    ax.legend(*ax.get_legend_handles_labels(), frameon=False, loc="lower left")
    return figure


def panel(ax: Axes, exploration: Exploration) -> None:
    """Draw the effects and the last five postures of one exploration."""
    arm = setting.arm()
    spread(exploration, unit="m", ax=ax)
    postures([arm.posture(command) for command in exploration.commands[-5:]], unit="m", ax=ax)
    frame(ax)


def frame(ax: Axes) -> None:
    """Show all that an arm of 1 m could reach."""
    halves = (-1, -0.5, 0, 0.5, 1)
    ax.set(xlim=(-1.05, 1.05), ylim=(-1.05, 1.05), xticks=halves, yticks=halves)
