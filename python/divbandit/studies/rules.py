"""rules: every bandit in figure 4's three settings, beside the best of the fixed mixtures."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

from divbandit.paper import setting
from divbandit.plot import ranking, style
from divbandit.strategies import GoalBabbling, MotorBabbling
from divbandit.studies.cases import Case
from divbandit.studies.contenders import CONTENDERS, GREEDY
from divbandit.studies.hindsight import hindsight

if TYPE_CHECKING:
    from matplotlib.figure import Figure

    from divbandit.studies.cases import Outcome

    #: The setting, which bandit, and what it is made of.
    Key = tuple[float, str, str]

#: Of the table of all numbers: what a key holds, and what is measured.
COLUMNS = ("d", "name", "parts", "repetition", "coverage")

#: How far below the best mixture a good bandit may stay.
ALLOWED = 0.015

_MIXTURE, _HINDSIGHT, _BOTH = "mixture", "hindsight", "both are tried, the better one is kept"


@dataclass(frozen=True)
class Panel:
    """One setting: what was reached, and what it is measured by."""

    d: float
    bandits: list[Outcome]  #: in the order of CONTENDERS
    ratio: float  #: the share of motor babbling in the best of the fixed mixtures
    best: Outcome  #: what that mixture reached
    hindsight: Outcome

    def relative(self, outcome: Outcome) -> float:
        """Return how far a mean is above the best mixture's, as a share of it."""
        return outcome.mean / self.best.mean - 1


def cases(steps: int) -> dict[Key, Case]:
    """Return each bandit, each of the 21 mixtures and hindsight, for each d.

    The mixtures have the seeds that they have in the paper's figure 4.
    """
    found = {}
    for i, d in enumerate(setting.PERTURBATIONS):
        strategies = [MotorBabbling(), GoalBabbling(d)]
        for j, each in enumerate(CONTENDERS):
            found[d, each.name, each.parts] = Case(each.over(strategies), (steps,), (5, i, j))
        for j, ratio in enumerate(setting.RATIOS):
            mixture = setting.mixture(d, ratio)
            found[d, _MIXTURE, repr(ratio)] = Case(mixture, (steps,), (4, i, 1 + j))
        place = (5, i, len(CONTENDERS))
        found[d, _HINDSIGHT, _BOTH] = Case(strategies, (steps,), place, method=hindsight)
    return found


def panels(found: dict[Key, Outcome]) -> list[Panel]:
    """Sort outcomes by setting, and find the best mixture of each."""
    sorted_ones = []
    for d in setting.PERTURBATIONS:
        bandits = [found[d, each.name, each.parts] for each in CONTENDERS]
        mixtures = {ratio: found[d, _MIXTURE, repr(ratio)] for ratio in setting.RATIOS}
        ratio, best = max(mixtures.items(), key=lambda item: item[1].mean)
        sorted_ones.append(Panel(d, bandits, ratio, best, found[d, _HINDSIGHT, _BOTH]))
    return sorted_ones


def draw(found: dict[Key, Outcome]) -> dict[str, Figure]:
    """Draw a panel for each d and in it a row for each bandit."""
    import matplotlib.pyplot as plt  # noqa: PLC0415

    figure, axes = plt.subplots(1, 3, figsize=(style.PAGE, 3.1), sharey=True)
    for letter, ax, panel in zip("abc", axes, panels(found), strict=True):
        ranking(
            [outcome.summary[-1] for outcome in panel.bandits],
            labels=[each.name for each in CONTENDERS],
            marks={
                "best fixed mixture": panel.best.mean,
                "1.5 % below it": (1 - ALLOWED) * panel.best.mean,
                "greedy in hindsight": panel.hindsight.mean,
            },
            highlight=CONTENDERS.index(GREEDY),
            unit="m²",
            ax=ax,
        )
        ax.set_title(f"({letter}) d = {panel.d}")
    style.legend_below(figure, axes[:1])
    return {"rules": figure}


def table(found: dict[Key, Outcome]) -> str:
    """Return what was reached as text: means, deviations, and shares of the best mixture's."""
    every = panels(found)

    def numbers(outcomes: list[Outcome]) -> str:
        return "".join(
            f"{f'{each.mean:.3f} ± {each.deviation:.3f}':>16}{panel.relative(each):+8.1%}"
            for panel, each in zip(every, outcomes, strict=True)
        )

    head = "".join(f"{f'd = {panel.d}':>24}" for panel in every)
    lines = [f"{'coverage in m²':22}{head}{'worst':>8}  estimator, policy"]
    for index, contender in enumerate(CONTENDERS):
        outcomes = [panel.bandits[index] for panel in every]
        worst = min(map(Panel.relative, every, outcomes))
        lines.append(f"{contender.name:22}{numbers(outcomes)}{worst:+8.1%}  {contender.parts}")
    ratios = ", ".join(repr(panel.ratio) for panel in every)
    mixtures = numbers([panel.best for panel in every])
    lines.append(f"{'best fixed mixture':22}{mixtures}{'':8}  motor babbling {ratios}")
    kept = numbers([panel.hindsight for panel in every])
    lines.append(f"{'greedy in hindsight':22}{kept}{'':8}  {_BOTH}")
    return "\n".join(lines)
