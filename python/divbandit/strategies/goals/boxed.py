"""BoxedGoals: what all goal samplers share that draw in a box - their own or the sensory space."""

from __future__ import annotations

from typing import TYPE_CHECKING

from divbandit.box import Box, BoxLike

if TYPE_CHECKING:
    from divbandit.history import History

#: More draws for a goal than anybody waits for.
MOST_DRAWS = 1_000_000


class BoxedGoals:
    """Goals in a box.

    Parameters
    ----------
    box : Box or object with ``low`` and ``high``, optional
        Where goals are drawn; by default the environment's sensory space.

    Examples
    --------
    >>> import divbandit as db
    >>> BoxedGoals(db.Box([0], [1]))
    BoxedGoals(box=Box([0.0], [1.0]))
    """

    def __init__(self, box: BoxLike | None = None) -> None:
        self.box = None if box is None else Box.of(box, name="box")

    def check(self, effect_dim: int | None, *, has_goals: bool) -> None:
        """Raise a ValueError if there is no box, or it is not of the effects' dimension.

        Parameters
        ----------
        effect_dim : int or None
            Dimension of the effects; None if it is not known yet.
        has_goals : bool
            Whether the environment names a sensory space.

        Examples
        --------
        >>> import divbandit as db
        >>> db.UniformGoals(db.Box([0], [1])).check(2, has_goals=True)
        Traceback (most recent call last):
            ...
        ValueError: goals' box must have the dimension of the effects, 2, got 1
        """
        if self.box is None:
            if not has_goals:
                raise ValueError(self._no_box())
        elif effect_dim is not None and self.box.dim != effect_dim:
            raise ValueError(
                "goals' box must have the dimension of the effects, "
                f"{effect_dim}, got {self.box.dim}"
            )

    def box_for(self, history: History) -> Box:
        """Return the box to draw in.

        Raises
        ------
        ValueError
            If there is none.

        Examples
        --------
        >>> import divbandit as db
        >>> history = db.History(db.Box([0], [1]), db.Box([0], [10]))
        >>> db.UniformGoals().box_for(history)
        Box([0.0], [10.0])
        """
        box = self.box if self.box is not None else history.sensory_space
        if box is None:
            raise ValueError(self._no_box())
        return box

    def _no_box(self) -> str:
        name = type(self).__name__
        return f"goals must be given a box ({name}(box=...)): there is no sensory space"

    def _arguments(self) -> list[str]:
        """Return the arguments, as they stand in a call, but for the box."""
        return []

    def __repr__(self) -> str:
        box = [] if self.box is None else [f"box={self.box!r}"]
        return f"{type(self).__name__}({', '.join([*self._arguments(), *box])})"
