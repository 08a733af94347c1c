"""Box: a product of intervals - the motor space, the sensory space, a box of goals."""

from __future__ import annotations

from typing import TYPE_CHECKING, Protocol

import numpy as np

from divbandit._core import Bounds, as_point

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


class Box:
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
        The same for the compiled kernels.

    Raises
    ------
    TypeError, ValueError
        If a corner is no finite point, they differ in length, or ``low > high`` somewhere.

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

    def __init__(self, low: ArrayLike, high: ArrayLike) -> None:
        self.bounds = Bounds(low, high)
        self.low, self.high = self.bounds.low, self.bounds.high

    @classmethod
    def of(cls, value: BoxLike, *, name: str = "box") -> Box:
        """Return `value` as a Box if it is not one already.

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
            If these are no corners of a box.

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
        """Draw a point uniformly: one ``rng.random()`` a coordinate, in order.

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
        """Draw `n` points: what as many calls of `sample` draw.

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
            If `n` is no whole number, or negative, or `rng` is not a Generator.

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
        # A box of one's own may draw in another way.
        return np.array([self.sample(rng) for _ in range(n)]).reshape(n, self.dim)

    def contains(self, point: ArrayLike) -> bool:
        """Say whether `point` lies in the box, its faces included.

        Parameters
        ----------
        point : array_like, shape (dim,)

        Raises
        ------
        TypeError, ValueError
            If it is no finite point of this dimension.

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

    def __reduce__(self) -> tuple[type[Box], tuple[list[float], list[float]]]:
        return type(self), (self.low.tolist(), self.high.tolist())
