"""The command line: ``divbandit reproduce``, ``divbandit study NAME``, ``divbandit benchmark``."""

from __future__ import annotations

import argparse
import sys
from contextlib import contextmanager
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from collections.abc import Callable, Iterator, Sequence

    from divbandit.experiments.explore_many import Progress


def main(arguments: Sequence[str] | None = None) -> int:
    """Run the command line and return its exit status.

    Parameters
    ----------
    arguments : sequence of str, optional
        The words after ``divbandit``; by default those of this process.

    Examples
    --------
    >>> main(["reproduce", "5"])
    2
    """
    try:
        options = vars(_parser().parse_args(arguments))
    except SystemExit as end:  # argparse has said why, or printed the help
        return int(end.code or 0)
    try:
        import loky  # noqa: F401, PLC0415
        import matplotlib as mpl  # noqa: PLC0415
        import tqdm  # noqa: F401, PLC0415
    except ImportError as error:
        print(f"divbandit: {error}; pip install 'divbandit[cli]'", file=sys.stderr)
        return 1
    mpl.use("Agg")
    try:
        options.pop("run")(**options, bar=_bar)
    except (ImportError, OSError, ValueError) as error:
        print(f"divbandit: {error}", file=sys.stderr)
        return 1
    except KeyboardInterrupt:
        print("divbandit: interrupted", file=sys.stderr)
        return 130
    print(f"written to {options['out']}")
    return 0


def _parser() -> argparse.ArgumentParser:
    parser = argparse.ArgumentParser(
        prog="divbandit", description="Diversity-driven selection of exploration strategies."
    )
    commands = parser.add_subparsers(required=True, metavar="command")
    reproduce = commands.add_parser(
        "reproduce",
        help="make the paper's figures and compare them with its archived results",
        description="Make figures 1 to 4 of Benureau and Oudeyer (2015) as PNG and SVG, and "
        "compare figure 4 with the archived results.",
    )
    reproduce.add_argument(
        "figures",
        nargs="*",
        type=_from(1, 4),
        metavar="FIGURE",
        help="which figures, from 1 to 4 (default: all)",
    )
    _add_options(reproduce, out="figures", jobs="threads")
    reproduce.set_defaults(run=_reproduce)
    study = commands.add_parser(
        "study",
        help="compare bandits, numbers of strategies, compositions or environments",
        description="Make a study: its figures as PNG and SVG, a CSV of all its numbers, and a "
        "table of the means. rules: every bandit in the settings of the paper's figure 4. "
        "strategies: bandits over 2 to 64 strategies. composition: the library's own against the "
        "paper's, and with one part less. environments: ADAPT, its parts and their mixtures in "
        "five black boxes (the last needs 'divbandit[mujoco]').",
    )
    study.add_argument(
        "name", choices=("rules", "strategies", "composition", "environments"), help="which"
    )
    _add_options(study, out="studies", jobs="processes")
    study.add_argument(
        "--steps",
        type=_from(5),
        default=10000,
        metavar="N",
        help="of each exploration (default: 10000)",
    )
    study.set_defaults(run=_study)
    benchmark = commands.add_parser(
        "benchmark",
        help="compare default_strategy with pyribs' algorithms on the field's problems",
        description="Explore problems with default_strategy, the paper's ADAPT, random search and "
        "pyribs' algorithms, on equal numbers of evaluations: figures as PNG and SVG, a CSV of all "
        "numbers, and a table of the means. What is in the CSV already is not explored again. "
        "Needs 'divbandit[cli,ribs,mujoco]'.",
    )
    benchmark.add_argument(
        "names", nargs="*", metavar="NAME", help="which problems, such as 'arm 20' (default: all)"
    )
    _add_options(benchmark, out="benchmark", jobs="processes", repetitions=5)
    benchmark.add_argument(
        "--budget",
        type=_from(50),
        default=None,
        metavar="N",
        help="evaluations of each exploration (default: each problem's own)",
    )
    benchmark.set_defaults(run=_benchmark)
    return parser


def _add_options(
    parser: argparse.ArgumentParser, *, out: str, jobs: str, repetitions: int = 25
) -> None:
    """Add the options that all commands have."""
    parser.add_argument(
        "--out", default=out, metavar="DIR", help=f"where to put the files (default: {out})"
    )
    parser.add_argument(
        "--repetitions",
        type=_from(1),
        default=repetitions,
        metavar="N",
        help=f"explorations behind each mean (default: {repetitions}; 3 for a quick look)",
    )
    parser.add_argument("--seed", type=_from(0), default=0, metavar="N", help="(default: 0)")
    parser.add_argument(
        "--jobs", type=_from(1), default=None, metavar="N", help=f"{jobs} (default: all cores)"
    )


def _from(low: int, high: int | None = None) -> Callable[[str], int]:
    """Return a reader of whole numbers in [low, high] for the parser."""

    def read(text: str) -> int:
        bounds = f"a whole number of at least {low}" if high is None else f"from {low} to {high}"
        try:
            number = int(text)
        except ValueError:
            raise argparse.ArgumentTypeError(f"must be {bounds}, got {text!r}") from None
        if number < low or (high is not None and number > high):
            raise argparse.ArgumentTypeError(f"must be {bounds}, got {text!r}")
        return number

    return read


def _reproduce(*, figures: list[int], **options: Any) -> None:  # noqa: ANN401 - checked there
    from divbandit.paper import comparison, reproduce  # noqa: PLC0415 - only now needed

    compared = reproduce(figures or (1, 2, 3, 4), **options)
    if compared:
        print(comparison.table(compared))


def _benchmark(**options: Any) -> None:  # noqa: ANN401 - checked there
    from divbandit.studies.benchmark import benchmark  # noqa: PLC0415 - only now needed

    print(benchmark(**options))


def _study(**options: Any) -> None:  # noqa: ANN401 - checked there
    from divbandit.studies import study  # noqa: PLC0415 - only now needed

    print(study(**options))


@contextmanager
def _bar(name: str, total: int) -> Iterator[Progress]:
    """Show a progress bar."""
    from tqdm import tqdm  # noqa: PLC0415

    with tqdm(total=total, desc=name, unit="run") as bar:
        yield bar.update
