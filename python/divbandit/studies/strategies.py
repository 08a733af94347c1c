"""strategies: the bandits over 2 to 64 strategies, good and bad ones mixed."""

from __future__ import annotations

from typing import TYPE_CHECKING

from divbandit._core import power
from divbandit.plot import series, style
from divbandit.strategies import GoalBabbling, Mixture, MotorBabbling, Strategy
from divbandit.studies.cases import Case
from divbandit.studies.contenders import RIVALS
from divbandit.studies.repeating import Repeating

if TYPE_CHECKING:
    from matplotlib.figure import Figure

    from divbandit.studies.cases import Outcome

    #: The mix, how many strategies, and which bandit is over them.
    Key = tuple[str, int, str]

#: Of the table of all numbers: what a key holds, and what is measured.
COLUMNS = ("mix", "strategies", "name", "repetition", "coverage")

#: How many strategies.
SIZES = (2, 4, 8, 16, 32, 64)
#: The mixes, and what their panels are called.
MIXES = {"half": "half of them good", "one": "one of them good"}
#: The good perturbations: goal babbling alone with any of them covers more than 2 m² in 10000
#: steps, twice what motor babbling does; with a third of the least or three times the largest less.
GOOD = (0.02, 0.16)

_ALONE = "good ones alone"


def good(count: int) -> list[Strategy]:
    """Return goal babbling with `count` perturbations, spread geometrically over `GOOD`.

    A single one has their geometric mean.

    Examples
    --------
    >>> [round(each.d, 4) for each in good(4)]
    [0.02, 0.04, 0.08, 0.16]
    """
    low, high = GOOD
    shares = [0.5] if count == 1 else [index / (count - 1) for index in range(count)]
    return [GoalBabbling(low * power(high / low, share)) for share in shares]


def bad(count: int) -> list[Strategy]:
    """Return `count` strategies that cover 1 m² or less alone: four kinds of them in turn.

    Examples
    --------
    >>> [type(each).__name__ for each in bad(3)]
    ['MotorBabbling', 'GoalBabbling', 'Repeating']
    """
    kinds = (MotorBabbling, lambda: GoalBabbling(0.0001), Repeating, lambda: GoalBabbling(1.0))
    return [kinds[index % len(kinds)]() for index in range(count)]


def mixed(mix: str, size: int) -> tuple[list[Strategy], list[Strategy]]:
    """Return the good and the bad strategies of a mix.

    Examples
    --------
    >>> [len(each) for each in mixed("half", 8)], [len(each) for each in mixed("one", 8)]
    ([4, 4], [1, 7])
    """
    count = size // 2 if mix == "half" else 1
    return good(count), bad(size - count)


def cases(steps: int) -> dict[Key, Case]:
    """Return each rival over each number of strategies of each mix.

    And the good strategies alone, each as likely at each step.
    """
    found = {}
    for i, mix in enumerate(MIXES):
        for j, size in enumerate(SIZES):
            good_ones, bad_ones = mixed(mix, size)
            for k, rival in enumerate(RIVALS):
                bandit = rival.over(good_ones + bad_ones)
                found[mix, size, rival.name] = Case(bandit, (steps,), (6, i, j, 1 + k))
            found[mix, size, _ALONE] = Case(Mixture(good_ones), (steps,), (6, i, j, 0))
    return found


def draw(found: dict[Key, Outcome]) -> dict[str, Figure]:
    """Draw a panel for each mix and in it a line for each rival."""
    import matplotlib.pyplot as plt  # noqa: PLC0415

    figure, axes = plt.subplots(1, 2, figsize=(style.PAGE, 2.8), sharey=True)
    names = [rival.name for rival in RIVALS]
    for letter, ax, (mix, title) in zip("ab", axes, MIXES.items(), strict=True):
        series(
            SIZES,
            [[found[mix, size, name].summary[-1] for size in SIZES] for name in names],
            labels=names,
            baseline=[found[mix, size, _ALONE].mean for size in SIZES],
            baseline_label=_ALONE,
            unit="m²",
            ax=ax,
        )
        ax.set(title=f"({letter}) {title}", xlabel="number of strategies")
        ax.label_outer()
    handles, labels = axes[0].get_legend_handles_labels()
    figure.legend(handles, labels, frameon=False, loc="outside right center")
    return {"strategies": figure}


def table(found: dict[Key, Outcome]) -> str:
    """Return what was reached as text."""
    lines = []
    for mix, title in MIXES.items():
        lines.append(f"{f'm², {title}, of':26}" + "".join(f"{size:>14}" for size in SIZES))
        for name in [*(rival.name for rival in RIVALS), _ALONE]:
            of_name = [found[mix, size, name] for size in SIZES]
            cells = [f"{f'{each.mean:.2f} ± {each.deviation:.2f}':>14}" for each in of_name]
            lines.append(f"{name:26}" + "".join(cells))
    return "\n".join(lines)
