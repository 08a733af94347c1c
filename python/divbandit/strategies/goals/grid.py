"""GridGoals: a goal in each cell of a grid before there is a second one in any."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from divbandit._checks import whole
from divbandit.strategies.goals.boxed import BoxedGoals

if TYPE_CHECKING:
    from collections.abc import Sequence

    from numpy.random import Generator
    from numpy.typing import NDArray

    from divbandit.box import BoxLike
    from divbandit.history import History

#: The finest grid: its cells are kept one by one.
_MOST_CELLS = 10_000_000


class GridGoals(BoxedGoals):
    """Goals uniform in the cells of a grid, all cells in random order, then all again.

    Goals drawn uniformly leave, by chance, a third of as many cells empty; these are spread as
    evenly at any time. Each cell has its turn whatever was observed in it: choosing the cells
    with the fewest effects would mean choosing those that cannot be reached, for ever. Uniform
    in the cell rather than at its centre, as an effect right there is not more worth than others,
    and no two rounds have the same goals.

    Parameters
    ----------
    cells : int or sequence of int, shape (s,)
        How many cells the box is cut into along each coordinate; at least 1, and at most ten
        million altogether.
    box : Box or object with ``low`` and ``high``, optional
        What is cut into cells; by default the environment's sensory space.

    Attributes
    ----------
    cells : int or tuple of int
    box : Box or None

    Raises
    ------
    TypeError, ValueError
        If `cells` are no such numbers, are too many or of another dimension than `box`, or `box`
        is no box.

    Examples
    --------
    >>> import divbandit as db
    >>> babbling = db.GoalBabbling(0.05, goals=db.GridGoals(20))
    >>> run = db.explore(db.PlanarArm(20), babbling, n=100, rng=0)
    """

    def __init__(self, cells: int | Sequence[int], *, box: BoxLike | None = None) -> None:
        super().__init__(box)
        self.cells: int | tuple[int, ...] = _cells(cells)
        # The cells still to come in this round; the shape of the grid that they are of.
        self._left: list[int] = []
        self._shape: tuple[int, ...] | None = None
        self._history: History | None = None
        self.check(None, has_goals=True)

    def check(self, effect_dim: int | None, *, has_goals: bool) -> None:
        """Require a box, and cells, of the effects' dimension.

        Parameters
        ----------
        effect_dim : int or None
            Dimension of the effects; None if it is not known yet.
        has_goals : bool
            Whether the environment names a sensory space.

        Examples
        --------
        >>> import divbandit as db
        >>> db.GridGoals([3, 4]).check(3, has_goals=True)
        Traceback (most recent call last):
            ...
        ValueError: cells must be one number or 3, one for each coordinate of the goals, got 2
        """
        super().check(effect_dim, has_goals=has_goals)
        dim = effect_dim if self.box is None else self.box.dim
        if dim is not None:
            self._grid(dim)

    def sample(self, history: History, rng: Generator) -> NDArray[np.float64]:
        """Draw a goal: one ``rng.random()`` for the cell, then one a coordinate.

        Parameters
        ----------
        history : History
        rng : numpy.random.Generator

        Returns
        -------
        numpy.ndarray of float64, shape (s,)

        Raises
        ------
        ValueError
            If there is no box to draw in, or `cells` are of another dimension.

        Examples
        --------
        >>> import numpy as np
        >>> import divbandit as db
        >>> history = db.History(db.Box([0], [1]), db.Box([0], [1]))
        >>> goals, rng = db.GridGoals(4), np.random.default_rng(0)
        >>> sorted(int(4 * goals.sample(history, rng)[0]) for _ in range(4))
        [0, 1, 2, 3]
        """
        box = self.box_for(history)
        shape = self._grid(box.dim)
        if not self._left or shape != self._shape or history is not self._history:
            self._shape, self._history = shape, history
            self._left = list(range(_product(shape)))
        left = self._left
        place = int(rng.random() * len(left))
        left[place], left[-1] = left[-1], left[place]
        cell = left.pop()
        goal = np.empty(box.dim)
        for j, (low, high) in enumerate(zip(box.low.tolist(), box.high.tolist(), strict=True)):
            cell, column = divmod(cell, shape[j])
            share = (column + rng.random()) / shape[j]
            goal[j] = min(low + (high - low) * share, high)
        return goal

    def _grid(self, dim: int) -> tuple[int, ...]:
        """Return how many cells there are along each of `dim` coordinates."""
        cells = self.cells
        shape = (cells,) * dim if isinstance(cells, int) else cells
        if len(shape) != dim:
            raise ValueError(
                f"cells must be one number or {dim}, one for each coordinate of the goals, "
                f"got {len(shape)}"
            )
        if _product(shape) > _MOST_CELLS:
            raise ValueError(f"cells must be at most {_MOST_CELLS} altogether, got {cells!r}")
        return shape

    def _arguments(self) -> list[str]:
        return [repr(list(self.cells) if isinstance(self.cells, tuple) else self.cells)]


def _cells(cells: int | Sequence[int]) -> int | tuple[int, ...]:
    """Return the numbers of cells, each of them checked."""
    if not isinstance(cells, (list, tuple, np.ndarray)):
        return whole("cells", cells, low=1, high=_MOST_CELLS)
    if len(cells) == 0:
        raise ValueError("cells must not be empty")
    return tuple(
        whole(f"cells[{j}]", count, low=1, high=_MOST_CELLS) for j, count in enumerate(cells)
    )


def _product(shape: tuple[int, ...]) -> int:
    product = 1
    for count in shape:
        product *= count
    return product
