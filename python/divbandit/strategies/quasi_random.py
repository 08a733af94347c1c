"""QuasiRandomBabbling: motor commands spread evenly, where random ones leave gaps."""

from __future__ import annotations

import inspect
from typing import TYPE_CHECKING, Any

import numpy as np

from divbandit.strategies.base import Strategy, Trial

if TYPE_CHECKING:
    from numpy.random import Generator
    from numpy.typing import NDArray

    from divbandit.box import Box
    from divbandit.history import History

#: How many points are made at a time: SciPy takes as long for one as for many.
_BLOCK = 256

#: Binary digits of a coordinate, as many as a float64 holds. There are 2^53 points then.
_BITS = 53


class QuasiRandomBabbling(Strategy):
    """Commands that fill M evenly: a scrambled Sobol sequence (Sobol 1967, Owen 1998).

    Each command by itself is uniform in M, as those of `MotorBabbling` are; together they leave
    smaller gaps, most so in few dimensions. Needs SciPy, which is looked for when an exploration
    begins: ``pip install 'divbandit[qmc]'``.

    The scrambling is seeded by a single ``rng.random()`` with the first command; later ones draw
    nothing. The points are SciPy's: another version of it might make others from the same seed.

    Raises
    ------
    ImportError
        If SciPy is missing, from `check` or `propose`.

    Examples
    --------
    >>> import divbandit as db
    >>> run = db.explore(db.PlanarArm(2), db.QuasiRandomBabbling(), n=64, rng=0)
    >>> cells = (4 * run.commands / db.PlanarArm(2).limit + 4).astype(int)
    >>> len(set(map(tuple, cells.tolist())))  # one in each of 8 x 8 cells
    64
    """

    def __init__(self) -> None:
        # Of which sequence, and how many of its points were proposed.
        self._dim = 0
        self._seed = 0
        self._proposed = 0
        # Derived from these: SciPy's sequence, and its next points.
        self._sequence: Any = None
        self._next: list[NDArray[np.float64]] = []

    def check(self, motor_space: Box, effect_dim: int | None, *, has_goals: bool) -> None:
        """Require SciPy, and no more motor coordinates than its sequences have."""
        del effect_dim, has_goals
        _sobol(motor_space.dim, 0)

    def propose(self, history: History, rng: Generator) -> Trial:
        """Return the next point of the sequence; one ``rng.random()`` before the first."""
        space = history.motor_space
        if space.dim != self._dim:
            self._dim = space.dim
            self._seed = int(rng.random() * 2**53)
            self._proposed, self._sequence, self._next = 0, None, []
        if not self._next:
            self._next = self._block()
        self._proposed += 1
        point = self._next.pop()
        # Rounding may carry the sum one unit beyond `high`.
        return Trial(np.minimum(space.low + (space.high - space.low) * point, space.high))

    def _block(self) -> list[NDArray[np.float64]]:
        """Return the next points, the last one first."""
        known = self._proposed % _BLOCK
        if self._sequence is None:
            self._sequence = _sobol(self._dim, self._seed)
            # SciPy's own way to skip points takes no more than 32 digits.
            for _ in range(self._proposed // _BLOCK):
                self._sequence.random(_BLOCK)
        return list(self._sequence.random(_BLOCK)[known:][::-1])

    def __getstate__(self) -> dict[str, Any]:
        """Leave out what can be made anew."""
        return {**self.__dict__, "_sequence": None, "_next": []}


def _sobol(dim: int, seed: int) -> Any:  # noqa: ANN401 - SciPy has no types
    """Return a scrambled Sobol sequence, or say that it cannot be had."""
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
