"""Coverage: the measure of the union of balls around effects, the paper's diversity."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

from divbandit import _core, _files
from divbandit._checks import generator
from divbandit.measures.boundary import Loop

if TYPE_CHECKING:
    import os

    from numpy.typing import ArrayLike, NDArray
    from typing_extensions import Self

    from divbandit._checks import Rng

_FORMAT = "divbandit coverage"
#: Of files and of pickles.
_VERSION = 1


class Coverage(_core.Coverage):
    """The diversity C_tau of a growing set of effects (Benureau and Oudeyer 2015).

    It is the measure of the union of the balls of radius tau around the effects. On a line, in
    the plane and in space it is exact: the length of a union of intervals, the area of one of
    discs (each gain right to some 1e-15 of a disc) and the volume of one of balls (to some 1e-13
    of a ball; a gain below that is 0). From dimension 4 on gains are estimated by randomised
    quasi-Monte Carlo, each with a standard error. Effects that lie in the union already, or have
    since been surrounded, cost next to nothing on a line, in the plane and in space.

    Parameters
    ----------
    tau : float
        Radius of the balls, in the units of the effects; positive.
    dim : int
        Dimension of the effects, from 1 to 32.
    accuracy : float
        For estimates: upper limit on the standard error of a gain, as a share of a ball's measure,
        in (0, 1). Half of it takes some two to four times as long. No gain uses more than 262,144
        rays; where those do not suffice, its standard error says so.
    rng : None, int, SeedSequence or Generator
        For estimates: the source of all randomness. One number is drawn from it at once, and none
        if gains are exact.

    Attributes
    ----------
    tau : float
    dim : int
    exact : bool
        Whether gains are exact: up to dimension 3.
    accuracy : float
    measure : float
        The measure of the union: the sum of all gains, without drift.
    standard_error : float
        That of `measure`; 0.0 where it is exact.
    largest_gain : float
        The measure of one ball, which no gain exceeds.
    effects : numpy.ndarray of float64, shape (n, dim)
        All effects in order; read-only, a copy.
    gains : numpy.ndarray of float64, shape (n,)
        The gain of each when it was added; read-only, a copy.
    standard_errors : numpy.ndarray of float64, shape (n,)
        That of each gain; read-only, a copy.

    Raises
    ------
    TypeError, ValueError
        If `tau` is not in [1e-100, 1e100] or the measure of a ball is beyond the range of floats,
        or another argument is out of range.

    Examples
    --------
    >>> import divbandit as db
    >>> cov = db.Coverage(1.0)
    >>> cov.add([0, 0])
    3.141592653589793
    >>> cov.add([5, 0]), cov.add([0, 0])
    (3.141592653589793, 0.0)
    >>> cov.measure
    6.283185307179586

    Six dimensions: a ball, and another half a radius away.

    >>> cov = db.Coverage(1.0, dim=6, accuracy=1e-3, rng=0)
    >>> gains = cov.extend([[0, 0, 0, 0, 0, 0], [0.5, 0, 0, 0, 0, 0]])
    >>> cov.exact, bool(cov.standard_error < 1e-3 * cov.largest_gain)
    (False, True)
    """

    __slots__ = ()

    def __new__(cls, tau: float, *, dim: int = 2, accuracy: float = 1e-3, rng: Rng = None) -> Self:
        """Make an empty one."""
        if rng is not None:
            generator(rng)
        cov = super().__new__(cls, tau, dim, accuracy, 0)
        if cov.exact:
            return cov
        return super().__new__(cls, tau, dim, accuracy, int(generator(rng).random() * 2**53))

    def boundary(self) -> tuple[Loop, ...]:
        """Return the boundary of the union in the plane: closed loops of circular arcs, exactly.

        Outer loops run counter-clockwise and holes clockwise, so that the union lies on the left.

        Returns
        -------
        tuple of Loop
            Empty without effects. Loops shorter than a billionth of tau are left out.

        Raises
        ------
        ValueError
            If the effects are not in the plane.

        Examples
        --------
        A ring of six discs has an outer boundary and a hole.

        >>> import numpy as np
        >>> import divbandit as db
        >>> angles = np.arange(6) * np.pi / 3
        >>> cov = db.Coverage(1.0)
        >>> _ = cov.extend(1.5 * np.stack([np.cos(angles), np.sin(angles)], axis=1))
        >>> [(len(loop.arcs), loop.is_hole) for loop in cov.boundary()]
        [(6, False), (6, True)]
        >>> bool(np.isclose(sum(loop.area for loop in cov.boundary()), cov.measure))
        True
        """
        loops = self._boundary()
        if loops is None:
            raise ValueError(f"effects must be in the plane to have a boundary, got dim {self.dim}")
        return tuple(Loop(arcs, self.tau) for arcs in loops)

    def save(self, path: str | os.PathLike[str]) -> None:
        """Write all effects, their gains and how those are found to a file.

        The file is NumPy's ``npz``, replaced whole or not at all; nothing in it is pickled.

        Parameters
        ----------
        path : str or path
            Used as it is: no ending is added.

        Raises
        ------
        OSError
            If the file cannot be written.

        Examples
        --------
        >>> import os, tempfile
        >>> import divbandit as db
        >>> cov = db.Coverage(0.02)
        >>> _ = cov.add([0.1, 0.2])
        >>> with tempfile.TemporaryDirectory() as folder:
        ...     cov.save(os.path.join(folder, "cov.npz"))
        ...     again = db.Coverage.load(os.path.join(folder, "cov.npz"))
        >>> again.measure == cov.measure
        True
        """
        _files.write(path, _FORMAT, _VERSION, self._log())

    @classmethod
    def load(cls, path: str | os.PathLike[str]) -> Self:
        """Read a saved Coverage, which continues exactly as the original would.

        Parameters
        ----------
        path : str or path

        Raises
        ------
        ValueError
            If the file is truncated or was not written by `save`.
        OSError
            If the file cannot be read.

        Examples
        --------
        >>> import divbandit as db
        >>> db.Coverage.load("missing.npz")
        Traceback (most recent call last):
            ...
        FileNotFoundError: [Errno 2] No such file or directory: 'missing.npz'
        """
        return _files.read(path, _FORMAT, _VERSION, cls._from_log, writer="Coverage.save")

    def _log(self) -> dict[str, NDArray[Any]]:
        """Return the whole state as arrays."""
        return {
            "ball": np.array([self.tau, self.accuracy]),
            "dim_and_key": np.array([self.dim, self._key], dtype=np.int64),
            "effects": self.effects,
            "gains": self.gains,
            "standard_errors": self.standard_errors[: 0 if self.exact else None],
        }

    @classmethod
    def _from_log(cls, log: dict[str, NDArray[Any]]) -> Self:
        """Restore a Coverage from what `_log` returned, or say what is wrong with it."""
        tau, accuracy = _files.array(log, "ball", np.float64, (2,)).tolist()
        dim, key = _files.array(log, "dim_and_key", np.int64, (2,)).tolist()
        cov = _core.Coverage.__new__(cls, tau, dim, accuracy, key)
        effects = _files.array(log, "effects", np.float64, (None, dim))
        gains = _files.array(log, "gains", np.float64, (len(effects),))
        errors = _files.array(log, "standard_errors", np.float64, (None,))
        cov._restore(effects, gains, errors)  # noqa: SLF001 - its own
        return cov

    def __copy__(self) -> Self:
        """Return an independent copy."""
        cov = _core.Coverage.__new__(type(self), self.tau, self.dim, self.accuracy, self._key)
        cov._become(self)  # noqa: SLF001 - its own
        return cov

    def __deepcopy__(self, _memo: object) -> Self:
        """Copy as ``copy.copy`` does: nothing in it is shared anyway."""
        return self.__copy__()

    def __reduce__(self) -> tuple[Any, ...]:
        """Say what to pickle: the same log that `save` writes, with its version."""
        return _unpickled, (type(self), _VERSION, self._log())

    def __repr__(self) -> str:
        uncertain = "" if self.exact else f" +- {self.standard_error!r}"
        return (
            f"<Coverage of {len(self)} effects in R^{self.dim}, tau={self.tau!r}, "
            f"measure={self.measure!r}{uncertain}>"
        )


def _unpickled(cls: type[Coverage], version: int, log: dict[str, NDArray[Any]]) -> Coverage:
    if version != _VERSION:
        raise ValueError(f"a pickled Coverage must have version {_VERSION}, got {version!r}")
    return cls._from_log(log)


def coverage(effects: ArrayLike, tau: float, *, accuracy: float = 1e-3, rng: Rng = None) -> float:
    """Return the diversity C_tau of a whole set of effects (Benureau and Oudeyer 2015).

    Parameters
    ----------
    effects : array_like, shape (n, dim)
    tau : float
        Radius of the balls, in the units of the effects; positive.
    accuracy, rng
        As in `Coverage`, where gains are estimated: from dimension 4 on.

    Returns
    -------
    float
        The measure of the union of the balls; 0.0 for no effects.

    Raises
    ------
    TypeError, ValueError
        If an effect is not a finite point, or another argument is not what `Coverage` takes.

    Examples
    --------
    >>> import divbandit as db
    >>> round(db.coverage([[0, 0], [1, 0]], 1.0), 12)
    5.054815608571
    >>> db.coverage([[0], [1]], 1.0)
    3.0
    """
    cov = Coverage(tau, dim=_dim(effects), accuracy=accuracy, rng=rng)
    cov.extend(effects)
    return cov.measure


def _dim(effects: ArrayLike) -> int:
    """Return the dimension of points of shape (n, dim), or 2 for anything else.

    Other errors are raised where the points are read.
    """
    try:
        shape = np.shape(effects)
    except (TypeError, ValueError):  # rows of several lengths
        shape = ()
    return shape[1] if len(shape) == 2 and shape[1] > 0 else 2
