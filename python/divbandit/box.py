"""Box: a product of intervals - the motor space, the sensory space, a box of goals."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Protocol

import numpy as np

from divbandit._core import Bounds, as_point
from divbandit._value import Value

if TYPE_CHECKING:
    from numpy.random import Generator
    from numpy.typing import ArrayLike, NDArray


class BoxLike(Protocol):
    """Anything with a lowest and a highest corner, such as ``gymnasium.spaces.Box``."""

    @property
    def low(self) -> ArrayLike:
        """Lowest corner."""

    @property
    def high(self) -> ArrayLike:
        """Highest corner."""


@dataclass(frozen=True, init=False, repr=False, eq=False)
class Box(Value):
    """The box of all points between two corners.

    Parameters
    ----------
    low, high : array_like, shape (dim,)
        The corners, ``low <= high`` in each coordinate, in the units of the space.

    Attributes
    ----------
    low, high : numpy.ndarray of float64, shape (dim,)
        The corners, read-only.
    bounds : object
        The same for the compiled code.

    Raises
    ------
    TypeError, ValueError
        If a corner is not a finite point, they differ in length, or ``low > high`` somewhere.

    Examples
    --------
    >>> import divbandit as db
    >>> goals = db.Box([-1, -1], [1, 1])
    >>> goals.dim
    2
    >>> goals.contains([0.5, 2.0])
    False
    """

    __slots__ = ("bounds", "high", "low")

    low: NDArray[np.float64]
    high: NDArray[np.float64]

    if TYPE_CHECKING:
        bounds: Bounds

    def __init__(self, low: ArrayLike, high: ArrayLike) -> None:
        bounds = Bounds(low, high)
        self._set(low=bounds.low, high=bounds.high, bounds=bounds)

    @classmethod
    def of(cls, value: BoxLike, *, name: str = "box") -> Box:
        """Return `value` as a Box.

        Parameters
        ----------
        value : object with ``low`` and ``high``
        name : str
            What an error calls it.

        Raises
        ------
        TypeError
            If it has no ``low`` and ``high``.
        ValueError
            If they are not the corners of a box.

        Examples
        --------
        >>> from types import SimpleNamespace
        >>> import divbandit as db
        >>> db.Box.of(SimpleNamespace(low=[0], high=[1]))
        Box([0.0], [1.0])
        """
        if isinstance(value, Box):
            return value
        if not (hasattr(value, "low") and hasattr(value, "high")):
            raise TypeError(
                f"{name} must be a Box or have .low and .high, got {type(value).__name__}"
            )
        try:
            return cls(value.low, value.high)
        except (TypeError, ValueError) as error:
            raise type(error)(f"{name}.{error}") from None

    @property
    def dim(self) -> int:
        """The number of coordinates."""
        return len(self.low)

    def sample(self, rng: Generator) -> NDArray[np.float64]:
        """Draw a point uniformly, with one ``rng.random()`` per coordinate, in order.

        Parameters
        ----------
        rng : numpy.random.Generator

        Returns
        -------
        numpy.ndarray of float64, shape (dim,)

        Raises
        ------
        TypeError
            If `rng` is not a Generator.

        Examples
        --------
        >>> import numpy as np
        >>> import divbandit as db
        >>> db.Box([0, 0], [1, 10]).sample(np.random.default_rng(0))
        array([0.63696169, 2.69786714])
        """
        return self.bounds.sample(rng)

    def sample_many(self, n: int, rng: Generator) -> NDArray[np.float64]:
        """Draw `n` points, the same as `n` calls of `sample`.

        Parameters
        ----------
        n : int
        rng : numpy.random.Generator

        Returns
        -------
        numpy.ndarray of float64, shape (n, dim)

        Raises
        ------
        TypeError, ValueError
            If `n` is not a whole number, or negative, or `rng` is not a Generator.

        Examples
        --------
        >>> import numpy as np
        >>> import divbandit as db
        >>> db.Box([0], [10]).sample_many(2, np.random.default_rng(0))
        array([[6.36961687],
               [2.69786714]])
        """
        if type(self) is Box:
            return self.bounds.sample_many(n, rng)
        # A derived class may override `sample`.
        return np.array([self.sample(rng) for _ in range(n)]).reshape(n, self.dim)

    def contains(self, point: ArrayLike) -> bool:
        """Return whether `point` lies in the box or on its boundary.

        Parameters
        ----------
        point : array_like, shape (dim,)

        Raises
        ------
        TypeError, ValueError
            If it is not a finite point of this dimension.

        Examples
        --------
        >>> import divbandit as db
        >>> db.Box([0], [1]).contains([1])
        True
        """
        x = as_point("point", point, self.dim)
        return bool(np.all((self.low <= x) & (x <= self.high)))

    def __eq__(self, other: object) -> bool:
        if not isinstance(other, Box):
            return NotImplemented
        return np.array_equal(self.low, other.low) and np.array_equal(self.high, other.high)

    def __hash__(self) -> int:
        return hash((*self.low.tolist(), *self.high.tolist()))

    def __repr__(self) -> str:
        return f"Box({self.low.tolist()}, {self.high.tolist()})"


def box_or_none(name: str, value: BoxLike | None) -> Box | None:
    """Return an optional argument as a Box, or None."""
    return None if value is None else Box.of(value, name=name)
