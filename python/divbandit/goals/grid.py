"""GridGoals: a goal in each cell of a grid before there is a second one in any."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

from divbandit._checks import cells_of, check_cells
from divbandit.goals.boxed import BoxedGoals, box_of

if TYPE_CHECKING:
    from collections.abc import Sequence

    from divbandit.box import Box, BoxLike


@dataclass(frozen=True, init=False, repr=False)
class GridGoals(BoxedGoals):
    """Goals uniform in the cells of a grid: each cell once, in random order, then each again.

    As many uniform goals as there are cells leave, by chance, a third of the cells empty; these
    goals are spread evenly at any time. Each cell has its turn whatever was observed in it: to
    prefer cells with few effects would be to prefer those that cannot be reached. Goals are uniform
    in their cell rather than at its centre, so that no two rounds have the same goals. A goal costs
    one ``rng.random()`` for the cell, then one a coordinate.

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
        If `cells` are not such numbers, are too many or of another dimension than `box`, or `box`
        is no box.

    Examples
    --------
    >>> import numpy as np
    >>> import divbandit as db
    >>> history = db.History(db.Box([0], [1]), db.Box([0], [1]))
    >>> history.append([0.5], [0.6])
    >>> sampler, rng = db.goals.GridGoals(4).start(history), np.random.default_rng(0)
    >>> sorted(int(4 * sampler.sample(history, rng)[0]) for _ in range(4))
    [0, 1, 2, 3]
    >>> babbling = db.GoalBabbling(0.05, goals=db.goals.GridGoals(20))
    >>> run = db.explore(db.PlanarArm(20), babbling, n=100, rng=0)
    """

    cells: int | tuple[int, ...]
    box: Box | None

    def __init__(self, cells: int | Sequence[int], *, box: BoxLike | None = None) -> None:
        self._set(cells=cells_of(cells), box=box_of(box))
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
        >>> db.goals.GridGoals([3, 4]).check(3, has_goals=True)
        Traceback (most recent call last):
            ...
        ValueError: cells must be one number or 3, one for each coordinate of the goals, got 2
        """
        super().check(effect_dim, has_goals=has_goals)
        dim = effect_dim if self.box is None else self.box.dim
        if dim is not None:
            check_cells(self.cells, dim, "goals")
