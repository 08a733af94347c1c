"""QuasiRandomBabbling: motor commands spread evenly, where random ones leave gaps."""

from __future__ import annotations

import inspect
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np

from divbandit.strategies import Strategy, Trial
from divbandit.strategies.base import StrategyValue

if TYPE_CHECKING:
    from numpy.random import Generator
    from numpy.typing import NDArray

    from divbandit.box import Box
    from divbandit.history import History
    from divbandit.strategies.base import Starter

#: How many points are made at a time: SciPy takes as long for one as for many.
_BLOCK = 256

#: Binary digits of a coordinate, as many as a float64 holds. There are 2^53 points then.
_BITS = 53


@dataclass(frozen=True, init=False, repr=False)
class QuasiRandomBabbling(StrategyValue):
    """Commands that fill M evenly: a scrambled Sobol sequence (Sobol 1967, Owen 1998).

    Each command by itself is uniform in M, as those of `MotorBabbling` are; together they leave
    smaller gaps, most so in few dimensions. Needs SciPy, which is imported when an exploration
    begins: ``pip install 'divbandit[qmc]'``.

    The scrambling is seeded by a single ``rng.random()`` with the first command; later ones draw
    nothing. The points are SciPy's: another version of it might make others from the same seed.

    Raises
    ------
    ImportError
        If SciPy is missing, when an exploration begins.

    Examples
    --------
    >>> import divbandit as db
    >>> from divbandit.adapters import QuasiRandomBabbling
    >>> run = db.explore(db.PlanarArm(2), QuasiRandomBabbling(), n=64, rng=0)
    >>> cells = (4 * run.commands / db.PlanarArm(2).limit + 4).astype(int)
    >>> len(set(map(tuple, cells.tolist())))  # one in each of 8 x 8 cells
    64
    """

    def check(self, motor_space: Box, effect_dim: int | None, *, has_goals: bool) -> None:
        """Require SciPy, and no more motor coordinates than its sequences have."""
        del effect_dim, has_goals
        _sobol(motor_space.dim, 0)

    def start(self, start: Starter) -> Strategy:
        """Return a sequence that has not begun."""
        del start
        return _Filling()


class _Filling(Strategy):
    """Quasi-random babbling under way: a sequence, and its next points, the last one first."""

    def __init__(self) -> None:
        self._sequence: Any = None
        self._next: list[NDArray[np.float64]] = []

    def propose(self, history: History, rng: Generator) -> Trial:
        """Return the next point of the sequence; one ``rng.random()`` before the first."""
        space = history.motor_space
        if self._sequence is None:
            self._sequence = _sobol(space.dim, int(rng.random() * 2**53))
        if not self._next:
            self._next = list(self._sequence.random(_BLOCK)[::-1])
        point = self._next.pop()
        # Rounding may carry the sum one unit beyond `high`.
        return Trial(np.minimum(space.low + (space.high - space.low) * point, space.high))


def _sobol(dim: int, seed: int) -> Any:  # noqa: ANN401 - SciPy has no types
    """Return a scrambled Sobol sequence, or say why there is none."""
    try:
        from scipy.stats import qmc  # noqa: PLC0415 - an extra
    except ImportError as error:
        raise ImportError(
            "QuasiRandomBabbling needs SciPy: pip install 'divbandit[qmc]'"
        ) from error
    if dim > qmc.Sobol.MAXDIM:
        raise ValueError(
            f"motor_space must have at most {qmc.Sobol.MAXDIM} coordinates for "
            f"QuasiRandomBabbling, got {dim}"
        )
    # The argument was called `seed` before SciPy 1.15.
    name = "rng" if "rng" in inspect.signature(qmc.Sobol).parameters else "seed"
    generator = np.random.Generator(np.random.PCG64(seed))
    return qmc.Sobol(dim, scramble=True, bits=_BITS, **{name: generator})
