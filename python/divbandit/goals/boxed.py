"""BoxedGoals: the base of goal samplers that can be given a box to draw in."""

from __future__ import annotations

from typing import TYPE_CHECKING

from divbandit import _core
from divbandit._value import Value
from divbandit.box import Box, BoxLike

if TYPE_CHECKING:
    import numpy as np
    from numpy.random import Generator
    from numpy.typing import NDArray

    from divbandit.history import History

#: Upper limit on draws per goal.
MOST_DRAWS = 1_000_000


class BoxedGoals(Value):
    """Goals in a box: the description of a sampler, which `start` turns into a running one.

    Attributes
    ----------
    box : Box or None
        Where goals are drawn; None for the sensory space, or what the sampler draws in instead.

    Examples
    --------
    >>> import divbandit as db
    >>> isinstance(db.goals.UniformGoals(), BoxedGoals)
    True
    """

    box: Box | None

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
        >>> db.goals.UniformGoals(db.Box([0], [1])).check(2, has_goals=True)
        Traceback (most recent call last):
            ...
        ValueError: goals' box must have the dimension of the effects, 2, got 1
        """
        if self.box is None:
            if not has_goals:
                raise ValueError(
                    "there must be a sensory space to draw goals from: give the environment one "
                    "(sensory_space=Box(low, high)), or the strategy goals=Box(low, high)"
                )
        elif effect_dim is not None and self.box.dim != effect_dim:
            raise ValueError(
                "goals' box must have the dimension of the effects, "
                f"{effect_dim}, got {self.box.dim}"
            )

    def start(self, history: History) -> _core.GoalSampler:
        """Return a running sampler, for one history.

        Parameters
        ----------
        history : History

        Returns
        -------
        object
            Has a method ``sample(history, rng)``.

        Examples
        --------
        >>> import numpy as np
        >>> import divbandit as db
        >>> history = db.History(db.Box([0], [1]), db.Box([0], [1]))
        >>> history.append([0.5], [0.6])
        >>> sampler, rng = db.goals.GridGoals(4).start(history), np.random.default_rng(0)
        >>> sorted(int(4 * sampler.sample(history, rng)[0]) for _ in range(4))
        [0, 1, 2, 3]
        """
        del history
        return _core.GoalSampler(self)

    def sample(self, history: History, rng: Generator) -> NDArray[np.float64]:
        """Draw a goal as a newly started sampler would.

        Parameters
        ----------
        history : History
        rng : numpy.random.Generator

        Returns
        -------
        numpy.ndarray of float64, shape (s,)
            Read-only.

        Raises
        ------
        ValueError
            If there is no box to draw in, or it is not of the effects' dimension; `rng` is then as
            it was.

        Examples
        --------
        >>> import numpy as np
        >>> import divbandit as db
        >>> history = db.History(db.Box([0], [1]), db.Box([0], [10]))
        >>> db.goals.UniformGoals().sample(history, np.random.default_rng(0))
        array([6.36961687])
        """
        return self.start(history).sample(history, rng)


def box_of(box: BoxLike | None) -> Box | None:
    """Return a box as a Box.

    Examples
    --------
    >>> import divbandit as db
    >>> box_of(db.Box([0], [1]))
    Box([0.0], [1.0])
    """
    return None if box is None else Box.of(box, name="box")
