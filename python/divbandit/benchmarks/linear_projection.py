"""LinearProjection: sums of halves of a command, which are hard to bring to their limits."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from divbandit import _core
from divbandit._checks import one_of
from divbandit._value import Value
from divbandit.box import Box

if TYPE_CHECKING:
    from collections.abc import Callable

    from numpy.typing import ArrayLike, NDArray

#: Where a coordinate folds back, 5.12: half of the upper limit of commands.
FOLD = _core.LinearProjection.FOLD

#: Where the optimum of the sphere and of Rastrigin's function lies, in each coordinate.
_OPTIMUM = 0.4 * FOLD


@dataclass(frozen=True, init=False, repr=False)
class LinearProjection(Value):
    """Linear projection, the benchmark of CMA-ME and its successors.

    The effect is the sums of the two halves of a command, in which each coordinate x counts as it
    is within [-5.12, 5.12], and folds back to 5.12 / x beyond. Sums of many random numbers are near
    0, so that most commands have effects in the middle; in the corners, each coordinate must be
    near 5.12, but not beyond (Fontaine, Togelius, Nikolaidis and Hoover 2020, "Covariance Matrix
    Adaptation for the Rapid Illumination of Behavior Space", GECCO).

    There, commands are unbounded; here they lie within twice the fold, beyond which a coordinate
    adds 0.5 at most.

    Parameters
    ----------
    dim : int
        Number of coordinates of a command; even, at least 2.
    objective : {"flat", "sphere", "rastrigin", "plateau"}
        What `quality` computes, for comparisons with quality-diversity algorithms; effects do not
        depend on it.

    Attributes
    ----------
    motor_space : Box
        [-10.24, 10.24]^dim.
    sensory_space : Box
        All that can be reached: twice [-2.56 dim, 2.56 dim].

    Raises
    ------
    TypeError, ValueError
        If `dim` is not an even number of at least 2, or there is no such objective.

    Examples
    --------
    >>> from divbandit.benchmarks import LinearProjection
    >>> projection = LinearProjection(4)
    >>> projection([1.0, 2.0, -5.0, 10.24])
    array([ 3. , -4.5])
    >>> projection.sensory_space
    Box([-10.24, -10.24], [10.24, 10.24])
    """

    dim: int
    objective: str

    if TYPE_CHECKING:
        motor_space: Box
        sensory_space: Box
        _kernel: _core.LinearProjection

    def __init__(self, dim: int = 20, *, objective: str = "flat") -> None:
        kernel = _core.LinearProjection(dim)
        dim = int(dim)
        low, end = np.full(dim, -2 * FOLD), FOLD * (dim // 2)
        self._set(
            dim=dim,
            objective=one_of("objective", objective, tuple(_OBJECTIVES)),
            motor_space=Box(low, -low),
            sensory_space=Box([-end, -end], [end, end]),
            _kernel=kernel,
        )

    def __call__(self, command: ArrayLike) -> NDArray[np.float64]:
        """Return the effect of one command, or the effects of many.

        Parameters
        ----------
        command : array_like, shape (dim,) or (n, dim)

        Returns
        -------
        numpy.ndarray of float64, shape (2,) or (n, 2)

        Raises
        ------
        TypeError, ValueError
            If a command is not a point of the motor space.

        Examples
        --------
        >>> from divbandit.benchmarks import LinearProjection
        >>> LinearProjection(2)([[1.0, 2.0], [5.12, 8.0]])
        array([[1.  , 2.  ],
               [5.12, 0.64]])
        """
        return self._kernel.effect(self.motor_space.bounds.commands(command))

    def quality(self, command: ArrayLike) -> NDArray[np.float64]:
        """Return the objective of one command, or of many: 100 is best.

        The flat one is 100 everywhere. The others are in proportion to a sum over coordinates, from
        its least value, 100, to its largest in [-5.12, 5.12], 0: of (x - 2.048)^2, the sphere; of
        (x - 2.048)^2 - 10 cos(2 pi (x - 2.048)) + 10, Rastrigin's function; or, the plateau, of
        (abs(x) - 5.12)^2 beyond 5.12 and 0 within, whose largest value is that at the border of
        the motor space (Fontaine and Nikolaidis 2023, "Covariance Matrix Adaptation MAP-Annealing",
        GECCO).

        Parameters
        ----------
        command : array_like, shape (dim,) or (n, dim)

        Returns
        -------
        numpy.ndarray of float64, shape () or (n,)

        Raises
        ------
        TypeError, ValueError
            If a command is not a point of the motor space.

        Examples
        --------
        >>> from divbandit.benchmarks import LinearProjection
        >>> sphere = LinearProjection(2, objective="sphere")
        >>> sphere.quality([[2.048, 2.048], [-5.12, -5.12]])
        array([100.,   0.])
        """
        function, worst = _OBJECTIVES[self.objective]
        return np.asarray(
            100.0
            * (1.0 - function(self.motor_space.bounds.commands(command)).mean(axis=-1) / worst)
        )


def _flat(x: NDArray[np.float64]) -> NDArray[np.float64]:
    return np.zeros_like(x)


def _sphere(x: NDArray[np.float64]) -> NDArray[np.float64]:
    return (x - _OPTIMUM) ** 2


def _rastrigin(x: NDArray[np.float64]) -> NDArray[np.float64]:
    away = x - _OPTIMUM
    return np.asarray(away**2 - 10 * np.cos(2 * np.pi * away) + 10)


def _plateau(x: NDArray[np.float64]) -> NDArray[np.float64]:
    return np.maximum(np.abs(x) - FOLD, 0.0) ** 2


#: What is summed over coordinates, and its largest value for one coordinate.
_OBJECTIVES: dict[str, tuple[Callable[[NDArray[np.float64]], NDArray[np.float64]], float]] = {
    "flat": (_flat, 1.0),
    "sphere": (_sphere, (FOLD + _OPTIMUM) ** 2),
    "rastrigin": (_rastrigin, float(_rastrigin(np.linspace(-FOLD, FOLD, 100_001)).max())),
    "plateau": (_plateau, FOLD**2),
}
