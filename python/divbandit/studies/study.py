"""study: one of the studies, as files."""

from __future__ import annotations

import os
from contextlib import nullcontext
from pathlib import Path
from typing import TYPE_CHECKING

from divbandit._checks import one_of, whole
from divbandit.plot import style
from divbandit.studies import composition, environments, rules, strategies

if TYPE_CHECKING:
    from contextlib import AbstractContextManager

    from divbandit.experiments.explore_many import Progress
    from divbandit.paper.reproduce import Bar

_STUDIES = {each.NAME: each for each in (rules, strategies, composition, environments)}

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
    if not isinstance(out, (str, os.PathLike)):
        raise TypeError(f"out must be a path, got {type(out).__name__}")
    whole("repetitions", repetitions, low=1)
    whole("steps", steps, low=5)
    whole("seed", seed, low=0)
    if jobs is not None:
        whole("jobs", jobs, low=1)
    folder = Path(out)
    folder.mkdir(parents=True, exist_ok=True)
    with (bar or _no_bar)(name, made.explorations(repetitions)) as progress:
        rows = made.run(seed, steps=steps, repetitions=repetitions, jobs=jobs, progress=progress)
    with style.printed():
        for stem, figure in made.draw(rows).items():
            style.save(figure, folder / stem)
    made.save(rows, folder / f"{name}.csv")
    table: str = made.table(rows)
    return table


def _no_bar(_name: str, _total: int) -> AbstractContextManager[Progress]:
    return nullcontext(lambda: None)
