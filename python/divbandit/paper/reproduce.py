"""reproduce: the paper's four figures and the comparison with its archived results, as files."""

from __future__ import annotations

import os
from collections.abc import Iterable
from contextlib import nullcontext
from pathlib import Path
from typing import TYPE_CHECKING

from divbandit._checks import whole
from divbandit.paper import comparison, figure1, figure2, figure3, figure4, setting
from divbandit.plot import style

if TYPE_CHECKING:
    from collections.abc import Callable
    from contextlib import AbstractContextManager

    from divbandit.experiments.explore_many import Progress

    #: Opens a bar of a name and a number of steps, to be advanced by calls.
    Bar = Callable[[str, int], AbstractContextManager[Progress]]

FIGURES = (1, 2, 3, 4)


def reproduce(
    figures: Iterable[int] = FIGURES,
    *,
    out: str | os.PathLike[str] = "figures",
    repetitions: int = 25,
    seed: int = 0,
    jobs: int | None = None,
    bar: Bar | None = None,
) -> list[comparison.Comparison]:
    """Make the paper's figures, full size: PNG and SVG files in a folder.

    Figure 4 also leaves ``figure4.csv``, its 66 points, and ``figure4_comparison.csv``, each
    beside the archived one.

    Parameters
    ----------
    figures : iterable of int
        Which of 1 to 4.
    out : str or path
        The folder; made if it is not there.
    repetitions : int
        Explorations behind each point of figure 4 and each mean of figure 3; at least 1.
    seed : int
        All randomness comes from it.
    jobs : int, optional
        How many threads; by default one for each core. The files do not depend on it.
    bar : callable, optional
        Opens a progress bar, given a name and a number of steps.

    Returns
    -------
    list of Comparison
        The comparison of figure 4; empty if it was not requested.

    Raises
    ------
    TypeError, ValueError
        If an argument is not what it must be.

    Examples
    --------
    >>> import tempfile
    >>> from divbandit.paper import reproduce
    >>> with tempfile.TemporaryDirectory() as folder:
    ...     reproduce([1], out=folder)
    []
    """
    if not isinstance(figures, Iterable):
        raise TypeError(f"figures must be numbers of figures, got {type(figures).__name__}")
    wanted = sorted({whole("figures", figure, low=1, high=len(FIGURES)) for figure in figures})
    folder = folder_for(out, repetitions=repetitions, seed=seed, jobs=jobs)
    bar = bar or no_bar
    compared: list[comparison.Comparison] = []
    count = len(setting.PERTURBATIONS)
    with style.printed():
        if 1 in wanted:
            with bar("figure 1", 1) as progress:
                style.save(figure1.draw(figure1.run(seed)), folder / "figure1")
                progress()
        if 2 in wanted:
            with bar("figure 2", count) as progress:
                runs = figure2.run(seed, jobs=jobs, progress=progress)
                style.save(figure2.draw(runs), folder / "figure2")
        if 3 in wanted:
            with bar("figure 3", count * repetitions) as progress:
                rows = figure3.run(seed, repetitions=repetitions, jobs=jobs, progress=progress)
                style.save(figure3.draw(rows), folder / "figure3")
        if 4 in wanted:
            with bar("figure 4", figure4.explorations(repetitions)) as progress:
                points = figure4.run(seed, repetitions=repetitions, jobs=jobs, progress=progress)
            style.save(figure4.draw(points), folder / "figure4")
            figure4.save(points, folder / "figure4.csv")
            compared = comparison.compare(points, repetitions)
            comparison.save(compared, folder / "figure4_comparison.csv")
    return compared


def folder_for(
    out: str | os.PathLike[str], *, repetitions: int, seed: int, jobs: int | None
) -> Path:
    """Return the folder for files, made if it is not there, once all arguments are checked."""
    if not isinstance(out, (str, os.PathLike)):
        raise TypeError(f"out must be a path, got {type(out).__name__}")
    whole("repetitions", repetitions, low=1)
    whole("seed", seed, low=0)
    if jobs is not None:
        whole("jobs", jobs, low=1)
    folder = Path(out)
    folder.mkdir(parents=True, exist_ok=True)
    return folder


def no_bar(_name: str, _total: int) -> AbstractContextManager[Progress]:
    """Open no progress bar."""
    return nullcontext(lambda: None)
