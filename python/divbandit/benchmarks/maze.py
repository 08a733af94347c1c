"""Maze: the hard maze of novelty search, and a robot driven by a small network."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, TypeAlias

import numpy as np

from divbandit import _core
from divbandit._value import Value
from divbandit.box import Box

if TYPE_CHECKING:
    from numpy.typing import ArrayLike, NDArray

_Point: TypeAlias = tuple[float, float]


@dataclass(frozen=True, init=False, repr=False)
class Maze(Value):
    """The hard maze of novelty search: weights of a network in, where its robot ends out.

    The deceptive maze of Lehman and Stanley (2011) [1]_, in which getting closer to the goal leads
    into dead ends. Walls, start, goal, sensors and rules of motion are those of their program [2]_;
    it was written in single precision, this computes in double.

    A robot of radius 8 starts at rest at (36, 184), heading along +x. At each of 400 steps the
    outputs of its network, less 0.5, are added to its angular velocity, in degrees a step, and to
    its speed; both are kept in [-3, 3]. It moves along its heading, then turns. A move that would
    bring its centre closer than 8 to a wall is refused, and it stays where it is; speed and heading
    do not change by that. Less than 5 from the goal, at (31, 20), it has arrived and stays.

    It senses how far walls are, up to 100 and as shares of it, at -90, -45, 0, 45, 90 and -180
    degrees from its heading; and, of the quarters around 0, 90, 180 and 270 degrees, in which one
    the goal is, as 1 among 0s.

    The network is a convention of this library, as NEAT grows another for every robot. 11 inputs, a
    bias of 1, the range finders and the quarters in the order above, lead to 5 hidden units, and
    these with a bias to 2 outputs, angular velocity and speed. Units are NEAT's logistic function,
    1 / (1 + exp(-4.924273 x)). A command holds the 67 weights, each in [-3, 3]: the 11 of every
    hidden unit, then the 6 of every output, that of the bias first.

    Attributes
    ----------
    motor_space : Box
        [-3, 3]^67.
    sensory_space : Box
        [3, 195] x [5, 202], the bounding box of the walls.
    walls : tuple of ((x1, y1), (x2, y2))
        The ends of the 13 walls. With y downwards the robot starts at the bottom left, and the goal
        is at the top left.
    goal : tuple (x, y)

    Notes
    -----
    Where their program differs from the article, this follows the article: the program overwrites
    the range finder at -180 degrees with the first quarter, and leaves its last input unset.

    References
    ----------
    .. [1] J. Lehman and K. O. Stanley (2011). Abandoning objectives: Evolution through the search
       for novelty alone. Evolutionary Computation 19(2), 189-223.
    .. [2] J. Lehman. Novelty Search C++ 1.0, files ``hard_maze.txt`` and ``maze.h``,
       https://github.com/jal278/novelty-search-cpp.

    Examples
    --------
    >>> import numpy as np
    >>> import divbandit as db
    >>> from divbandit.benchmarks import Maze
    >>> maze = Maze()
    >>> maze(np.zeros(67))                    # all outputs are 0.5: it stays at rest
    array([ 36., 184.])
    >>> run = db.explore(maze, db.MotorBabbling(), n=100, rng=0)
    >>> run.effects.shape, maze.sensory_space.contains(run.effects[-1])
    ((100, 2), True)
    """

    if TYPE_CHECKING:
        motor_space: Box
        sensory_space: Box
        walls: tuple[tuple[_Point, _Point], ...]
        goal: _Point
        _kernel: _core.Maze

    def __init__(self) -> None:
        kernel = _core.Maze()
        ends = kernel.walls.reshape(-1, 2)
        heaviest = np.full(kernel.weights, kernel.limit)
        self._set(
            motor_space=Box(-heaviest, heaviest),
            sensory_space=Box(ends.min(axis=0), ends.max(axis=0)),
            walls=tuple(((x1, y1), (x2, y2)) for x1, y1, x2, y2 in kernel.walls.tolist()),
            goal=kernel.goal,
            _kernel=kernel,
        )

    def __call__(self, command: ArrayLike) -> NDArray[np.float64]:
        """Return where the robot ends for one command, or for each of many.

        Parameters
        ----------
        command : array_like, shape (67,) or (n, 67)
            Weights.

        Returns
        -------
        numpy.ndarray of float64, shape (2,) or (n, 2)
            x and y of its centre.

        Raises
        ------
        TypeError, ValueError
            If the shape is wrong, or a weight is not finite or beyond [-3, 3].

        Examples
        --------
        >>> import numpy as np
        >>> from divbandit.benchmarks import Maze
        >>> Maze()(np.zeros((2, 67)))
        array([[ 36., 184.],
               [ 36., 184.]])
        """
        return self._kernel.effect(command)

    def path(self, command: ArrayLike) -> NDArray[np.float64]:
        """Return the path of the robot.

        Parameters
        ----------
        command : array_like, shape (67,)
            Weights.

        Returns
        -------
        numpy.ndarray of float64, shape (k, 2)
            x and y of its centre, at the start and after each step: 401 rows, or fewer if it
            arrives at the goal. The last equals the effect.

        Raises
        ------
        TypeError, ValueError
            If the shape is wrong, or a weight is not finite or beyond [-3, 3].

        Examples
        --------
        Its output for speed alone is not 0.5: it goes straight ahead, up to a wall.

        >>> import numpy as np
        >>> from divbandit.benchmarks import Maze
        >>> weights = np.zeros(67)
        >>> weights[61] = 1.0
        >>> Maze().path(weights)[[0, 1, 2, 400]].round(2)
        array([[ 36.  , 184.  ],
               [ 36.49, 184.  ],
               [ 37.48, 184.  ],
               [ 79.35, 184.  ]])
        """
        return self._kernel.path(command)
