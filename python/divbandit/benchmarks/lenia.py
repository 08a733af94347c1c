"""Lenia: patterns of a cellular automaton with continuous space, time and states."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from divbandit._checks import whole
from divbandit._value import Value
from divbandit.box import Box
from divbandit.environments._one_by_one import one_by_one

if TYPE_CHECKING:
    from numpy.typing import ArrayLike, NDArray

#: Blocks along each side of the patch that an automaton starts with.
_BLOCKS = 4

#: The lowest and the highest center, width and number of steps in a unit of time.
_LOW, _HIGH = (0.1, 0.01, 5.0), (0.35, 0.05, 50.0)


@dataclass(frozen=True, init=False, repr=False)
class Lenia(Value):
    r"""Lenia: growth and a patch of cells in, mass and activity of the pattern out.

    The continuous cellular automaton of Chan (2019, Lenia: biology of artificial life, Complex
    Systems 28(3), 251-286), on a square grid with periodic borders. The states A of cells lie in
    [0, 1]. In each step, all at once,

    .. math::

        A \leftarrow \mathrm{clip}\bigl(A + G(K * A) / T,\ 0,\ 1\bigr), \quad
        G(u) = 2 \exp\Bigl(-\frac{(u - \mu)^2}{2 \sigma^2}\Bigr) - 1,

    where the kernel K is a ring of radius R with an exponential profile, at distance r R from its
    center in proportion to

    .. math::

        \exp\Bigl(4 - \frac{1}{r (1 - r)}\Bigr), \quad 0 < r < 1,

    and of sum 1. R is 13 cells, or a quarter of `size` where that is less. All cells are 0 at
    first, but for a patch of 4 x 4 blocks in the middle, each a square of R // 2 cells along a side
    and of one state.

    About half of random commands die out; most others fill the grid with spots, rings or stripes at
    rest, or are about to. Few in a hundred make gliders, or other patterns that keep together.

    Parameters
    ----------
    size : int
        Width and height of the grid, from 16 to 4096.
    steps : int
        Number of steps, at least 50: before that, most patterns only show how they started.

    Attributes
    ----------
    motor_space : Box
        19 numbers: the center of growth mu in [0.1, 0.35], its width sigma in [0.01, 0.05], the
        steps in a unit of time T in [5, 50], and the states of the 16 blocks in [0, 1], row by row.
    sensory_space : Box
        [0, 1] x [0, 1], without unit: see `__call__`.

    Raises
    ------
    TypeError, ValueError
        If an argument is not a whole number in its range.

    Notes
    -----
    Equal commands have equal effects on one machine; between machines, the Fourier transform and
    the exponential may differ in the last digits, and unsteady patterns with them. An evaluation
    takes about 25 ms with the defaults.

    Examples
    --------
    >>> from divbandit.benchmarks import Lenia
    >>> automaton = Lenia(32, steps=100)
    >>> automaton([[0.15, 0.03, 10, *[0.5] * 16], [0.35, 0.01, 10, *[0.5] * 16]]).round(2)
    array([[0.42, 0.03],
           [0.  , 0.  ]])
    """

    size: int
    steps: int

    if TYPE_CHECKING:
        motor_space: Box
        sensory_space: Box
        #: The Fourier transform of the kernel.
        _kernel: NDArray[np.float64]

    def __init__(self, size: int = 64, steps: int = 200) -> None:
        size = whole("size", size, low=16, high=4096)
        kernel = transformed(ring(size))
        kernel.flags.writeable = False
        self._set(
            size=size,
            steps=whole("steps", steps, low=50),
            motor_space=Box([*_LOW, *[0] * _BLOCKS**2], [*_HIGH, *[1] * _BLOCKS**2]),
            sensory_space=Box([0, 0], [1, 1]),
            _kernel=kernel,
        )

    def __call__(self, command: ArrayLike) -> NDArray[np.float64]:
        r"""Return the mass and the activity for one command, or for each of many.

        With A the last states and A' those one step before, they are

        .. math::

            2 \langle A \rangle, \quad 2 T \, \langle |A - A'| \rangle,

        twice the mean state and twice the mean change in a unit of time. Both are defined for every
        pattern, change little with it, and are 0 for an empty one. At the same mass, the activity
        tells patterns at rest from those that move, pulsate or grow. At 1, half of the cells would
        be full, or would change at full speed; random commands stay well below.

        Parameters
        ----------
        command : array_like, shape (19,) or (n, 19)
            Center, width, steps in a unit of time, states of the blocks.

        Returns
        -------
        numpy.ndarray of float64, shape (2,) or (n, 2)
            Mass and activity.

        Raises
        ------
        TypeError, ValueError
            If the shape is wrong, or a number is not finite or beyond its range.

        Examples
        --------
        >>> from divbandit.benchmarks import Lenia
        >>> Lenia(16, steps=50)([0.2, 0.02, 10, *[0] * 16])
        array([0., 0.])
        """
        return one_by_one(self._effect, command, self.motor_space, self.sensory_space)

    def pattern(self, command: ArrayLike) -> NDArray[np.float64]:
        """Return the final states of the cells.

        Parameters
        ----------
        command : array_like, shape (19,)
            Center, width, steps in a unit of time, states of the blocks.

        Returns
        -------
        numpy.ndarray of float64, shape (size, size)
            In [0, 1].

        Raises
        ------
        TypeError, ValueError
            If the shape is wrong, or a number is not finite or beyond its range.

        Examples
        --------
        >>> from divbandit.benchmarks import Lenia
        >>> Lenia(16, steps=50).pattern([0.2, 0.04, 10, *[1] * 16])[8].round(1)
        array([0. , 0. , 0. , 0. , 0. , 1. , 0.6, 0. , 0. , 0.6, 1. , 0. , 0. ,
               0. , 0. , 0. ])
        """
        return self._last_two(self.motor_space.bounds.command(command))[1]

    def _effect(self, command: NDArray[np.float64]) -> NDArray[np.float64]:
        return effect_of(*self._last_two(command), duration=command[2])

    def _last_two(
        self, command: NDArray[np.float64]
    ) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
        center, width, duration = command[:3].tolist()
        first = patch(self.size, command[3:].reshape(_BLOCKS, _BLOCKS))
        return last_two(first, self._kernel, center, width, duration, self.steps)


def last_two(
    first: NDArray[np.float64],
    kernel: NDArray[np.float64],
    center: float,
    width: float,
    duration: float,
    steps: int,
) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    """Return the states one step before the last, and the last ones; `kernel` is transformed."""
    before = states = first
    for _ in range(steps):
        before = states
        if not states.any():
            break  # nothing comes from nothing: growth is negative at 0 for all commands
        around = np.fft.irfft2(np.fft.rfft2(states) * kernel, s=states.shape)
        states = np.clip(states + growth(around, center, width) / duration, 0.0, 1.0)
    return before, states


def radius_of(size: int) -> int:
    """Return the kernel's radius in cells on a grid of this width."""
    return min(13, size // 4)


def ring(size: int) -> NDArray[np.float64]:
    """Return the kernel on the grid, shape (size, size), with its center in the first cell."""
    from_first = np.minimum(np.arange(size), size - np.arange(size))
    r = np.hypot(from_first[:, None], from_first) / radius_of(size)
    kernel = np.zeros((size, size))
    within = (r > 0.0) & (r < 1.0)
    kernel[within] = np.exp(4.0 - 1.0 / (r[within] * (1.0 - r[within])))
    kernel /= kernel.sum()
    return kernel


def transformed(kernel: NDArray[np.float64]) -> NDArray[np.float64]:
    """Return a kernel's Fourier transform, which is real, as the kernel is even."""
    return np.ascontiguousarray(np.fft.rfft2(kernel).real)


def growth(around: NDArray[np.float64], center: float, width: float) -> NDArray[np.float64]:
    """Return how fast cells grow, from -1 to 1, by what is around them."""
    return 2.0 * np.exp(-np.square(around - center) / (2.0 * width**2)) - 1.0


def patch(size: int, blocks: NDArray[np.float64]) -> NDArray[np.float64]:
    """Return the first states, shape (size, size): square blocks in the middle of the grid."""
    block = radius_of(size) // 2
    first = (size - len(blocks) * block) // 2
    states = np.zeros((size, size))
    inner = slice(first, first + len(blocks) * block)
    states[inner, inner] = np.kron(blocks, np.ones((block, block)))
    return states


def effect_of(
    before: NDArray[np.float64], last: NDArray[np.float64], duration: float
) -> NDArray[np.float64]:
    """Return the mass and the activity of a pattern."""
    return 2.0 * np.array([last.mean(), duration * np.abs(last - before).mean()])
