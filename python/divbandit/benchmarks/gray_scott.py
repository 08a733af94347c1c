"""GrayScott: patterns of a reaction of two substances that diffuse."""

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

#: Diffusion of U and of V, in squares of the grid per step; V is half as mobile, as in the paper.
_DIFFUSION_U, _DIFFUSION_V = 0.16, 0.08

#: What makes 1 of an effect: a mean of v, and a root mean square of its gradient per grid unit.
_AMOUNT, _EDGES = 0.6, 0.1

#: V that is nowhere above this has died out.
_NOTHING = 1e-12

#: Steps between two looks at whether V has died out.
_LOOK = 50


@dataclass(frozen=True, init=False, repr=False)
class GrayScott(Value):
    r"""The Gray-Scott reaction: rates and a seed in, amount and edges of the pattern out.

    The model of Pearson (1993, Complex patterns in a simple system, Science 261, 189-192): U is fed
    and turns into V where there is V, which is removed,

    .. math::

        \dot u = D_u \nabla^2 u - u v^2 + F (1 - u), \quad
        \dot v = D_v \nabla^2 v + u v^2 - (F + k) v,

    on a square grid with periodic borders, the Laplacian of five points, Euler steps of 1,
    :math:`D_u = 0.16` and :math:`D_v = 0.08`. There is only U at first, u = 1 and v = 0, but for
    a square in the middle, where u = 1/2 and v = 1/4, with noise: u - a p and v + a q / 2, with p
    and q uniform in [-1, 1], drawn once and for all. A part of a grid square is filled in part, so
    that the start changes continuously with the command.

    About seven of ten random commands end without a pattern, with V everywhere alike or nowhere;
    the others make spots, worms, rings, labyrinths, or a front on its way.

    Parameters
    ----------
    size : int
        Width and height of the grid, from 16 to 4096.
    steps : int
        Number of steps, at least 500: before that, fronts may be steeper than any pattern.

    Attributes
    ----------
    motor_space : Box
        Feed F in [0.01, 0.08] and kill k in [0.045, 0.07], per step; the side of the square in
        [2, size / 2], in grid units; the amplitude a of the noise in [0, 0.2].
    sensory_space : Box
        [0, 1] x [0, 1], without unit: see `__call__`.

    Raises
    ------
    TypeError, ValueError
        If an argument is not a whole number in its range.

    Notes
    -----
    Equal commands have equal effects on one machine; between machines, the last digits may differ,
    and turbulent patterns with them. An evaluation takes about 50 ms with the defaults.

    Examples
    --------
    >>> from divbandit.benchmarks import GrayScott
    >>> reaction = GrayScott(24, steps=1000)
    >>> reaction([[0.037, 0.06, 8, 0.1], [0.08, 0.07, 8, 0.1]]).round(3)  # a pattern, and none
    array([[0.291, 0.589],
           [0.   , 0.   ]])
    """

    size: int
    steps: int

    if TYPE_CHECKING:
        motor_space: Box
        sensory_space: Box

    def __init__(self, size: int = 64, steps: int = 2000) -> None:
        size = whole("size", size, low=16, high=4096)
        self._set(
            size=size,
            steps=whole("steps", steps, low=500),
            motor_space=Box([0.01, 0.045, 2, 0], [0.08, 0.07, size / 2, 0.2]),
            sensory_space=Box([0, 0], [1, 1]),
        )

    def __call__(self, command: ArrayLike) -> NDArray[np.float64]:
        r"""Return the amount of V and its edges for one command, or for each of many.

        The amount is the mean of v over 0.6. The edges are the root of the mean squared gradient,

        .. math::

            \sqrt{\langle (v_{i+1,j} - v_{ij})^2 + (v_{i,j+1} - v_{ij})^2 \rangle} \; / \; 0.1.

        Both are defined, and change little with v, for every pattern, also a uniform one, whose
        edges are 0; a correlation length is not. At the same amount, they tell uniform patterns
        from coarse and from fine ones. The constants are above what random commands reach.

        Parameters
        ----------
        command : array_like, shape (4,) or (n, 4)
            Feed, kill, side and noise.

        Returns
        -------
        numpy.ndarray of float64, shape (2,) or (n, 2)
            Amount and edges.

        Raises
        ------
        TypeError, ValueError
            If the shape is wrong, or a number is not finite or beyond its range.

        Examples
        --------
        >>> from divbandit.benchmarks import GrayScott
        >>> GrayScott(16, steps=500)([0.08, 0.05, 6, 0.1]).round(3)  # V everywhere alike
        array([0.715, 0.   ])
        """
        return one_by_one(self._effect, command, self.motor_space, self.sensory_space)

    def pattern(self, command: ArrayLike) -> NDArray[np.float64]:
        """Return the final v on the grid.

        Parameters
        ----------
        command : array_like, shape (4,)
            Feed, kill, side and noise.

        Returns
        -------
        numpy.ndarray of float64, shape (size, size)
            From 0 to about 0.6.

        Raises
        ------
        TypeError, ValueError
            If the shape is wrong, or a number is not finite or beyond its range.

        Examples
        --------
        >>> from divbandit.benchmarks import GrayScott
        >>> GrayScott(16, steps=500).pattern([0.037, 0.06, 8, 0])[8].round(1)
        array([0.1, 0.1, 0.2, 0.3, 0.3, 0.3, 0.3, 0.2, 0.2, 0.3, 0.3, 0.3, 0.3,
               0.2, 0.1, 0.1])
        """
        return self._final(self.motor_space.bounds.command(command))

    def _effect(self, command: NDArray[np.float64]) -> NDArray[np.float64]:
        return effect_of(self._final(command))

    def _final(self, command: NDArray[np.float64]) -> NDArray[np.float64]:
        feed, kill, side, noise = command.tolist()
        v: NDArray[np.float64] = reacted(seeded(self.size, side, noise), feed, kill, self.steps)[1]
        return v


def seeded(size: int, side: float, noise: float) -> NDArray[np.float64]:
    """Return u and v at first, shape (2, size, size): a noisy square in the middle."""
    p, q = 2.0 * np.random.default_rng(0).random((2, size, size)) - 1.0
    from_middle = np.abs(np.arange(size) - (size - 1) / 2)
    along = np.clip((side + 1) / 2 - from_middle, 0.0, 1.0)  # how much of each row is within
    within = along[:, None] * along
    return np.stack([1.0 - within * (0.5 + noise * p), within * (0.25 + noise * q / 2)])


def reacted(
    start: NDArray[np.float64], feed: float, kill: float, steps: int
) -> NDArray[np.float64]:
    """Return u and v, shape (2, size, size), after so many steps from `start`, of that shape.

    It stops early once V has died out: where u is at most 1 and v below feed + kill, V can but
    vanish. There is then no V, and u is as it was.
    """
    size = start.shape[-1]
    width = size + 2  # with a border, which holds what is beyond it on the other side
    grid = np.zeros((2, width, width))
    grid[:, 1:-1, 1:-1] = start
    # All rows but the first and the last one in a row, and their neighbours: contiguous, which is
    # twice as fast. The border columns among them are written over before they are read.
    flat = grid.reshape(2, -1)
    length = width * size
    here, above, below, left, right = (
        flat[:, first : first + length] for first in (width, 0, 2 * width, width - 1, width + 1)
    )
    u, v = here
    around, made = np.empty((2, length)), np.empty(length)
    around_u, around_v = around
    keep_u, keep_v = 1.0 - 4.0 * _DIFFUSION_U - feed, 1.0 - 4.0 * _DIFFUSION_V - feed - kill
    for step in range(steps):
        grid[:, 0], grid[:, -1] = grid[:, -2], grid[:, 1]
        grid[:, :, 0], grid[:, :, -1] = grid[:, :, -2], grid[:, :, 1]
        if step % _LOOK == 0 and v.max() < _NOTHING:
            v[:] = 0.0
            break
        np.multiply(v, v, out=made)
        made *= u
        np.add(above, below, out=around)
        np.add(around, left, out=around)
        np.add(around, right, out=around)
        around_u *= _DIFFUSION_U
        around_v *= _DIFFUSION_V
        u *= keep_u
        u += around_u
        u -= made
        u += feed
        v *= keep_v
        v += around_v
        v += made
    return grid[:, 1:-1, 1:-1].copy()


def effect_of(v: NDArray[np.float64]) -> NDArray[np.float64]:
    """Return the amount and the edges of a pattern."""
    squares = [np.square(np.roll(v, -1, axis) - v).mean() for axis in (0, 1)]
    return np.array([v.mean() / _AMOUNT, np.sqrt(squares[0] + squares[1]) / _EDGES])
