"""study: one of the studies, as files."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from divbandit._checks import one_of, whole
from divbandit._files import write_csv
from divbandit.paper.reproduce import folder_for, no_bar
from divbandit.plot import style
from divbandit.studies import composition, environments, rules, strategies
from divbandit.studies.cases import outcomes

if TYPE_CHECKING:
    import os
    from collections.abc import Iterator

    from divbandit.paper.reproduce import Bar
    from divbandit.studies.cases import Outcome

_STUDIES = {
    "rules": rules,
    "strategies": strategies,
    "composition": composition,
    "environments": environments,
}

#: Their names.
STUDIES = tuple(_STUDIES)


def study(
    name: str,
    *,
    out: str | os.PathLike[str] = "studies",
    repetitions: int = 25,
    steps: int = 10000,
    seed: int = 0,
    jobs: int | None = None,
    bar: Bar | None = None,
) -> str:
    """Make a study: its figures, PNG and SVG, and a CSV of all its numbers in a folder.

    ``"rules"`` has every bandit of the library in the three settings of the paper's figure 4,
    ``"strategies"`` takes some of them to 2 to 64 strategies, ``"composition"`` compares the
    library's own composition with the paper's and with itself less one part. ``"environments"``
    has ADAPT, its parts and their mixtures in five black boxes, one of them MuJoCo's Pusher, which
    needs ``pip install 'divbandit[mujoco]'``.

    Parameters
    ----------
    name : {"rules", "strategies", "composition", "environments"}
    out : str or path
        The folder; made if it is not there.
    repetitions : int
        Explorations behind each mean; at least 1.
    steps : int
        Of each exploration; at least 5.
    seed : int
        All randomness comes from it.
    jobs : int, optional
        How many processes; by default one for each core. The files do not depend on it. With more
        than one, a script that calls this must be guarded by ``if __name__ == "__main__":``.
    bar : callable, optional
        Opens a progress bar, given a name and a number of steps.

    Returns
    -------
    str
        A table of the means.

    Raises
    ------
    TypeError, ValueError
        If an argument is not what it must be; nothing is written then.

    Examples
    --------
    >>> import tempfile
    >>> from divbandit.studies import study
    >>> with tempfile.TemporaryDirectory() as folder:
    ...     print(study("rules", out=folder, repetitions=1, steps=5, jobs=1)[:14])
    coverage in m²
    """
    made = _STUDIES[one_of("name", name, STUDIES)]
    cases = made.cases(whole("steps", steps, low=5))
    folder = folder_for(out, repetitions=repetitions, seed=seed, jobs=jobs)
    with (bar or no_bar)(name, len(cases) * repetitions) as progress:
        found = outcomes(cases, seed=seed, repetitions=repetitions, jobs=jobs, progress=progress)
    with style.printed():
        for stem, figure in made.draw(found).items():
            style.save(figure, folder / stem)
    write_csv(folder / f"{name}.csv", made.COLUMNS, _rows(found))
    table: str = made.table(found)
    return table


def _rows(found: dict[tuple[Any, ...], Outcome]) -> Iterator[list[Any]]:
    """Yield what every single exploration reached, after each step at which it was measured."""
    for key, outcome in found.items():
        steps = outcome.case.at
        for repetition, values in enumerate(outcome.values.tolist()):
            for step, value in zip(steps, values, strict=True):
                yield [*key, repetition, *([step] if len(steps) > 1 else []), repr(value)]
