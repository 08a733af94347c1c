"""composition: the library's own composition beside the paper's, and with one part changed."""

from __future__ import annotations

from typing import TYPE_CHECKING

from divbandit.bandits import Adapt, default_strategy
from divbandit.goals import UncoveredGoals, UntriedGoals
from divbandit.inverse import LocalJacobian, Nearest
from divbandit.paper import setting
from divbandit.plot import ranking, style
from divbandit.strategies import GoalBabbling, MotorBabbling
from divbandit.studies.cases import Case

if TYPE_CHECKING:
    from matplotlib.figure import Figure

    from divbandit.goals import GoalSampler
    from divbandit.inverse import InverseModel
    from divbandit.strategies import Strategy
    from divbandit.studies.cases import Outcome

    Key = tuple[str]

#: Of the table of all numbers: what a key holds, and what is measured.
COLUMNS = ("name", "repetition", "step", "coverage")

#: Perturbation where the inverse model is the paper's.
_D = 0.05


def compositions() -> dict[str, Strategy]:
    """Return the compositions by name: the paper's first, then the library's own.

    Examples
    --------
    >>> list(compositions())[:2]
    ['ADAPT', 'recommended']
    """
    tau = setting.TAU
    goals, model = UntriedGoals(tau), LocalJacobian()
    four = UntriedGoals(tau, candidates=4)
    return {
        "ADAPT": setting.adapt(_D),
        "recommended": default_strategy(tau),
        "4 candidates": _bandit(four, model),
        "no counts of tries": _bandit(UncoveredGoals(tau), model),
        "goals anywhere": _bandit(None, model),
        "nearest neighbour": _bandit(goals, Nearest(_D)),
        "no motor babbling": GoalBabbling(goals=goals, inverse=model),
        "ADAPT's window, alpha, power": Adapt(
            [MotorBabbling(), GoalBabbling(goals=goals, inverse=model)], tau=tau
        ),
        "ADAPT's goals and inverse": _bandit(None, Nearest(_D)),
    }


def _bandit(goals: GoalSampler | None, model: InverseModel) -> Strategy:
    babblings = [MotorBabbling(), GoalBabbling(goals=goals, inverse=model)]
    return Adapt(babblings, tau=setting.TAU, window=200, alpha=0.05, power=8.0)


def cases(steps: int) -> dict[Key, Case]:
    """Return each composition, to be measured after a fifth of the steps, half and all."""
    at = (steps // 5, steps // 2, steps)
    named = compositions().items()
    return {(name,): Case(strategy, at, (7, i)) for i, (name, strategy) in enumerate(named)}


def draw(found: dict[Key, Outcome]) -> dict[str, Figure]:
    """Draw a panel for each number of steps, and in it a row for each composition."""
    import matplotlib.pyplot as plt  # noqa: PLC0415

    figure, axes = plt.subplots(1, 3, figsize=(style.PAGE, 2.3), sharey=True)
    paper = found["ADAPT",]
    for letter, ax, place in zip("abc", axes, range(3), strict=True):
        ranking(
            [outcome.summary[place] for outcome in found.values()],
            labels=[name for (name,) in found],
            marks={"the paper's ADAPT": float(paper.summary[place, 0])},
            highlight=1,
            unit="m²",
            ax=ax,
        )
        ax.set_title(f"({letter}) {paper.case.at[place]} steps")
    style.legend_below(figure, axes[:1])
    return {"composition": figure}


def table(found: dict[Key, Outcome]) -> str:
    """Return mean, standard deviation and least of what was reached, as text."""
    heads = "".join(f"{f'n = {n}':>24}" for n in found["ADAPT",].case.at)
    lines = [f"{'m² (mean ± s.d., least)':30}{heads}"]
    for (name,), outcome in found.items():
        numbers = zip(outcome.summary, outcome.values.min(axis=0), strict=True)
        cells = [f"{f'{mean:.3f} ± {s:.3f}, {least:.3f}':>24}" for (mean, s), least in numbers]
        lines.append(f"{name:30}" + "".join(cells))
    return "\n".join(lines)
