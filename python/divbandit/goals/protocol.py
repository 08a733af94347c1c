"""GoalSampler: what draws the goals of goal babbling."""

from __future__ import annotations

from typing import TYPE_CHECKING, Protocol, runtime_checkable

if TYPE_CHECKING:
    from numpy.random import Generator
    from numpy.typing import ArrayLike

    from divbandit.history import History


@runtime_checkable
class GoalSampler(Protocol):
    """Draws goals. Any object with this method will do; no base class is needed.

    A sampler may also have a method ``check(effect_dim, *, has_goals)``, called once before an
    exploration begins, that raises a ValueError where it cannot draw goals of that dimension (None
    if it is not known yet), or needs a sensory space and there is none. And it may have a method
    ``start(history)`` that returns the sampler for one exploration; without it, each exploration
    uses a copy.

    See Also
    --------
    UniformGoals, GridGoals, UncoveredGoals, FrontierGoals, NovelGoals, UntriedGoals

    Examples
    --------
    Goals near the newest effect:

    >>> import divbandit as db
    >>> class Nearby:
    ...     def sample(self, history, rng):
    ...         return history.effects[-1] + 0.1 * (rng.random(history.effect_dim) - 0.5)
    >>> isinstance(Nearby(), db.goals.GoalSampler)
    True
    >>> run = db.explore(db.PlanarArm(3), db.GoalBabbling(0.05, goals=Nearby()), n=10, rng=0)
    """

    def sample(self, history: History, rng: Generator) -> ArrayLike:
        """Return a goal.

        Parameters
        ----------
        history : History
            All that was observed so far.
        rng : numpy.random.Generator
            The only source of randomness to use.

        Returns
        -------
        array_like, shape (s,)
            A finite point of the effects' dimension.

        Examples
        --------
        >>> import numpy as np
        >>> import divbandit as db
        >>> history = db.History(db.Box([0], [1]), db.Box([0], [10]))
        >>> db.goals.UniformGoals().sample(history, np.random.default_rng(0))
        array([6.36961687])
        """
