"""environments: ADAPT, its parts alone and their mixtures, in five black boxes."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from divbandit.bandits import Adapt, default_strategy
from divbandit.environments import PlanarArm
from divbandit.plot import ranking, scene, spread, style
from divbandit.strategies import GoalBabbling, Mixture, MotorBabbling
from divbandit.studies.cases import Case, explored
from divbandit.studies.worlds import worlds

if TYPE_CHECKING:
    from matplotlib.figure import Figure

    from divbandit.strategies import Strategy
    from divbandit.studies.cases import Outcome
    from divbandit.studies.worlds import World

    #: The world, the strategy, and how many steps it takes there.
    Key = tuple[str, str, int]

#: Of the table of all numbers: what a key holds, and what is measured.
COLUMNS = ("world", "name", "steps", "repetition", "coverage")

#: Perturbation of the inverse model.
_D = 0.05
#: Shares of motor babbling in the mixtures.
_RATIOS = (0.1, 0.25, 0.5, 0.75, 0.9)
_ADAPT, _MOTOR, _GOAL, _OWN = "ADAPT", "motor babbling", "goal babbling", "recommended"


def contenders(tau: float) -> dict[str, Strategy]:
    """Return the strategies by name, of effects that cover discs of radius `tau`.

    Examples
    --------
    >>> list(contenders(0.02))[:4]
    ['ADAPT', 'motor babbling', 'goal babbling', 'recommended']
    """
    parts = [MotorBabbling(), GoalBabbling(_D)]
    mixtures = {
        f"{ratio:.0%} motor babbling": Mixture(parts, weights=[ratio, 1 - ratio])
        for ratio in _RATIOS
    }
    own = default_strategy(tau)
    return {_ADAPT: Adapt(parts, tau=tau), _MOTOR: parts[0], _GOAL: parts[1], _OWN: own, **mixtures}


def cases(steps: int) -> dict[Key, Case]:
    """Return each strategy in each world."""
    found = {}
    for i, world in enumerate(worlds()):
        count = max(1, steps // world.costs)
        for j, (name, strategy) in enumerate(contenders(world.tau).items()):
            found[world.name, name, count] = Case(
                strategy, (count,), (8, i, j), explored, world.environment, world.tau
            )
    return found


def of_world(found: dict[Key, Outcome], world: str) -> dict[str, Outcome]:
    """Return the outcomes in one world by the strategy's name."""
    return {name: outcome for (where, name, _), outcome in found.items() if where == world}


def best_mixture(found: dict[str, Outcome]) -> float:
    """Return the mean of the best of all mixtures of a world, its parts alone among them."""
    return max(each.mean for name, each in found.items() if name not in (_ADAPT, _OWN))


def draw(found: dict[Key, Outcome]) -> dict[str, Figure]:
    """Draw a figure for each world: what motor babbling and ADAPT reach, and all in a row."""
    return {
        f"environments_{world.name.lower().replace(' ', '_')}": _figure(
            world, of_world(found, world.name)
        )
        for world in worlds()
    }


def _figure(world: World, found: dict[str, Outcome]) -> Figure:
    import matplotlib.pyplot as plt  # noqa: PLC0415

    size = (style.PAGE, 2.35)
    figure, axes = plt.subplots(1, 3, figsize=size, width_ratios=[1, 1, 1.1])
    for letter, ax, name in zip("ab", axes, (_MOTOR, _ADAPT), strict=False):
        effects = found[name].example
        spread(effects, tau=world.tau, unit="m", ax=ax)
        if isinstance(world.environment, PlanarArm):
            scene(world.environment, unit="m", ax=ax)
        space = world.environment.sensory_space
        if space is not None:
            low, high = np.asarray(space.low), np.asarray(space.high)
            ax.set(xlim=(low[0], high[0]), ylim=(low[1], high[1]))
        ax.set_title(f"({letter}) {name}, {len(effects)} steps")
    ranking(
        [outcome.summary[-1] for outcome in found.values()],
        labels=list(found),
        marks={"best mixture": best_mixture(found)},
        highlight=list(found).index(_ADAPT),
        unit="m²",
        ax=axes[2],
    )
    axes[2].set_title(f"(c) {world.name}")
    style.legend_below(figure, axes[1:])  # both scenes show the same things
    return figure


def table(found: dict[Key, Outcome]) -> str:
    """Return what was reached as text: means, deviations, and shares of the best mixture's."""
    lines = []
    for world in worlds():
        there = of_world(found, world.name)
        lines.append(f"{world.name}, {there[_ADAPT].case.at[-1]} steps, m²")
        best = best_mixture(there)
        for name, outcome in there.items():
            numbers = f"{outcome.mean:8.4f} ± {outcome.deviation:.4f}"
            lines.append(f"  {name:22}{numbers}{outcome.mean / best - 1:+8.1%}")
    return "\n".join(lines)
