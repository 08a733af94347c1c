"""Incremental: what the measures written in Python share - reading effects, one or many."""

from __future__ import annotations

import copy
from abc import ABC, abstractmethod
from typing import TYPE_CHECKING, Generic, TypeVar

import numpy as np

from divbandit._checks import whole
from divbandit._core import as_point
from divbandit.measures.points import many, one_or_many

if TYPE_CHECKING:
    from numpy.typing import ArrayLike, NDArray
    from typing_extensions import Self

#: What a measure makes of an effect before it looks for its gain.
Place = TypeVar("Place")

#: Effects of more coordinates than this are taken for a mistake.
_MOST = 1_000_000


class Incremental(ABC, Generic[Place]):
    """A measure whose gains are found one by one.

    A measure says where an effect lies (`_place`, which alone may refuse it), what it gains
    there (`_gain`, which changes nothing) and what remains of it (`_record`). All effects of a
    call are placed before the first is recorded, so that a refused one changes nothing.
    """

    def __init__(self, dim: int) -> None:
        self._dim = whole("dim", dim, low=1, high=_MOST)
        self._len = 0

    @abstractmethod
    def _place(self, name: str, row: int | None, effect: NDArray[np.float64]) -> Place:
        """Say where an effect lies; an error calls it `name`, or its row `row`."""

    @abstractmethod
    def _gain(self, place: Place) -> float:
        """Return what an effect gains there."""

    @abstractmethod
    def _record(self, place: Place, gain: float) -> None:
        """Add an effect that gained so much."""

    @property
    def dim(self) -> int:
        """Dimension of the effects."""
        return self._dim

    def add(self, effect: ArrayLike) -> float:
        """Add an effect and return its gain: by how much the measure changes.

        Parameters
        ----------
        effect : array_like, shape (dim,)

        Returns
        -------
        float

        Raises
        ------
        TypeError, ValueError
            If it is no finite point of this dimension, or too far away for floats to tell where
            it lies; nothing is added then.

        Examples
        --------
        >>> import divbandit as db
        >>> grid = db.GridCoverage(0.5)
        >>> grid.add([0.1, 0.2]), grid.add([0.2, 0.1])
        (1.0, 0.0)
        """
        return self._add(self._place("effect", None, as_point("effect", effect, self._dim)))

    def extend(self, effects: ArrayLike) -> NDArray[np.float64]:
        """Add effects in order and return the gain of each at its turn.

        Parameters
        ----------
        effects : array_like, shape (n, dim)

        Returns
        -------
        numpy.ndarray of float64, shape (n,)
            The very numbers that as many calls of `add` return.

        Raises
        ------
        TypeError, ValueError
            If one is not what `add` takes; nothing is added then.
        KeyboardInterrupt
            On Ctrl-C; the first so many effects are added then.

        Examples
        --------
        >>> import divbandit as db
        >>> db.GridCoverage(0.5).extend([[0.1, 0.2], [0.2, 0.1], [0.9, 0.2]])
        array([1., 0., 1.])
        """
        places = self._places("effects", many("effects", effects, self._dim))
        return np.array([self._add(place) for place in places], dtype=np.float64)

    def gain(self, effect: ArrayLike) -> float | NDArray[np.float64]:
        """Return what `add` would return; nothing is added.

        Parameters
        ----------
        effect : array_like, shape (dim,) or (n, dim)

        Returns
        -------
        float, or numpy.ndarray of float64, shape (n,)
            For many effects the gain of each by itself, as if the others were not there.

        Raises
        ------
        TypeError, ValueError
            If one is not what `add` takes.

        Examples
        --------
        >>> import divbandit as db
        >>> grid = db.GridCoverage(0.5)
        >>> grid.gain([0.1, 0.2]), grid.gain([[0.1, 0.2], [0.2, 0.1]]), len(grid)
        (1.0, array([1., 1.]), 0)
        """
        effects = one_or_many("effect", effect, self._dim)
        if effects.ndim == 1:
            return self._gain(self._place("effect", None, effects))
        places = self._places("effect", effects)
        return np.array([self._gain(place) for place in places], dtype=np.float64)

    def _places(self, name: str, effects: NDArray[np.float64]) -> list[Place]:
        return [self._place(name, row, effect) for row, effect in enumerate(effects)]

    def _add(self, place: Place) -> float:
        gain = self._gain(place)
        self._record(place, gain)
        self._len += 1
        return gain

    def __len__(self) -> int:
        return self._len

    def __copy__(self) -> Self:
        """Copy what it holds as well: a copy goes its own way."""
        other = object.__new__(type(self))
        other.__dict__.update({name: copy.copy(value) for name, value in self.__dict__.items()})
        return other
