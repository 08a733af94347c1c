"""Measure: what bandits and evaluations require of a measure of diversity."""

from __future__ import annotations

from typing import TYPE_CHECKING, Protocol, runtime_checkable

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import ArrayLike, NDArray


@runtime_checkable
class Measure(Protocol):
    """A way to say how diverse effects are; `start` makes a running measure of it.

    Any object with this method will do; no base class is needed. A user-defined measure is copied
    (``copy.deepcopy``, which any plain class supports) before it is started, so `start` may prepare
    the object and return it.

    See Also
    --------
    BallCoverage, CellCoverage, GridCoverage, Sparseness, Entropy

    Examples
    --------
    For effects that are single numbers in [0, 1]: how far apart the lowest and the highest of
    them are.

    >>> import numpy as np
    >>> from divbandit.measures import Measure, RunningMeasure
    >>> class Width:
    ...     dim, largest_gain, measure = 1, 1.0, 0.0
    ...     def start(self, dim):
    ...         if dim != 1:
    ...             raise ValueError(f"effects must be single numbers, got {dim} each")
    ...         self.seen = []
    ...         return self
    ...     def __len__(self):
    ...         return len(self.seen)
    ...     def gain(self, effect):
    ...         if np.ndim(effect) == 2:
    ...             return np.array([self.gain(one) for one in effect])
    ...         return float(np.ptp([*self.seen, effect[0]])) - self.measure
    ...     def add(self, effect):
    ...         gain = self.gain(effect)
    ...         self.seen.append(effect[0])
    ...         self.measure += gain
    ...         return gain
    ...     def extend(self, effects):
    ...         return np.array([self.add(one) for one in effects])
    >>> isinstance(Width(), Measure), isinstance(Width().start(1), RunningMeasure)
    (True, True)
    >>> Width().start(1).extend([[0.25], [0.75], [0.5]])
    array([0. , 0.5, 0. ])
    """

    def start(self, dim: int, /) -> RunningMeasure:
        """Return the measure of no effects.

        Parameters
        ----------
        dim : int
            Dimension of the effects, at least 1.

        Returns
        -------
        RunningMeasure

        Raises
        ------
        ValueError
            If it does not measure effects of this dimension.

        Examples
        --------
        >>> from divbandit.measures import GridCoverage
        >>> GridCoverage(0.5).start(2).extend([[0.1, 0.2], [0.2, 0.1], [0.9, 0.2]])
        array([1., 0., 1.])
        """


@runtime_checkable
class RunningMeasure(Protocol):
    """How diverse a growing set of effects is, and what one more effect adds to it: its gain.

    What the `start` of a `Measure` returns; a `Coverage` is one, too. The measure of no effects
    is 0, and of others the sum of the gains that `add` and `extend` returned for them. ``len`` of
    it is the number of effects, those that gained nothing included.

    Examples
    --------
    >>> from divbandit.measures import Entropy
    >>> entropy = Entropy(1.0).start(1)
    >>> entropy.add([0.5]), entropy.add([0.25]), entropy.measure, len(entropy)
    (0.0, 0.0, 0.0, 2)
    """

    @property
    def dim(self) -> int:
        """Dimension of the effects, at least 1."""

    @property
    def measure(self) -> float:
        """The diversity of all effects together: 0.0 for none, then the sum of the gains."""

    @property
    def largest_gain(self) -> float:
        """Upper bound of the gains; 0.0 if there is none. Finite, not negative.

        Bandits take it for the head start of each strategy.
        """

    def add(self, effect: ArrayLike, /) -> float:
        """Add an effect and return its gain: by how much the measure changes.

        Parameters
        ----------
        effect : array_like, shape (dim,)

        Returns
        -------
        float
            Finite. Negative where the effect makes all of them together less diverse.

        Raises
        ------
        TypeError, ValueError
            If it is not a finite point of this dimension; nothing is added then.

        Examples
        --------
        >>> from divbandit.measures import GridCoverage
        >>> grid = GridCoverage(0.5).start(2)
        >>> grid.add([0.1, 0.2]), grid.add([0.2, 0.1])
        (1.0, 0.0)
        """

    def extend(self, effects: ArrayLike, /) -> NDArray[np.float64]:
        """Add effects in order and return the gain of each at its turn.

        Parameters
        ----------
        effects : array_like, shape (n, dim)

        Returns
        -------
        numpy.ndarray of float64, shape (n,)
            The same numbers as from `n` calls of `add`.

        Raises
        ------
        TypeError, ValueError
            If one is not a finite point of this dimension; nothing is added then.

        Examples
        --------
        >>> from divbandit.measures import GridCoverage
        >>> GridCoverage(0.5).start(2).extend([[0.1, 0.2], [0.2, 0.1], [0.9, 0.2]])
        array([1., 0., 1.])
        """

    def gain(self, effect: ArrayLike, /) -> float | NDArray[np.float64]:
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
            If one is not a finite point of this dimension.

        Examples
        --------
        >>> from divbandit.measures import GridCoverage
        >>> grid = GridCoverage(0.5).start(2)
        >>> grid.gain([0.1, 0.2]), grid.gain([[0.1, 0.2], [0.2, 0.1]]), len(grid)
        (1.0, array([1., 1.]), 0)
        """

    def __len__(self) -> int:
        """Return how many effects were added."""
