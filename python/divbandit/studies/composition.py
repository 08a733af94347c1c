"""composition: the library's own composition beside the paper's, and with one part less."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

from divbandit.bandits import Adapt, default_strategies, default_strategy, discounted_adapt
from divbandit.benchmarks import LinearProjection
from divbandit.environments import PlanarArm
from divbandit.goals import UncoveredGoals, UniformGoals, UntriedGoals
from divbandit.plot import ranking, style
from divbandit.strategies import GoalBabbling, MotorBabbling
from divbandit.studies.cases import Case, explored
from divbandit.studies.worlds import corridor

if TYPE_CHECKING:
    from collections.abc import Sequence

    from matplotlib.figure import Figure

    from divbandit.environments import Environment
    from divbandit.goals import GoalSampler
    from divbandit.strategies import Strategy
    from divbandit.studies.cases import Outcome

    #: The place and the composition.
    Key = tuple[str, str]

#: Of the table of all numbers: what a key holds, and what is measured.
COLUMNS = ("place", "name", "repetition", "coverage")

_ADAPT, _OWN = "ADAPT", "recommended"


@dataclass(frozen=True)
class _Place:
    """What is explored."""

    name: str
    environment: Environment
    tau: float
    unit: str


#: Where parts differ: a smooth map, a sum of many coordinates, and one with steps.
_PLACES = (
    _Place("arm of 20 joints", PlanarArm(20), 0.02, "m²"),
    _Place("linear projection, 20", LinearProjection(20), 0.512, ""),
    _Place("corridor", PlanarArm(20, obstacles=corridor()), 0.02, "m²"),
)


def compositions(tau: float) -> dict[str, Strategy]:
    """Return the compositions by name: the paper's first, then the library's own.

    Examples
    --------
    >>> list(compositions(0.02))[:2]
    ['ADAPT', 'recommended']
    """
    parts = default_strategies(tau)
    names = ("motor babbling", "long steps", "short steps", "line variation", "crossover")
    fewer = {
        f"no {name}": _bandit([*parts[:place], *parts[place + 1 :]], tau)
        for place, name in enumerate(names)
    }
    return {
        _ADAPT: Adapt([MotorBabbling(), GoalBabbling(0.05)], tau=tau),
        _OWN: default_strategy(tau),
        **fewer,
        "single candidates": _bandit(_with(UntriedGoals(tau, candidates=1), parts), tau),
        "uncovered goals": _bandit(_with(UncoveredGoals(tau), parts), tau),
        "uniform goals": _bandit(_with(UniformGoals(), parts), tau),
        "ADAPT's window, alpha, power": Adapt(parts, tau=tau),
    }


def _with(goals: GoalSampler, parts: Sequence[Strategy]) -> list[Strategy]:
    """Return the default's strategies with other goals."""
    return [
        GoalBabbling(goals=goals, inverse=part.model) if isinstance(part, GoalBabbling) else part
        for part in parts
    ]


def _bandit(strategies: Sequence[Strategy], tau: float) -> Strategy:
    return discounted_adapt(strategies, gamma=0.995, power=16.0, tau=tau)


def cases(steps: int) -> dict[Key, Case]:
    """Return each composition in each place."""
    found = {}
    for i, place in enumerate(_PLACES):
        for j, (name, strategy) in enumerate(compositions(place.tau).items()):
            found[place.name, name] = Case(
                strategy, (steps,), (7, i, j), explored, place.environment, place.tau
            )
    return found


def draw(found: dict[Key, Outcome]) -> dict[str, Figure]:
    """Draw a panel for each place, and in it a row for each composition."""
    import matplotlib.pyplot as plt  # noqa: PLC0415

    figure, axes = plt.subplots(1, 3, figsize=(style.PAGE, 2.5), sharey=True)
    for letter, ax, place in zip("abc", axes, _PLACES, strict=True):
        there = {name: each for (where, name), each in found.items() if where == place.name}
        ranking(
            [outcome.summary[-1] for outcome in there.values()],
            labels=list(there),
            marks={"the paper's ADAPT": there[_ADAPT].mean},
            highlight=1,
            unit=place.unit,
            ax=ax,
        )
        ax.set_title(f"({letter}) {place.name}")
    style.legend_below(figure, axes[:1])
    return {"composition": figure}


def table(found: dict[Key, Outcome]) -> str:
    """Return mean, deviation, least and the share of the default's of what was reached, as text."""
    lines = []
    for place in _PLACES:
        there = {name: each for (where, name), each in found.items() if where == place.name}
        steps = there[_OWN].case.at[-1]
        lines.append(f"{place.name}, {steps} steps{', ' + place.unit if place.unit else ''}")
        for name, outcome in there.items():
            least, share = outcome.values.min(), outcome.mean / there[_OWN].mean - 1
            numbers = f"{outcome.mean:9.4g} ± {outcome.deviation:<8.2g} least {least:<9.4g}"
            lines.append(f"  {name:30}{numbers}{share:+8.1%}")
    return "\n".join(lines)
