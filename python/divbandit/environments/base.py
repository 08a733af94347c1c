"""Environment: what an exploration needs to know of a black box."""

from __future__ import annotations

from typing import TYPE_CHECKING, Protocol, runtime_checkable

if TYPE_CHECKING:
    from numpy.typing import ArrayLike

    from divbandit.box import BoxLike


@runtime_checkable
class Environment(Protocol):
    """A black box f: M -> S (Benureau and Oudeyer 2015).

    Any object with these three attributes will do; no base class is needed.

    Examples
    --------
    >>> import divbandit as db
    >>> class Square:
    ...     motor_space = db.Box([-1], [1])
    ...     sensory_space = db.Box([0], [1])
    ...     def __call__(self, command):
    ...         return command**2
    >>> isinstance(Square(), db.Environment)
    True
    """

    @property
    def motor_space(self) -> BoxLike:
        """M, the box of all motor commands."""

    @property
    def sensory_space(self) -> BoxLike | None:
        """A box in S to draw goals from; None if unknown."""

    def __call__(self, command: ArrayLike, /) -> ArrayLike:
        """Return the effect, shape (s,), of a command of shape (m,)."""
